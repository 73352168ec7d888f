/// Energy and tractions of a shell from its strains, by Gauss points through the thickness.
///
///   Psi = integral of psi(E(chi)) det(I + chi curvature) d chi,    -t/2 <= chi <= t/2                   J/m2
///   tractions: n = dPsi/dE, m = dPsi/dK, l = dPsi/dL, q = dPsi/dg                                       N/m, N, N m, N/m
///
///   strains, curvature   see strain.hpp
///   thickness            t of the reference                                                             m
///
/// Plane stress at each point (structure/plane_stress.hpp). The transverse shear enters the law times sqrt(5/6), once in the
/// strain and once in the traction, so that the tractions remain derivatives of an energy and the stiffness is 5/6 of
/// the material's. Not checked: points other than 1, 2, 3, 5.
#pragma once
#include "sph3d/shell/strain.hpp"

namespace ostium::sph3d {

struct GaussPoints {
  int count;
  double place[5], weight[5];  // on [-1, 1]
};

inline const GaussPoints& gauss_points(int count) {
  static constexpr GaussPoints one{1, {0.0}, {2.0}};
  static constexpr GaussPoints two{2, {-0.57735026918962576, 0.57735026918962576}, {1.0, 1.0}};
  static constexpr GaussPoints three{
      3, {-0.77459666924148338, 0.0, 0.77459666924148338}, {5.0 / 9, 8.0 / 9, 5.0 / 9}};
  static constexpr GaussPoints five{
      5,
      {-0.90617984593866399, -0.53846931010568309, 0.0, 0.53846931010568309, 0.90617984593866399},
      {0.23692688505618909, 0.47862867049936647, 0.56888888888888889, 0.47862867049936647,
       0.23692688505618909}};
  return count == 1 ? one : count == 2 ? two : count == 3 ? three : five;
}

inline constexpr double root_shear_correction = 0.91287092917527686;  // sqrt(5/6)

/// Strain in the orthonormal frame at chi, z along the normal.
template <int T, class S>
[[gnu::always_inline]] inline Sym3<S> strain_at(const ShellStrains<T, S>& e, const Shifter<T, S>& z,
                                                const S& chi) {
  Sym<T, S> convected;
  for (int k = 0; k < T * (T + 1) / 2; ++k)
    convected.c[k] = e.membrane.c[k] + chi * (e.bending.c[k] + chi * e.second.c[k]);
  const Sym<T, S> E = to_frame<T, S>(z, convected);
  S shear[2] = {S(0.0), S(0.0)};
  for (int a = 0; a < T; ++a)
    for (int b = 0; b < T; ++b) shear[a] += S(0.5 * root_shear_correction) * z.inverse[a][b] * e.shear[b];
  Sym3<S> strain;
  strain.xx = E(0, 0), strain.zx = shear[0];
  if constexpr (T == 2) strain.yy = E(1, 1), strain.xy = E(0, 1), strain.yz = shear[1];
  return strain;
}

/// Adds what the stress at chi, times its share of the thickness, gives to the tractions.
template <int T, class S>
[[gnu::always_inline]] inline void add_tractions(const Sym3<S>& stress, const Shifter<T, S>& z, const S& chi,
                                                 const S& share, ShellStrains<T, S>& out) {
  const S plane[2][2] = {{stress.xx, stress.xy}, {stress.xy, stress.yy}}, across[2] = {stress.zx, stress.yz};
  for (int a = 0; a < T; ++a) {
    for (int b = a; b < T; ++b) {
      S s(0.0);
      for (int c = 0; c < T; ++c)
        for (int d = 0; d < T; ++d) s += plane[c][d] * z.inverse[c][a] * z.inverse[d][b];
      s *= share;
      out.membrane(a, b) += s;
      out.bending(a, b) += chi * s;
      out.second(a, b) += chi * chi * s;
    }
    S q(0.0);
    for (int c = 0; c < T; ++c) q += across[c] * z.inverse[c][a];
    out.shear[a] += S(root_shear_correction) * share * q;
  }
}

/// f(z, chi, share) for every Gauss point; share: its part of the thickness, volume included.
template <int T, class S, class F>
[[gnu::always_inline]] inline void through_thickness(const S (&curvature)[T][T], const S& thickness,
                                                     int points, F f) {
  const GaussPoints& gauss = gauss_points(points);
  for (int g = 0; g < gauss.count; ++g) {
    const S chi = S(0.5 * gauss.place[g]) * thickness;
    const Shifter<T, S> z = shifter<T, S>(curvature, chi);
    f(z, chi, S(0.5 * gauss.weight[g]) * thickness * z.volume);
  }
}

template <int T, class S>
ShellStrains<T, S> no_strains() {
  ShellStrains<T, S> none;
  for (int k = 0; k < T * (T + 1) / 2; ++k)
    none.membrane.c[k] = none.bending.c[k] = none.second.c[k] = S(0.0);
  for (int a = 0; a < T; ++a) none.shear[a] = S(0.0);
  return none;
}

template <int T, class S, class Law>
[[gnu::always_inline]] inline ShellStrains<T, S> tractions(const Law& law, const Fibres<S>& fibres,
                                                           const ShellStrains<T, S>& strains,
                                                           const S (&curvature)[T][T], const S& thickness,
                                                           int points) {
  ShellStrains<T, S> out = no_strains<T, S>();
  through_thickness<T, S>(curvature, thickness, points,
                          [&](const Shifter<T, S>& z, const S& chi, const S& share) [[gnu::always_inline]] {
                            const auto sheet = plane_stress(law, strain_at<T, S>(strains, z, chi), fibres);
                            add_tractions<T, S>(sheet.stress, z, chi, share, out);
                          });
  return out;
}

/// J/m2 of the reference mid-surface.
template <int T, class Law>
double shell_energy(const Law& law, const Fibres<double>& fibres, const ShellStrains<T, double>& strains,
                    const double (&curvature)[T][T], double thickness, int points) {
  double sum = 0.0;
  through_thickness<T, double>(
      curvature, thickness, points, [&](const Shifter<T, double>& z, double chi, double share) {
        const auto sheet = plane_stress(law, strain_at<T, double>(strains, z, chi), fibres);
        sum += share * law.energy(sheet.strain, fibres);
      });
  return sum;
}

}  // namespace ostium::sph3d
