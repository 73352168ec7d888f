/// Saint Venant-Kirchhoff: Hooke's law between Green strain and second Piola-Kirchhoff stress.
///
///   Psi = lambda/2 (tr E)^2 + mu E : E,     S = lambda tr E I + 2 mu E
///
///   E   Green strain                        -
///   S   second Piola-Kirchhoff stress       Pa
///   Psi energy per reference volume         J/m3
///
/// For large rotations and strains up to a few percent; in strong compression it softens (the force has a maximum at the
/// stretch 1/sqrt(3)) and the volume may vanish at finite stress: then take NeoHookean. Source: docs/theory/materials.md.
#pragma once
#include "sph3d/structure/fibres.hpp"
#include "sph3d/structure/moduli.hpp"
#include "sph3d/structure/sym3.hpp"

namespace ostium::sph3d {

struct SaintVenantKirchhoff {
  static constexpr const char* name = "Saint Venant-Kirchhoff";
  static constexpr bool has_fibres = false;
  static constexpr int thickness_iterations = 1;  // S_zz is linear in E_zz

  double lambda, mu;

  explicit SaintVenantKirchhoff(const Moduli& m) : lambda(m.lambda()), mu(m.mu()) {}

  Moduli moduli() const { return elastic_from_mu_K(mu, lambda + 2.0 / 3.0 * mu); }
  /// Largest modulus of waves in a plate that is stretched by so much, Pa.
  double plate_modulus(double stretch = 1.0) const { return moduli().plate() * stretch * stretch; }

  /// nu/(1 - nu): strain across a thin sheet over that in its plane, at small strain.
  OSTIUM_INLINE double thinning() const { return lambda / (lambda + 2.0 * mu); }

  template <class T>
  OSTIUM_INLINE Sym3<T> stress(const Sym3<T>& E, const Fibres<T>& = {}) const {
    return (T(2.0 * mu) * E).add_to_diagonal(T(lambda) * E.trace());
  }

  template <class T>
  OSTIUM_INLINE T energy(const Sym3<T>& E, const Fibres<T>& = {}) const {
    const T trace = E.trace();
    return T(0.5 * lambda) * trace * trace + T(mu) * contract(E, E);
  }

  /// S_zz and its slope dS_zz/dE_zz, Pa.
  template <class T>
  OSTIUM_INLINE ThicknessStress<T> thickness_stress(const Sym3<T>& E, const Fibres<T>& = {}) const {
    return {T(lambda) * E.trace() + T(2.0 * mu) * E.zz, T(lambda + 2.0 * mu)};
  }
};

}  // namespace ostium::sph3d
