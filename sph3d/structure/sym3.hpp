/// Symmetric tensors of three dimensions, for numbers and for lanes of numbers.
///
///   component   xx, yy, zz, xy, yz, zx      of the tensor itself: no factors of two in the shear components
///
/// T is double or a vector of doubles (std::experimental::simd); everything is free of branches. Plane problems leave
/// the components out of the plane at zero. Not checked: that a tensor to be inverted can be.
/// Every function that kernels call is inlined by force: kernels are compiled once per instruction set, and a function that two
/// of them share would be one symbol to the linker, with the instructions of whichever it meets first.
#pragma once
#include <cmath>

#define OSTIUM_INLINE __attribute__((always_inline)) inline

namespace ostium::sph3d {

template <class T>
struct Sym3 {
  T xx = T(0.0), yy = T(0.0), zz = T(0.0), xy = T(0.0), yz = T(0.0), zx = T(0.0);

  OSTIUM_INLINE T trace() const { return xx + yy + zz; }
  OSTIUM_INLINE T determinant() const {
    return xx * (yy * zz - yz * yz) + xy * (yz * zx - xy * zz) + zx * (xy * yz - yy * zx);
  }
  /// The inverse times the determinant.
  OSTIUM_INLINE Sym3 cofactor() const {
    return {yy * zz - yz * yz, zz * xx - zx * zx, xx * yy - xy * xy,
            yz * zx - xy * zz, zx * xy - yz * xx, xy * yz - zx * yy};
  }
  OSTIUM_INLINE Sym3& operator+=(const Sym3& b) {
    xx += b.xx, yy += b.yy, zz += b.zz, xy += b.xy, yz += b.yz, zx += b.zx;
    return *this;
  }
  /// Adds s times the identity.
  OSTIUM_INLINE Sym3& add_to_diagonal(const T& s) {
    xx += s, yy += s, zz += s;
    return *this;
  }
};

template <class T>
OSTIUM_INLINE Sym3<T> operator*(const T& s, const Sym3<T>& a) {
  return {s * a.xx, s * a.yy, s * a.zz, s * a.xy, s * a.yz, s * a.zx};
}

template <class T>
OSTIUM_INLINE Sym3<T> operator+(Sym3<T> a, const Sym3<T>& b) {
  return a += b;
}

/// Sum over all components, a : b.
template <class T>
OSTIUM_INLINE T contract(const Sym3<T>& a, const Sym3<T>& b) {
  const T shear = a.xy * b.xy + a.yz * b.yz + a.zx * b.zx;
  return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz + shear + shear;
}

/// a . M a for the vector (x, y, z).
template <class T>
OSTIUM_INLINE T quadratic_form(const Sym3<T>& m, const T& x, const T& y, const T& z) {
  const T mixed = m.xy * x * y + m.yz * y * z + m.zx * z * x;
  return m.xx * x * x + m.yy * y * y + m.zz * z * z + mixed + mixed;
}

/// C = I + 2 E
template <class T>
OSTIUM_INLINE Sym3<T> right_cauchy_green(const Sym3<T>& green_strain) {
  return (T(2.0) * green_strain).add_to_diagonal(T(1.0));
}

/// von Mises stress sqrt(3/2 s : s), s the deviator of a Cauchy stress.
template <class T>
OSTIUM_INLINE T von_mises(Sym3<T> stress) {
  using std::sqrt;
  stress.add_to_diagonal(stress.trace() * T(-1.0 / 3.0));
  return sqrt(T(1.5) * contract(stress, stress));
}

}  // namespace ostium::sph3d
