/// A sheet of which only the thickness is unknown, in terms of q = J^(2/3): laws of the volume then need no roots.
///
///   q^3 = det C = A (C_zz - w),   A = C_xx C_yy - C_xy^2,   w = (C_xx C_yz^2 + C_yy C_zx^2 - 2 C_xy C_yz C_zx) / A
///   1 / (C^-1)_zz = q^3 / A
///
///   q        2/3 power of the change of volume        -
///   A        square of the area's stretch             -
///   w        C_zz of a sheet without volume: what shear across it makes        -
///
/// Newton's method goes on in q^3, in which laws of the volume are nearly linear: a step from ln q to ln q + d/3 for the
/// change d of ln q^3, its root by (1 + d)^(1/3) = (3 + 2 d)/(3 + d). Source: docs/theory/materials.md.
#pragma once
#include "sph3d/structure/fibres.hpp"
#include "sph3d/structure/lane_functions.hpp"
#include "sph3d/structure/sym3.hpp"

namespace ostium::sph3d {

/// g = q S_zz / (C^-1)_zz and its derivative by ln q, Pa.
template <class T>
struct VolumeStress {
  T value, slope;
};

template <class T>
struct Sheet {
  T area2, over_area2, lean;  ///< A, 1/A, w

  OSTIUM_INLINE explicit Sheet(const Sym3<T>& E) {
    const Sym3<T> C = right_cauchy_green(E);
    area2 = C.xx * C.yy - C.xy * C.xy, over_area2 = T(1.0) / area2;
    lean = (C.xx * C.yz * C.yz + C.yy * C.zx * C.zx - T(2.0) * C.xy * C.yz * C.zx) * over_area2;
  }

  /// 1 / (C^-1)_zz
  OSTIUM_INLINE T across(const T& q) const { return q * q * q * over_area2; }
  OSTIUM_INLINE T thickness_strain(const T& q) const { return T(0.5) * (across(q) + lean - T(1.0)); }
  /// Where C_zz - 1 is `thinning` of what would keep the volume; the root to second order, exact where det C = 1.
  OSTIUM_INLINE T first_guess(double thinning) const {
    const T volume2 = T(thinning) + T(1.0 - thinning) * area2 * (T(1.0) - lean);
    return (T(1.0) + T(2.0) * volume2) / (T(2.0) + volume2);
  }
};

template <class T>
OSTIUM_INLINE T newton_step(const T& q, const VolumeStress<T>& g) {
  return q * (g.slope - T(3.0) * g.value) / (g.slope - T(2.0) * g.value);
}

/// S_zz / (C^-1)_zz, which rises with E_zz everywhere, and its slope by E_zz: (dg/dln q - g) 2 A / (3 q^4).
template <class Law, class T>
OSTIUM_INLINE ThicknessStress<T> by_thickness(const Law& law, const Sym3<T>& E, const Fibres<T>& fibres) {
  const Sheet<T> sheet(E);
  const T over_q = inverse_cube_root(right_cauchy_green(E).determinant()), q = T(1.0) / over_q;
  const auto g = law.volume_stress(sheet, q, E, fibres);
  return {g.value * over_q,
          T(2.0 / 3.0) * (g.slope - g.value) * sheet.area2 * over_q * over_q * over_q * over_q};
}

}  // namespace ostium::sph3d
