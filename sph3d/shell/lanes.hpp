/// Doubles side by side, for the shell's kernels: as many as a register holds.
///
/// Included only by the kernel sources, which are compiled once per instruction set. The number of lanes tells the instruction
/// sets apart: templates over Lanes, wherever they stand, are other functions for each of them, which the linker cannot mix up.
#pragma once
#include <experimental/simd>

#ifndef OSTIUM_ISA
#error "lanes.hpp belongs to the kernel sources, which define OSTIUM_ISA"
#endif

#define OSTIUM_INLINE __attribute__((always_inline)) inline

namespace ostium::sph3d::OSTIUM_ISA {

namespace stdx = std::experimental;
using Lanes = stdx::native_simd<double>;
inline constexpr int width = Lanes::size();
static_assert(8 % width == 0);

OSTIUM_INLINE Lanes load(const double* p) { return Lanes(p, stdx::vector_aligned); }
OSTIUM_INLINE void store(const Lanes& a, double* p) { a.copy_to(p, stdx::vector_aligned); }

/// The two vectors of one particle, a cache line.
struct Line {
  Lanes c[8 / width];

  OSTIUM_INLINE Line() {
    for (auto& part : c) part = 0.0;
  }
  OSTIUM_INLINE void add(double s, const double* p) {
    for (int k = 0; k < 8 / width; ++k) c[k] += s * OSTIUM_ISA::load(p + k * width);
  }
  OSTIUM_INLINE void add(double s, const Line& a) {
    for (int k = 0; k < 8 / width; ++k) c[k] += s * a.c[k];
  }
  OSTIUM_INLINE void store(double* p) const {
    for (int k = 0; k < 8 / width; ++k) OSTIUM_ISA::store(c[k], p + k * width);
  }
};

/// One vector for each of several particles.
template <int D>
struct Vector {
  Lanes c[D];

  OSTIUM_INLINE Lanes& operator[](int d) { return c[d]; }
  OSTIUM_INLINE const Lanes& operator[](int d) const { return c[d]; }

  static OSTIUM_INLINE Vector zero() {
    Vector v;
    for (int d = 0; d < D; ++d) v.c[d] = 0.0;
    return v;
  }
  /// Of the particles from lane `at` of a block on.
  static OSTIUM_INLINE Vector load(const double (&p)[D][8], int at) {
    Vector v;
    for (int d = 0; d < D; ++d) v.c[d] = OSTIUM_ISA::load(p[d] + at);
    return v;
  }
  OSTIUM_INLINE void store(double (&p)[D][8], int at) const {
    for (int d = 0; d < D; ++d) OSTIUM_ISA::store(c[d], p[d] + at);
  }
  OSTIUM_INLINE Vector& add(const Lanes& s, const Vector& a) {
    for (int d = 0; d < D; ++d) c[d] += s * a.c[d];
    return *this;
  }
};

template <int D>
OSTIUM_INLINE Vector<D> operator+(Vector<D> a, const Vector<D>& b) {
  for (int d = 0; d < D; ++d) a.c[d] += b.c[d];
  return a;
}
template <int D>
OSTIUM_INLINE Vector<D> operator-(Vector<D> a, const Vector<D>& b) {
  for (int d = 0; d < D; ++d) a.c[d] -= b.c[d];
  return a;
}
template <int D>
OSTIUM_INLINE Vector<D> operator*(const Lanes& s, Vector<D> a) {
  for (int d = 0; d < D; ++d) a.c[d] *= s;
  return a;
}
template <int D>
OSTIUM_INLINE Lanes dot(const Vector<D>& a, const Vector<D>& b) {
  Lanes sum = a.c[0] * b.c[0];
  for (int d = 1; d < D; ++d) sum += a.c[d] * b.c[d];
  return sum;
}

/// Components first, first + 1, ... of the rows of the particles from lane `at` on.
template <int D>
OSTIUM_INLINE Vector<D> columns(const double (&rows)[8][8], int first, int at) {
  Vector<D> v;
  for (int d = 0; d < D; ++d) v.c[d] = Lanes([&](auto lane) { return rows[at + lane][first + d]; });
  return v;
}

}  // namespace ostium::sph3d::OSTIUM_ISA
