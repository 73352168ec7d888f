#include "sph3d/shell/model.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "sph3d/geometry/point_grid.hpp"
#include "sph3d/shell/weights.hpp"

namespace ostium::sph3d {

namespace {

template <int D>
using Frame = Eigen::Matrix<double, D - 1, D>;

/// Neighbours of every particle in the order of memory; not across a lumen, where normals oppose each other.
template <int D>
void find_neighbours(ShellModel<D>& model) {
  const auto& cloud = model.cloud;
  const PointGrid<D> grid(cloud.position, model.kernel.reach());
  model.row_begin.assign(1, 0);
  for (std::size_t a = 0; a < model.count(); ++a) {
    const auto first = model.neighbour.size();
    grid.near(cloud.position[a], [&](int b, const Vec<D>&) {
      if (std::size_t(b) != a && cloud.normal[a].dot(cloud.normal[b]) > 0.0) model.neighbour.push_back(b);
    });
    std::sort(model.neighbour.begin() + std::ptrdiff_t(first), model.neighbour.end());
    model.row_begin.push_back(std::int64_t(model.neighbour.size()));
  }
}

template <int D>
bool clamped(const ShellCloud<D>& cloud, std::size_t a) {
  return !cloud.support.empty() && cloud.support[a] == Support::clamped;
}

template <int D>
void weigh(ShellModel<D>& model, const std::vector<Frame<D>>& frame) {
  const auto& cloud = model.cloud;
  model.forward.resize(model.neighbour.size());
  std::vector<std::uint8_t> exact(model.count());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < model.count(); ++a) {
    std::vector<TangentPoint<D>> around;
    for (auto b : model.neighbours(a)) {
      const Vec<D> apart = cloud.position[b] - cloud.position[a];
      around.push_back({frame[a] * apart, apart.norm(), cloud.area[b],
                        clamped(cloud, a) || clamped(cloud, std::size_t(b))});
    }
    exact[a] = pair_weights<D>(around, model.kernel, model.least_moment, &model.forward[model.row_begin[a]]);
  }
  model.guarded = std::size_t(std::count(exact.begin(), exact.end(), 0));
}

/// The weight of (b, a) beside that of (a, b).
template <int D>
void mirror_weights(ShellModel<D>& model) {
  model.backward.resize(model.forward.size());
  for (std::size_t a = 0; a < model.count(); ++a)
    for (auto k = model.row_begin[a]; k < model.row_begin[a + 1]; ++k) {
      const auto row = model.neighbours(std::size_t(model.neighbour[k]));
      const auto at = std::lower_bound(row.begin(), row.end(), std::int32_t(a)) - row.begin();
      model.backward[k] = model.forward[model.row_begin[model.neighbour[k]] + at];
    }
}

struct Keep {
  double velocity, along_axis, turning, leaning;
};

Keep keep_of(Support support) {
  switch (support) {
    case Support::free:
      return {1, 0, 1, 0};
    case Support::clamped:
      return {0, 0, 0, 0};
    case Support::hinged:
      return {0, 0, 1, 0};
    case Support::roller:
      return {1, -1, 1, 0};
    case Support::released:
      return {1, -1, 0, 0};
    case Support::diaphragm:
      return {0, 1, 1, 0};
    case Support::symmetric:
      return {1, -1, 1, -1};
  }
  return {1, 0, 1, 0};
}

template <int D>
void put(double (&field)[D][8], std::size_t lane, const Vec<D>& x) {
  for (int d = 0; d < D; ++d) field[d][lane] = x[d];
}

/// Discrete tangents, curvature and sums of weights: what the gradients make of the reference itself.
template <int D>
void describe_surface(const ShellModel<D>& model, const Frame<D>& e, std::size_t a, ShellReference<D>& r) {
  constexpr int T = D - 1;
  const std::size_t lane = a % 8;
  const auto& cloud = model.cloud;
  Vec<D> G[T], dN[T], hourglass = Vec<D>::Zero();
  for (int t = 0; t < T; ++t) G[t] = dN[t] = Vec<D>::Zero();
  for (auto k = model.row_begin[a]; k < model.row_begin[a + 1]; ++k) {
    const auto b = model.neighbour[k];
    const auto& weight = model.forward[k];
    const Vec<D> apart = cloud.position[b] - cloud.position[a];
    for (int t = 0; t < T; ++t) {
      G[t] += weight.gradient[t] * apart;
      dN[t] += weight.gradient[t] * (cloud.normal[b] - cloud.normal[a]);
      r.sum[t][lane] += weight.gradient[t];
    }
    hourglass += weight.hourglass * apart;
    r.hourglass_sum[lane] += weight.hourglass;
  }
  put<D>(r.N, lane, cloud.normal[a]);
  r.hourglass_turn[lane] = hourglass.dot(cloud.normal[a]);
  for (int t = 0; t < T; ++t) {
    put<D>(r.G[t], lane, G[t]);
    put<D>(r.dN[t], lane, dN[t]);
    for (int s = 0; s < T; ++s) r.curvature[t][s][lane] = dN[t].dot(e.row(s));
  }
}

template <int D>
void describe_wall(const ShellModel<D>& model, const Frame<D>& e, std::size_t a, ShellReference<D>& r) {
  const std::size_t lane = a % 8;
  const auto& cloud = model.cloud;
  const ShellOptions& o = model.options;
  const Moduli m = moduli(o.material);
  const double t = cloud.thickness[a], factor = cloud.stiffness.empty() ? 1.0 : cloud.stiffness[a];
  const double plate = factor * m.plate(), shear = factor * m.mu(), dp2 = o.spacing * o.spacing,
               h = model.kernel.h;
  r.area[lane] = cloud.area[a], r.thickness[lane] = t, r.stiffness[lane] = factor;
  r.inverse_mass[lane] = 1.0 / model.mass(a);
  r.inverse_rotary[lane] = 1.0 / (model.mass(a) * model.gyration2(a));
  r.hourglass_stiffness[0][lane] = o.hourglass * plate * t / dp2;
  r.hourglass_stiffness[1][lane] = o.hourglass / (dp2 / (shear * t) + dp2 * dp2 / (plate * t * t * t / 12.0));
  const double slow = o.damping * std::sqrt(o.density * shear),
               fast = o.damping * std::sqrt(o.density * plate);
  r.viscosity[0][lane] = t * (h * slow + 2.0 * o.viscosity);
  r.viscosity[1][lane] = t * h * (fast - slow);
  r.viscosity[2][lane] = t * (std::min(h, t) * slow + 2.0 * o.viscosity) * 5.0 / 12.0;
  r.spring[lane] = o.spring * cloud.area[a], r.dashpot[lane] = o.dashpot * cloud.area[a];
  r.face[lane] = 0.5 * o.face * t;
  const Support support = cloud.support.empty() ? Support::free : cloud.support[a];
  const Keep keep = keep_of(support);
  r.keep[0][lane] = keep.velocity, r.keep_axis[0][lane] = keep.along_axis;
  r.keep[1][lane] = keep.turning, r.keep_axis[1][lane] = keep.leaning;
  if (!cloud.axis.empty()) put<D>(r.axis, lane, cloud.axis[a]);
  if constexpr (D == 3) {
    if (cloud.circumference.empty()) return;
    const Eigen::Vector2d c = (e * cloud.circumference[a]).normalized();
    const double cosine = std::cos(o.fibre_angle), sine = std::sin(o.fibre_angle);
    for (int family = 0; family < 2; ++family) {
      const double s = family ? -sine : sine;
      r.fibre[family][0][lane] = cosine * c[0] - s * c[1];
      r.fibre[family][1][lane] = cosine * c[1] + s * c[0];
    }
  } else {
    r.fibre[0][0][lane] = r.fibre[1][0][lane] = std::cos(o.fibre_angle);
  }
}

/// A lane without a particle: nothing acts on it and it does not move, but it has a thickness to divide by.
template <int D>
void leave_empty(ShellReference<D>& r, std::size_t lane) {
  r.N[D - 1][lane] = r.thickness[lane] = 1.0;
}

void check_options(const ShellOptions& o) {
  if (!(o.spacing > 0.0)) user_error("the shell spacing is {}; it has to be positive", o.spacing);
  if (!(o.density > 0.0)) user_error("the density of the wall is {}; it has to be positive", o.density);
  const int n = o.gauss_points;
  if (n != 1 && n != 2 && n != 3 && n != 5)
    user_error("{} Gauss points through the thickness; allowed are 1, 2, 3 and 5", n);
}

}  // namespace

