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
#include "sph3d/structure/sheet.hpp"
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
  OSTIUM_INLINE Sym3<T> stress(const Sym3<T>& E, const Fibres<T>& fibres = {}) const {
    return stress(E, fibres, inverse_cube_root(right_cauchy_green(E).determinant()));
  }
  /// With J^(-2/3) as it is known already.
  template <class T>
  OSTIUM_INLINE Sym3<T> stress(const Sym3<T>& E, const Fibres<T>&, const T& over_q) const {
    const Sym3<T> C = right_cauchy_green(E);
    const T shape = T(mu) * over_q, inverse = over_q * over_q * over_q;  // 1 / J^2
    const T along_inverse = T(0.5 * K) * (T(1.0) - inverse) - shape * C.trace() * T(1.0 / 3.0) * inverse;
    return (along_inverse * C.cofactor()).add_to_diagonal(shape);
  }

  template <class T>
  OSTIUM_INLINE T energy(const Sym3<T>& E, const Fibres<T>& = {}) const {
    using std::log;
    const Sym3<T> C = right_cauchy_green(E);
    const T J2 = C.determinant();
    return T(0.5 * mu) * (inverse_cube_root(J2) * C.trace() - T(3.0)) + T(0.25 * K) * (J2 - T(1.0) - log(J2));
  }

  /// g = mu (2/3 a - (C_xx + C_yy + w)/3) + K/2 (q^4 - q),   a = q^3/A
  template <class T>
  OSTIUM_INLINE VolumeStress<T> volume_stress(const Sheet<T>& sheet, const T& q, const Sym3<T>& E,
                                              const Fibres<T>& = {}) const {
    const T a = sheet.across(q), q4 = q * q * q * q;
    const T third = T(1.0 / 3.0) * (T(2.0) * (T(1.0) + E.xx + E.yy) + sheet.lean);
    return {T(mu) * (T(2.0 / 3.0) * a - third) + T(0.5 * K) * (q4 - q),
            T(2.0 * mu) * a + T(0.5 * K) * (T(4.0) * q4 - q)};
  }
  template <class T>
  OSTIUM_INLINE ThicknessStress<T> thickness_stress(const Sym3<T>& E, const Fibres<T>& fibres = {}) const {
    return by_thickness(*this, E, fibres);
  }
};

}  // namespace ostium::sph3d
