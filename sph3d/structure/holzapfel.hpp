/// Holzapfel-Gasser-Ogden: an artery wall, rubber with two families of stiffening fibres.
///
///   Psi = Psi_rubber(mu, K) + sum over both families k1/(2 k2) (exp(k2 e^2) - 1),   e = max(H : C - 1, 0)
///   S   = S_rubber + sum 2 k1 e exp(k2 e^2) H,                                      H = kappa I + (1 - 3 kappa) a a
///
///   mu, K   of the rubber (NeoHookean)                                  Pa
///   k1      stiffness of the fibres                                     Pa
///   k2      how fast they stiffen                                       -
///   kappa   dispersion: 0 all along a, 1/3 in all directions alike      -
///   a       direction of the family (Fibres)                            -
///   e       what the family is stretched by, squared, less one          -
///
/// H : C - 1 = kappa (tr C - 3) + (1 - 3 kappa) (a.Ca - 1). Fibres resist only tension. They are stretched by the whole of C,
/// not by its shape part: with the split they would let a sheet swell across the fibres. The law is sound up to k2 e^2 = 50.
/// Sources: Holzapfel, Gasser & Ogden 2000; Gasser, Ogden & Holzapfel 2006; for the last point Nolan et al. 2014;
/// docs/theory/materials.md. Refused by holzapfel(): moduli not positive, kappa outside [0, 1/3].
#pragma once
#include <algorithm>

#include "sph3d/structure/neo_hookean.hpp"

namespace ostium::sph3d {

struct Holzapfel {
  static constexpr const char* name = "Holzapfel-Gasser-Ogden";
  static constexpr bool has_fibres = true;
  static constexpr int thickness_iterations = 5;

  NeoHookean rubber;
  double k1, k2, kappa;

  /// Of the rubber alone, as fibres at rest are slack in compression.
  Moduli moduli() const { return rubber.moduli(); }
  /// Largest modulus of waves in a plate that is stretched by so much along both families, Pa.
  double plate_modulus(double stretch = 1.0) const;

  OSTIUM_INLINE double thinning() const { return rubber.thinning(); }

  template <class T>
  OSTIUM_INLINE Sym3<T> stress(const Sym3<T>& E, const Fibres<T>& fibres) const {
    return stress(E, fibres, inverse_cube_root(right_cauchy_green(E).determinant()));
  }
  /// With J^(-2/3) as it is known already.
  template <class T>
  OSTIUM_INLINE Sym3<T> stress(const Sym3<T>& E, const Fibres<T>& fibres, const T& over_q) const {
    Sym3<T> S = rubber.stress(E, fibres, over_q);
    for (const auto* a : {fibres.first, fibres.second}) {
      const T e = stretched(E, a);
      S += (T(2.0 * k1) * e * exponential(T(k2) * e * e)) * structure(a);
    }
    return S;
  }

  template <class T>
  OSTIUM_INLINE T energy(const Sym3<T>& E, const Fibres<T>& fibres) const {
    T psi = rubber.energy(E);
    for (const auto* a : {fibres.first, fibres.second}) {
      const T e = stretched(E, a);
      psi += T(k1 / (2.0 * k2)) * exponential_less_one(T(k2) * e * e);
    }
    return psi;
  }

  /// g = g_rubber + q a sum over both families 2 k1 kappa e exp(k2 e^2): they feel the thickness by their dispersion.
  template <class T>
  OSTIUM_INLINE VolumeStress<T> volume_stress(const Sheet<T>& sheet, const T& q, Sym3<T> E,
                                              const Fibres<T>& fibres) const {
    VolumeStress<T> g = rubber.volume_stress(sheet, q, E);
    if (kappa == 0.0) return g;
    const T a = sheet.across(q);
    E.zz = sheet.thickness_strain(q);
    for (const auto* direction : {fibres.first, fibres.second}) {
      const T e = stretched(E, direction), grown = T(2.0 * k1 * kappa) * exponential(T(k2) * e * e) * (q * a);
      g.value += grown * e;
      g.slope += grown * (T(4.0) * e + T(3.0 * kappa) * (T(1.0) + T(2.0 * k2) * e * e) * is_positive(e) * a);
    }
    return g;
  }
  template <class T>
  OSTIUM_INLINE ThicknessStress<T> thickness_stress(const Sym3<T>& E, const Fibres<T>& fibres) const {
    return by_thickness(*this, E, fibres);
  }

 private:
  template <class T>
  OSTIUM_INLINE T stretched(const Sym3<T>& E, const T* a) const {
    using std::max;
    return max(
        T(2.0 * kappa) * E.trace() + T(2.0 * (1.0 - 3.0 * kappa)) * quadratic_form(E, a[0], a[1], a[2]),
        T(0.0));
  }

  /// One where e is above zero, zero elsewhere, as a smooth ramp over 1e-12: no branch.
  template <class T>
  static OSTIUM_INLINE T is_positive(const T& e) {
    using std::min;
    return min(e * T(1e12), T(1.0));
  }

  template <class T>
  OSTIUM_INLINE Sym3<T> structure(const T* a) const {
    const T s(1.0 - 3.0 * kappa);
    Sym3<T> H{s * a[0] * a[0], s * a[1] * a[1], s * a[2] * a[2],
              s * a[0] * a[1], s * a[1] * a[2], s * a[2] * a[0]};
    return H.add_to_diagonal(T(kappa));
  }
};

struct FibreParameters {
  double k1, k2, kappa = 0.0;
};

/// Checked.
Holzapfel holzapfel(const Moduli& rubber, const FibreParameters& fibres, const char* what = "the wall");

}  // namespace ostium::sph3d
