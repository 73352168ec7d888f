#include "sph3d/shell/recover.hpp"

#include "sph3d/shell/linear_shell.hpp"
#include "sph3d/shell/through_thickness.hpp"

namespace ostium::sph3d {

namespace {

template <int D>
Fibres<double> fibres_at(const ShellReference<D>& r, std::size_t lane) {
  Fibres<double> fibres;
  for (int t = 0; t < D - 1; ++t)
    fibres.first[t] = r.fibre[0][t][lane], fibres.second[t] = r.fibre[1][t][lane];
  return fibres;
}

Eigen::Matrix3d full(const Sym3<double>& s) {
  return Eigen::Matrix3d{{s.xx, s.xy, s.zx}, {s.xy, s.yy, s.yz}, {s.zx, s.yz, s.zz}};
}

/// Base vectors of the orthonormal reference frame at chi after the deformation: F e_1, F e_2, F N.
template <int D>
Eigen::Matrix3d deformed_frame(const ShellPoint<D>& point, const Shifter<D - 1, double>& z, double chi,
                               double stretch) {
  Eigen::Matrix3d F = Eigen::Matrix3d::Zero();
  for (int c = 0; c < D - 1; ++c)
    for (int a = 0; a < D - 1; ++a)
      F.col(c).template head<D>() += z.inverse[c][a] * (point.x[a] + chi * point.dn[a]);
  if constexpr (D == 2) F(2, 1) = 1.0;  // the direction out of the plane is the second of the sheet
  F.col(2).template head<D>() += stretch * point.n;
  return F;
}

}  // namespace

template <int D>
ShellPoint<D>::ShellPoint(const ShellModel<D>& model, const ShellState<D>& state, std::size_t a) {
  const auto& r = model.reference[a / 8];
  const std::size_t lane = a % 8;
  Vec<D> du[T], dd[T];
  for (int t = 0; t < T; ++t) du[t] = dd[t] = Vec<D>::Zero();
  zigzag = Vec<D>::Zero();
  n = state.normal(a);
  const Vec<D> turned = n - model.cloud.normal[a];
  for (auto k = model.row_begin[a]; k < model.row_begin[a + 1]; ++k) {
    const auto b = std::size_t(model.neighbour[k]);
    const Vec<D> apart = state.displacement(b) - state.displacement(a);
    for (int t = 0; t < T; ++t) {
      du[t] += model.forward[k].gradient[t] * apart;
      dd[t] += model.forward[k].gradient[t] * (state.normal(b) - model.cloud.normal[b] - turned);
    }
    zigzag += model.forward[k].hourglass * apart;
  }
  zigzag -= r.hourglass_turn[lane] * turned;
  for (int t = 0; t < T; ++t) x[t] = at<D>(r.G[t], lane) + du[t], dn[t] = at<D>(r.dN[t], lane) + dd[t];
  for (int i = 0; i < T; ++i) {
    const Vec<D> Gi = at<D>(r.G[i], lane), dNi = at<D>(r.dN[i], lane);
    for (int j = i; j < T; ++j) {
      const Vec<D> Gj = at<D>(r.G[j], lane);
      strains.membrane(i, j) = 0.5 * (Gi.dot(du[j]) + du[i].dot(Gj + du[j]));
      strains.bending(i, j) = 0.5 * (Gi.dot(dd[j]) + du[i].dot(dn[j]) + Gj.dot(dd[i]) + du[j].dot(dn[i]));
      strains.second(i, j) = 0.5 * (dNi.dot(dd[j]) + dd[i].dot(dn[j]));
    }
    strains.shear[i] = du[i].dot(n) + Gi.dot(turned);
    for (int j = 0; j < T; ++j) curvature[i][j] = r.curvature[i][j][lane];
  }
}

template <int D>
Vec<D> ShellPoint<D>::geometric_normal() const {
  if constexpr (D == 2)
    return Vec<2>(-x[0][1], x[0][0]).normalized();
  else
    return x[0].cross(x[1]).normalized();
}

template <int D>
double ShellPoint<D>::area_stretch() const {
  if constexpr (D == 2)
    return x[0].norm();
  else
    return x[0].cross(x[1]).norm();
}

template <int D>
double WallStress<D>::von_mises() const {
  const Eigen::Matrix3d deviator = cauchy - cauchy.trace() / 3.0 * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

template <int D>
WallStress<D> wall_stress(const ShellModel<D>& model, const ShellState<D>& state, std::size_t a,
                          double zeta) {
  const ShellPoint<D> point(model, state, a);
  const auto& r = model.reference[a / 8];
  const std::size_t lane = a % 8;
  const double chi = 0.5 * zeta * r.thickness[lane];
  const auto z = shifter<D - 1, double>(point.curvature, chi);
  const auto strain = strain_at<D - 1, double>(point.strains, z, chi);
  return std::visit(
      [&](const auto& law) {
        const auto sheet = plane_stress(law, strain, fibres_at<D>(r, lane));
        const double stretch = sheet.thickness_stretch();
        const Eigen::Matrix3d F = deformed_frame<D>(point, z, chi, stretch);
        const double J = std::sqrt((F.transpose() * F).determinant());
        Sym3<double> S = r.stiffness[lane] * sheet.stress;
        if (!model.prestress.empty()) S += hooke_at<D>(model, model.prestress.prestrain[a], z, a, chi);
        return WallStress<D>{1.0 / J * F * full(S) * F.transpose(), stretch};
      },
      model.options.material);
}

namespace {

/// Work of the tractions of the reference along the strains, and of the force on zigzags.
template <int D>
double held_energy(const ShellModel<D>& model, const ShellPoint<D>& point, std::size_t a) {
  constexpr int T = D - 1, P = tangent_pairs<D>;
  if (model.prestress.empty()) return 0.0;
  const auto& held = model.prestress.blocks[a / 8];
  const std::size_t lane = a % 8;
  const auto& e = point.strains;
  double sum = 0.0;
  for (int i = 0; i < T; ++i) {
    for (int j = 0; j < T; ++j) {
      const int k = Sym<T, double>::index(i, j);
      sum += held.traction[k][lane] * e.membrane.c[k] + held.traction[P + k][lane] * e.bending.c[k] +
             held.traction[2 * P + k][lane] * e.second.c[k];
    }
    sum += held.traction[3 * P + i][lane] * e.shear[i];
  }
  return sum;
}

template <int D>
double held_zigzag_energy(const ShellModel<D>& model, const ShellPoint<D>& point, std::size_t a) {
  if (model.prestress.empty()) return 0.0;
  const auto& held = model.prestress.blocks[a / 8];
  double sum = held.zigzag[0][a % 8] * point.zigzag.dot(point.n);
  for (int t = 0; t + 1 < D; ++t) sum += held.zigzag[1 + t][a % 8] * point.zigzag.dot(point.x[t]);
  return sum;
}

}  // namespace

template <int D>
double surface_energy(const ShellModel<D>& model, const ShellState<D>& state, std::size_t a) {
  const ShellPoint<D> point(model, state, a);
  const auto& r = model.reference[a / 8];
  const std::size_t lane = a % 8;
  return held_energy(model, point, a) +
         r.stiffness[lane] * std::visit(
                                 [&](const auto& law) {
                                   return shell_energy<D - 1>(law, fibres_at<D>(r, lane), point.strains,
                                                              point.curvature, r.thickness[lane],
                                                              model.options.gauss_points);
                                 },
                                 model.options.material);
}

template <int D>
ShellEnergies energies(const ShellModel<D>& model, const ShellState<D>& state) {
  ShellEnergies sum;
  for (std::size_t a = 0; a < model.count(); ++a) {
    const auto& r = model.reference[a / 8];
    const ShellPoint<D> point(model, state, a);
    const double within = r.hourglass_stiffness[0][a % 8], across = r.hourglass_stiffness[1][a % 8] - within;
    const double lift = point.zigzag.dot(point.n);
    sum.strain += model.cloud.area[a] * surface_energy(model, state, a);
    sum.zigzag += 0.5 * model.cloud.area[a] * (within * point.zigzag.squaredNorm() + across * lift * lift) +
                  model.cloud.area[a] * held_zigzag_energy(model, point, a);
    sum.motion += 0.5 * model.mass(a) * state.velocity(a).squaredNorm();
    sum.rotation += 0.5 * model.mass(a) * model.gyration2(a) * state.normal_rate(a).squaredNorm();
  }
  return sum;
}

template struct ShellPoint<2>;
template struct ShellPoint<3>;
template struct WallStress<2>;
template struct WallStress<3>;
template WallStress<2> wall_stress(const ShellModel<2>&, const ShellState<2>&, std::size_t, double);
template WallStress<3> wall_stress(const ShellModel<3>&, const ShellState<3>&, std::size_t, double);
template double surface_energy(const ShellModel<2>&, const ShellState<2>&, std::size_t);
template double surface_energy(const ShellModel<3>&, const ShellState<3>&, std::size_t);
template ShellEnergies energies(const ShellModel<2>&, const ShellState<2>&);
template ShellEnergies energies(const ShellModel<3>&, const ShellState<3>&);

}  // namespace ostium::sph3d
