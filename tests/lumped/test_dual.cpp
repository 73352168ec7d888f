#include <gtest/gtest.h>

#include "lumped/dual.hpp"

namespace ostium::lumped {
namespace {

using D = Dual<2>;

/// Every operation at once, against the derivative found by hand and by differences.
template <class T>
T mixed(const T& x, const T& y) {
  using std::abs, std::cos, std::exp, std::log, std::pow, std::sin, std::sqrt, std::tanh;
  T r = sqrt(x * y) + exp(-x) / y - log(y) * sin(x) + cos(x * 2.0) - tanh(y - 3.0 * x) + pow(x, 2.5) +
        abs(x - y);
  r += x;
  r *= y;
  r -= 1.0;
  r /= x + 2.0;
  return r;
}

TEST(Dual, AgreesWithCentralDifferences) {
  for (double x : {0.3, 1.7})
    for (double y : {0.4, 2.9}) {
      const D d = mixed(D::variable(x, 0), D::variable(y, 1));
      const double h = 1e-6;
      EXPECT_DOUBLE_EQ(d.v, mixed(x, y));
      EXPECT_NEAR(d.d[0], (mixed(x + h, y) - mixed(x - h, y)) / (2 * h), 1e-7);
      EXPECT_NEAR(d.d[1], (mixed(x, y + h) - mixed(x, y - h)) / (2 * h), 1e-7);
    }
}

TEST(Dual, ProductAndQuotientRule) {
  const D x = D::variable(3, 0), y = D::variable(2, 1);
  EXPECT_EQ((x * y).d, (std::array<double, 2>{2, 3}));
  EXPECT_EQ((x / y).d, (std::array<double, 2>{0.5, -0.75}));
  EXPECT_EQ((5.0 - x).d, (std::array<double, 2>{-1, 0}));
  EXPECT_TRUE(y < x && x > 2.5 && x <= 3.0 && x >= y);
}

}  // namespace
}  // namespace ostium::lumped
