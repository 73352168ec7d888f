/// A sheet under plane stress: the strain across it is the one at which the stress across it vanishes.
///
///   S_zz(E_xx, E_yy, E_xy, E_yz, E_zx; E_zz) = 0,     thickness stretch lambda_z = sqrt(1 + 2 E_zz)
///
///   strain    Green strain in the axes of the sheet, z its normal; E_zz is found here     -
///   stress    second Piola-Kirchhoff, S_zz set to zero                                    Pa
///
/// Newton's method, a fixed number of steps per law, the same for all lanes, from nu/(1 - nu) of the strain that would
/// keep the volume: no memory of earlier steps, so the answer depends on the strain alone. Remaining stress: below 1e-8 of the shear modulus for
/// stretches between 0.7 and 1.6, with fibres for nu >= 0.45 (docs/theory/materials.md). Laws of the volume are solved for q = J^(2/3)
/// (sheet.hpp). The shear
/// correction 5/6 is the shell's own business.
#pragma once
#include "sph3d/structure/sheet.hpp"
#include "sph3d/structure/sym3.hpp"

namespace ostium::sph3d {

template <class T>
struct SheetStress {
  Sym3<T> stress, strain;

  /// By what the thickness has changed at this point.
  OSTIUM_INLINE T thickness_stretch() const {
    using std::sqrt;
    return sqrt(T(1.0) + T(2.0) * strain.zz);
  }
};

/// The strain E_zz at which det C = 1.
template <class T>
OSTIUM_INLINE T isochoric_thickness_strain(const Sym3<T>& E) {
  Sym3<T> C = right_cauchy_green(E);
  C.zz = T(0.0);
  const T area2 = C.xx * C.yy - C.xy * C.xy;
  return T(0.5) * ((T(1.0) - C.determinant()) / area2 - T(1.0));
}

/// By E_zz itself.
template <class Law, class T>
OSTIUM_INLINE SheetStress<T> plane_stress(const Law& law, Sym3<T> E, const Fibres<T>& fibres = {}) {
  E.zz = T(law.thinning()) * isochoric_thickness_strain(E);
  for (int step = 0; step < Law::thickness_iterations; ++step) {
    const ThicknessStress<T> s = law.thickness_stress(E, fibres);
    E.zz -= s.value / s.slope;
  }
  Sym3<T> S = law.stress(E, fibres);
  S.zz = T(0.0);
  return {S, E};
}

/// By q = J^(2/3), for laws of the volume.
template <class Law, class T>
requires requires { &Law::template volume_stress<T>; }
OSTIUM_INLINE SheetStress<T> plane_stress(const Law& law, Sym3<T> E, const Fibres<T>& fibres = {}) {
  const Sheet<T> sheet(E);
  T q = sheet.first_guess(law.thinning());
  for (int step = 0; step < Law::thickness_iterations; ++step)
    q = newton_step(q, law.volume_stress(sheet, q, E, fibres));
  E.zz = sheet.thickness_strain(q);
  Sym3<T> S = law.stress(E, fibres, T(1.0) / q);
  S.zz = T(0.0);
  return {S, E};
}

}  // namespace ostium::sph3d