template <int D>
ShellModel<D>::ShellModel(ShellCloud<D> c, const ShellOptions& o) : cloud(std::move(c)), options(o) {
  sph3d::check(cloud);
  check_options(options);
  kernel.h = o.smoothing * o.spacing;
  find_neighbours(*this);
  std::vector<Frame<D>> frame(count());
  for (std::size_t a = 0; a < count(); ++a) frame[a] = tangent_frame<D>(cloud.normal[a]);
  weigh(*this, frame);
  mirror_weights(*this);
  reference.assign((count() + 7) / 8, ShellReference<D>{});
  row_begin.resize(8 * reference.size() + 1, row_begin.back());
  for (std::size_t a = 0; a < count(); ++a) {
    describe_surface(*this, frame[a], a, reference[a / 8]);
    describe_wall(*this, frame[a], a, reference[a / 8]);
  }
  for (std::size_t a = count(); a < 8 * blocks(); ++a) leave_empty(reference[a / 8], a % 8);
}

template <int D>
ShellRows<D> ShellModel<D>::rows() const {
  return {row_begin.data(), neighbour.data(), forward.data(), backward.data()};
}

template <int D>
std::span<const std::int32_t> ShellModel<D>::neighbours(std::size_t a) const {
  return {neighbour.data() + row_begin[a], neighbour.data() + row_begin[a + 1]};
}

template <int D>
double ShellModel<D>::gyration2(std::size_t a) const {
  const double t2 = cloud.thickness[a] * cloud.thickness[a];
  return (options.rotary_scaling ? std::max(t2, kernel.h * kernel.h) : t2) / 12.0;
}

template struct ShellModel<2>;
template struct ShellModel<3>;

}  // namespace ostium::sph3d
