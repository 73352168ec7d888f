/// Functions of lanes that the vector library would take one lane at a time.
///
///   inverse_cube_root(x) = x^(-1/3)    relative error below 1e-14 for 0.1 <= x <= 10
///   exponential(x)       = e^x         relative error below 2e-12 for 0 <= x <= 50
///   exponential_less_one(x) = e^x - 1  the same
///
/// The cube root: the rational start (2 + x)/(1 + 2x), exact to second order at 1, then steps of fourth order from the
/// series of (1 - r)^(-1/3), r = 1 - x y^3. The exponential: Taylor's series of x/512, then nine squarings. Both are the same
/// for a number and for lanes. Not checked: the range; beyond it both lose digits.
#pragma once
#include "sph3d/structure/sym3.hpp"

namespace ostium::sph3d {

template <class T>
OSTIUM_INLINE T inverse_cube_root(const T& x) {
  T y = (T(2.0) + x) / (T(1.0) + T(2.0) * x);
  for (int step = 0; step < 4; ++step) {
    const T r = T(1.0) - x * y * y * y;
    y += y * r * (T(1.0 / 3.0) + r * (T(2.0 / 9.0) + r * T(14.0 / 81.0)));
  }
  return y;
}

namespace exponential_detail {
inline constexpr int squarings = 9, order = 8;

/// e^t - 1 for small t.
template <class T>
OSTIUM_INLINE T series(const T& t) {
  constexpr double over_factorial[order + 1] = {1,         1,         1.0 / 2,    1.0 / 6,    1.0 / 24,
                                                1.0 / 120, 1.0 / 720, 1.0 / 5040, 1.0 / 40320};
  T m(over_factorial[order]);
  for (int k = order - 1; k >= 1; --k) m = m * t + T(over_factorial[k]);
  return m * t;
}
}  // namespace exponential_detail

template <class T>
OSTIUM_INLINE T exponential(const T& x) {
  using namespace exponential_detail;
  T power = T(1.0) + series(x * T(1.0 / (1 << squarings)));
  for (int k = 0; k < squarings; ++k) power = power * power;
  return power;
}

template <class T>
OSTIUM_INLINE T exponential_less_one(const T& x) {
  using namespace exponential_detail;
  T m = series(x * T(1.0 / (1 << squarings)));  // e^t - 1, squared as such: nothing is lost beside the one
  for (int k = 0; k < squarings; ++k) m = m * (T(2.0) + m);
  return m;
}

}  // namespace ostium::sph3d
