/// Eight particles side by side: the one place that knows which vector library is used.
///
/// Included only by the kernel sources, which are compiled once per instruction set; everything lives in the
/// namespace of that instruction set so that no two of them can be mixed up by the linker.
#pragma once
#include <cstddef>
#include <experimental/simd>

#ifndef OSTIUM_ISA
#error "lanes.hpp belongs to the kernel sources, which define OSTIUM_ISA"
#endif

#define OSTIUM_INLINE __attribute__((always_inline)) inline
#define OSTIUM_INLINE_LAMBDA __attribute__((always_inline))

namespace ostium::sph3d::OSTIUM_ISA {

namespace stdx = std::experimental;
using Lanes = stdx::simd<float, stdx::simd_abi::deduce_t<float, 8>>;

#ifdef __AVX512VL__
constexpr bool many_registers = true;  // 32 of them, else 16
#else
constexpr bool many_registers = false;
#endif

OSTIUM_INLINE Lanes load(const float* p) { return Lanes(p, stdx::vector_aligned); }
OSTIUM_INLINE void store(const Lanes& a, float* p) { a.copy_to(p, stdx::vector_aligned); }
OSTIUM_INLINE Lanes square_root(const Lanes& a) { return stdx::sqrt(a); }
OSTIUM_INLINE Lanes least(const Lanes& a, const Lanes& b) { return stdx::min(a, b); }
OSTIUM_INLINE Lanes most(const Lanes& a, const Lanes& b) { return stdx::max(a, b); }
OSTIUM_INLINE Lanes positive_part(const Lanes& a) { return stdx::max(a, Lanes(0.0f)); }

/// Asks for memory that will be wanted soon: what is read once per cluster, after a long sum, does not come by itself.
template <class T>
OSTIUM_INLINE void prefetch(const T* object) {
  for (std::size_t line = 0; line < sizeof(T); line += 64)
    __builtin_prefetch(reinterpret_cast<const char*>(object) + line);
}

/// One bit per lane, lane 0 the lowest, where a < b.
OSTIUM_INLINE unsigned below(const Lanes& a, const Lanes& b) {
  return static_cast<unsigned>((a < b).__to_bitset().to_ulong());  // libstdc++'s own; the standard has no way
}

/// D lanes-wide numbers: a vector per particle.
template <int D>
struct VecLanes {
  Lanes c[D];

  OSTIUM_INLINE Lanes& operator[](int d) { return c[d]; }
  OSTIUM_INLINE const Lanes& operator[](int d) const { return c[d]; }

  static OSTIUM_INLINE VecLanes zero() {
    VecLanes v;
    for (int d = 0; d < D; ++d) v.c[d] = 0.0f;
    return v;
  }
  static OSTIUM_INLINE VecLanes load(const float (&p)[D][8]) {
    VecLanes v;
    for (int d = 0; d < D; ++d) v.c[d] = OSTIUM_ISA::load(p[d]);
    return v;
  }
  OSTIUM_INLINE void store(float (&p)[D][8]) const {
    for (int d = 0; d < D; ++d) OSTIUM_ISA::store(c[d], p[d]);
  }
  OSTIUM_INLINE void add(const Lanes& s, const VecLanes& a) {
    for (int d = 0; d < D; ++d) c[d] += s * a.c[d];
  }
};

template <int D>
OSTIUM_INLINE Lanes dot(const VecLanes<D>& a, const VecLanes<D>& b) {
  Lanes sum = a.c[0] * b.c[0];
  for (int d = 1; d < D; ++d) sum += a.c[d] * b.c[d];
  return sum;
}

}  // namespace ostium::sph3d::OSTIUM_ISA
