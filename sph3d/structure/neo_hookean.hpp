/// Neo-Hookean rubber, its shape and volume parts split: nearly incompressible.
///
///   Psi = mu/2 (J^(-2/3) tr C - 3) + K/4 (J^2 - 1 - 2 ln J),   C = I + 2 E,   J^2 = det C
///   S   = mu J^(-2/3) (I - tr C / 3 C^-1) + K/2 (J^2 - 1) C^-1
///
///   E   Green strain                        -
///   S   second Piola-Kirchhoff stress       Pa
///   Psi energy per reference volume         J/m3
///
/// The volume part is the one whose stress needs no root of det C; its energy grows without bound for J -> 0 and J ->
/// infinity. Source: Simo & Hughes, Computational Inelasticity (1998), 9.2; docs/theory/materials.md.
#pragma once
#include "sph3d/structure/fibres.hpp"
#include "sph3d/structure/lane_functions.hpp"
#include "sph3d/structure/moduli.hpp"
#include "sph3d/structure/sym3.hpp"

namespace ostium::sph3d {

struct NeoHookean {
  static constexpr const char* name = "neo-Hookean";
  static constexpr bool has_fibres = false;
  static constexpr int thickness_iterations = 4;

  double mu, K;

  explicit NeoHookean(const Moduli& m) : mu(m.mu()), K(m.K()) {}

  Moduli moduli() const { return elastic_from_mu_K(mu, K); }
  /// Largest modulus of waves in a plate that is stretched by so much, Pa.
  double plate_modulus(double stretch = 1.0) const { return moduli().plate() * stretch * stretch; }

  /// nu/(1 - nu): strain across a thin sheet over that in its plane, at small strain.
  OSTIUM_INLINE double thinning() const { return (K - 2.0 / 3.0 * mu) / (K + 4.0 / 3.0 * mu); }

  template <class T>
  OSTIUM_INLINE Sym3<T> stress(const Sym3<T>& E, const Fibres<T>& = {}) const {
    const Sym3<T> C = right_cauchy_green(E), cofactor = C.cofactor();
    const T J2 = C.determinant(), inverse = T(1.0) / J2, shape = T(mu) * inverse_cube_root(J2);
    const T along_inverse = (T(0.5 * K) * (J2 - T(1.0)) - shape * C.trace() * T(1.0 / 3.0)) * inverse;
    return (along_inverse * cofactor).add_to_diagonal(shape);
  }

  template <class T>
  OSTIUM_INLINE T energy(const Sym3<T>& E, const Fibres<T>& = {}) const {
    using std::log;
    const Sym3<T> C = right_cauchy_green(E);
    const T J2 = C.determinant();
    return T(0.5 * mu) * (inverse_cube_root(J2) * C.trace() - T(3.0)) + T(0.25 * K) * (J2 - T(1.0) - log(J2));
  }

  /// S_zz / (C^-1)_zz, which is nearly linear in E_zz and rises with it everywhere, and its slope, Pa.
  template <class T>
  OSTIUM_INLINE ThicknessStress<T> thickness_stress(const Sym3<T>& E, const Fibres<T>& = {}) const {
    const Sym3<T> C = right_cauchy_green(E);
    const T area2 = C.xx * C.yy - C.xy * C.xy, J2 = C.determinant(), over = J2 / area2;  // 1 / (C^-1)_zz
    const T shape = T(mu) * inverse_cube_root(J2), third = C.trace() * T(1.0 / 3.0);
    return {shape * (over - third) + T(0.5 * K) * (J2 - T(1.0)),
            T(2.0 / 3.0) * shape * (T(1.0) + third / over) + T(K) * area2};
  }
};

}  // namespace ostium::sph3d
