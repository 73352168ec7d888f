#include "sph3d/solid/solid_model.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sph3d/geometry/point_grid.hpp"

namespace ostium::sph3d {

namespace {

void check(const SolidOptions& o) {
  if (!(o.density > 0.0)) user_error("The density of a solid must be positive; found {:g} kg/m3.", o.density);
  if (!(o.spacing > 0.0))
    user_error("The spacing of a solid's particles must be positive; found {:g} m.", o.spacing);
  if (!(o.hourglass >= 0.0 && o.damping >= 0.0))
    user_error("Hourglass control and damping of a solid cannot be negative; found {:g} and {:g}.",
               o.hourglass, o.damping);
}

template <int D>
void check(const SolidCloud<D>& cloud, const Material& material) {
  const std::size_t n = cloud.count();
  const auto fits = [&](std::size_t size) { return size == 0 || size == n; };
  OSTIUM_ASSERT(n > 0 && cloud.volume.size() == n, "{} volumes of {} particles", cloud.volume.size(), n);
  OSTIUM_ASSERT(fits(cloud.held.size()) && fits(cloud.stiffness.size()) && fits(cloud.fibres.size()),
                "held {}, stiffness {}, fibres {} of {} particles", cloud.held.size(), cloud.stiffness.size(),
                cloud.fibres.size(), n);
  std::visit(
      [&](const auto& law) {
        if (law.has_fibres && cloud.fibres.empty())
          user_error("The law {} needs the directions of its fibres at every particle; none are given.",
                     law.name);
      },
      material);
}

constexpr double wanted_spread = 0.15, least_spread = 0.03;

/// The kernel of a pair, that of the wider of the two: the same seen from both sides.
template <int D>
Wendland<D> pair_kernel(const SolidModel<D>& m, std::size_t a, std::size_t b) {
  return {std::max(m.smoothing[a], m.smoothing[b])};
}

template <int D>
void find_neighbours(SolidModel<D>& m) {
  const auto& X = m.cloud.position;
  const PointGrid<D> grid(X, 2.0 * *std::max_element(m.smoothing.begin(), m.smoothing.end()));
  std::vector<std::int32_t> found;
  m.row = {0}, m.neighbour.clear();
  for (std::size_t a = 0; a < m.count(); ++a) {
    found.clear();
    grid.near(X[a], [&](int b, const Vec<D>& apart) {
      if (b != static_cast<int>(a) && apart.norm() < pair_kernel(m, a, b).reach()) found.push_back(b);
    });
    std::sort(found.begin(), found.end());
    m.neighbour.insert(m.neighbour.end(), found.begin(), found.end());
    m.row.push_back(static_cast<std::int64_t>(m.neighbour.size()));
  }
}

template <int D>
void weigh_pairs(SolidModel<D>& m) {
  const double spring = m.options.hourglass * moduli(m.options.material).mu();
  m.weight.resize((D + 1) * m.pairs());
  for (std::size_t a = 0; a < m.count(); ++a)
    for (auto k = m.row[a]; k < m.row[a + 1]; ++k) {
      const auto b = static_cast<std::size_t>(m.neighbour[k]);
      const Vec<D> apart = m.cloud.position[b] - m.cloud.position[a];
      const double s = -pair_kernel(m, a, b).slope(apart.norm()) / apart.norm() * m.cloud.volume[b];
      Eigen::Map<Vec<D>>(&m.weight[(D + 1) * k]) = s * apart;
      m.weight[(D + 1) * k + D] = spring * (m.stiffness_of(a) + m.stiffness_of(b)) * s;
    }
}

template <int D>
Mat<D> moments(const SolidModel<D>& m, std::size_t a) {
  Mat<D> M = Mat<D>::Zero();
  for (auto k = m.row[a]; k < m.row[a + 1]; ++k)
    M += (m.cloud.position[m.neighbour[k]] - m.cloud.position[a]) * pair_gradient(m, k).transpose();
  return M;
}

/// How well the neighbours of a particle surround it: about 1 in the bulk, 0 when they lie in a line or a plane.
template <int D>
double spread(const SolidModel<D>& m, std::size_t a) {
  return Eigen::SelfAdjointEigenSolver<Mat<D>>(moments(m, a)).eigenvalues()[0];
}

template <int D>
[[noreturn]] void refuse(const SolidModel<D>& m, std::size_t a) {
  const Vec<D>& x = m.cloud.position[a];
  user_error(
      "The solid's particle at ({:g}, {:g}, {:g}) m has {} neighbours, too few on one side to tell how it "
      "deforms. A "
      "wall needs four layers of particles or more: refine the spacing of {:g} m.",
      x[0], x[1], D == 3 ? x[D - 1] : 0.0, m.row[a + 1] - m.row[a], m.options.spacing);
}

/// Particles on irregular edges with few neighbours see farther.
template <int D>
void connect(SolidModel<D>& m) {
  constexpr int tries = 4;
  m.smoothing.assign(m.count(), m.kernel.h);
  for (int k = 0; k < tries; ++k) {
    find_neighbours(m), weigh_pairs(m);
    const double wanted = k + 1 < tries ? wanted_spread : least_spread;
    bool all = true;
    for (std::size_t a = 0; a < m.count(); ++a) {
      if (spread(m, a) > wanted) continue;
      if (k + 1 == tries) refuse(m, a);
      m.smoothing[a] *= 1.15, all = false;
    }
    if (all) return;
  }
}

template <int D>
void correct(SolidModel<D>& m) {
  constexpr std::size_t L = SolidModel<D>::lanes;
  m.correction.assign(D * D * L * m.groups(), 0.0);
  for (std::size_t a = 0; a < m.count(); ++a) {
    const Mat<D> B = moments(m, a).inverse();
    for (int i = 0; i < D * D; ++i) m.correction[(a / L * D * D + i) * L + a % L] = B.data()[i];
  }
}

template <int D>
void lay_out_particles(SolidModel<D>& m) {
  constexpr std::size_t L = SolidModel<D>::lanes;
  m.factor.assign(L * m.groups(), 0.0);
  for (std::size_t a = 0; a < m.count(); ++a) m.factor[a] = m.stiffness_of(a);
  m.fibre.assign(m.cloud.fibres.empty() ? 0 : 6 * L * m.groups(), 0.0);
  for (std::size_t a = 0; a < m.cloud.fibres.size(); ++a)
    for (int d = 0; d < 3; ++d) {
      m.fibre[(a / L * 6 + d) * L + a % L] = m.cloud.fibres[a].first[d];
      m.fibre[(a / L * 6 + 3 + d) * L + a % L] = m.cloud.fibres[a].second[d];
    }
}

}  // namespace

template <int D>
Mat<D> SolidModel<D>::correction_of(std::size_t a) const {
  Mat<D> B;
  for (int i = 0; i < D * D; ++i) B.data()[i] = correction[(a / lanes * D * D + i) * lanes + a % lanes];
  return B;
}

template <int D>
SolidModel<D> make_solid(SolidCloud<D> cloud, const SolidOptions& options) {
  check(options), check(cloud, options.material);
  SolidModel<D> m;
  m.cloud = std::move(cloud), m.options = options, m.kernel = {options.spacing};
  // Shear waves, not pressure waves, are what rings: the damping scales with the speed in a plate.
  m.viscosity = options.damping * options.density * m.kernel.h *
                wave_speed(moduli(options.material).plate(), options.density);
  connect(m), correct(m), lay_out_particles(m);
  return m;
}

template struct SolidModel<2>;
template struct SolidModel<3>;
template SolidModel<2> make_solid(SolidCloud<2>, const SolidOptions&);
template SolidModel<3> make_solid(SolidCloud<3>, const SolidOptions&);

}  // namespace ostium::sph3d
