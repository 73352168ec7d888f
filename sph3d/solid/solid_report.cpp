#include "sph3d/solid/solid_report.hpp"

#include "sph3d/solid/solid_step.hpp"

namespace ostium::sph3d {

namespace {

using Full = Eigen::Matrix3d;

Sym3<double> symmetric(const Full& m) { return {m(0, 0), m(1, 1), m(2, 2), m(0, 1), m(1, 2), m(2, 0)}; }

Full matrix(const Sym3<double>& s) {
  Full m;
  m << s.xx, s.xy, s.zx, s.xy, s.yy, s.yz, s.zx, s.yz, s.zz;
  return m;
}

template <int D>
Sym3<double> green_strain(const Mat<D>& F) {
  Full E = Full::Zero();
  const Mat<D> H = F - Mat<D>::Identity();  // small strains keep their digits
  E.topLeftCorner<D, D>() = 0.5 * (H + H.transpose() + H.transpose() * H);
  return symmetric(E);
}

template <int D>
double hourglass_energy(const SolidModel<D>& m, const std::vector<Vec<D>>& u, std::size_t a,
                        const Mat<D>& F) {
  const Mat<D> H = F - Mat<D>::Identity();
  double sum = 0.0;
  for (auto k = m.row[a]; k < m.row[a + 1]; ++k) {
    const std::int32_t b = m.neighbour[k];
    const Vec<D> apart = m.cloud.position[b] - m.cloud.position[a];
    sum += pair_gradient(m, k).norm() / apart.norm() * (u[b] - u[a] - H * apart).squaredNorm();
  }
  const double modulus = m.options.hourglass * moduli(m.options.material).mu() * m.stiffness_of(a);
  return 0.5 * modulus * m.cloud.volume[a] * sum;
}

template <int D>
double strain_energy(const SolidModel<D>& m, std::size_t a, const Mat<D>& F) {
  const double density = std::visit(
      [&](const auto& law) { return law.energy(green_strain<D>(F), m.fibres_of(a)); }, m.options.material);
  return m.cloud.volume[a] * m.stiffness_of(a) * density;
}

}  // namespace

template <int D>
SolidEnergy energy(const SolidModel<D>& m, const SolidState<D>& state) {
  SolidEnergy e;
  for (std::size_t a = 0; a < m.count(); ++a) {
    const Mat<D> F = deformation_gradient(m, state.displacement, a);
    e.kinetic += 0.5 * m.mass(a) * state.velocity[a].squaredNorm();
    e.strain += strain_energy(m, a, F);
    e.hourglass += hourglass_energy(m, state.displacement, a, F);
  }
  return e;
}

template <int D>
double strain_energy(const SolidModel<D>& m, const SolidState<D>& state, std::size_t a) {
  return strain_energy(m, a, deformation_gradient(m, state.displacement, a));
}

template <int D>
Sym3<double> cauchy_stress(const SolidModel<D>& m, const SolidState<D>& state, std::size_t a) {
  Full F = Full::Identity();
  F.topLeftCorner<D, D>() = deformation_gradient(m, state.displacement, a);
  const auto E = green_strain<3>(F);
  const auto S =
      std::visit([&](const auto& law) { return law.stress(E, m.fibres_of(a)); }, m.options.material);
  return symmetric(F * matrix(m.stiffness_of(a) * S) * F.transpose() / F.determinant());
}

template SolidEnergy energy(const SolidModel<2>&, const SolidState<2>&);
template SolidEnergy energy(const SolidModel<3>&, const SolidState<3>&);
template double strain_energy(const SolidModel<2>&, const SolidState<2>&, std::size_t);
template double strain_energy(const SolidModel<3>&, const SolidState<3>&, std::size_t);
template Sym3<double> cauchy_stress(const SolidModel<2>&, const SolidState<2>&, std::size_t);
template Sym3<double> cauchy_stress(const SolidModel<3>&, const SolidState<3>&, std::size_t);

}  // namespace ostium::sph3d
