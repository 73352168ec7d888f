#include "network/sobol.hpp"

#include <cmath>

#include "network/design.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

/// Of a function of parameters that are uniform in (low, high), by a Saltelli design of N base samples.
template <class F>
Sobol estimated(F f, int parameters, double low, double high, std::int64_t N, std::uint64_t seed = 1) {
  std::vector<Variation> all;
  for (int k = 0; k < parameters; ++k)
    all.push_back({.parameter = {.name = fmt::format("x{}", k), .unit = "1"}, .low = low, .high = high});
  const Design design({.sampling = Sampling::saltelli, .count = N, .seed = seed, .parameters = all});
  std::vector<double> x(static_cast<std::size_t>(parameters));
  return sobol(N, parameters, [&](std::int64_t row) {
    design.row(row, x);
    return f(x);
  });
}

double ishigami(const std::vector<double>& x) {
  const double a = std::sin(x[0]), b = std::sin(x[1]);
  return a + 7 * b * b + 0.1 * std::pow(x[2], 4) * a;
}

/// Ishigami & Homma (1990): V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2 and its parts.
struct Exact {
  double V, first[3], total[3];
};
Exact exact_ishigami() {
  const double a = 7, b = 0.1, p4 = std::pow(pi, 4), p8 = p4 * p4;
  const double V1 = 0.5 * std::pow(1 + b * p4 / 5, 2), V2 = a * a / 8,
               V13 = b * b * p8 * (1 / 18.0 - 1 / 50.0);
  const double V = V1 + V2 + V13;
  return {V, {V1 / V, V2 / V, 0}, {(V1 + V13) / V, V2 / V, V13 / V}};
}

TEST(Sobol, Ishigami) {
  const Exact e = exact_ishigami();
  EXPECT_NEAR(e.first[0], 0.3139, 1e-4);  // as tabulated in the literature
  EXPECT_NEAR(e.total[2], 0.2437, 1e-4);
  const Sobol s = estimated(ishigami, 3, -pi, pi, 40000);
  EXPECT_EQ(s.base_samples, 40000);
  EXPECT_NEAR(s.mean, 3.5, 0.05);
  EXPECT_NEAR(s.variance, e.V, 0.02 * e.V);
  for (int k = 0; k < 3; ++k) {
    const auto& i = s.parameters[static_cast<std::size_t>(k)];
    EXPECT_NEAR(i.first, e.first[k], 1.5 * i.first_half + 1e-12) << k;
    EXPECT_NEAR(i.total, e.total[k], 1.5 * i.total_half + 1e-12) << k;
    EXPECT_LT(i.first_half, 0.03);
    EXPECT_LT(i.total_half, 0.02);
  }
}

/// The intervals shrink with the root of the base samples, and 95 % of them hold the exact value.
TEST(Sobol, IntervalsHoldTheExactValue) {
  const Exact e = exact_ishigami();
  int held = 0, all = 0;
  double few = 0, many = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Sobol s = estimated(ishigami, 3, -pi, pi, 400, seed);
    for (int k = 0; k < 3; ++k) {
      const auto& i = s.parameters[static_cast<std::size_t>(k)];
      held += std::abs(i.first - e.first[k]) <= i.first_half;
      held += std::abs(i.total - e.total[k]) <= i.total_half;
      all += 2;
    }
    few += s.parameters[0].total_half;
    if (seed <= 10) many += 6 * estimated(ishigami, 3, -pi, pi, 6400, seed).parameters[0].total_half;
  }
  EXPECT_GT(held, 0.91 * all);
  EXPECT_NEAR(few / many, 4, 0.4);
}

/// f = sum of w_k x_k: S_k = T_k = w_k^2/sum w^2.
TEST(Sobol, AnAdditiveFunctionFarFromZero) {
  const Sobol s = estimated([](const auto& x) { return 1e4 + 3 * x[0] + x[1] + 0 * x[2]; }, 3, 0, 1, 20000);
  const double exact[] = {0.9, 0.1, 0};
  for (int k = 0; k < 3; ++k) {
    const auto& i = s.parameters[static_cast<std::size_t>(k)];
    EXPECT_NEAR(i.first, exact[k], 0.03);
    EXPECT_NEAR(i.total, exact[k], 0.02);
  }
  EXPECT_NEAR(s.parameters[2].total, 0, 1e-12);
}

TEST(Sobol, FailedRowsAndConstantResults) {
  int row = 0;
  const Sobol s = sobol(3, 1, [&](std::int64_t i) { return ++row, i == 4 ? NAN : double(i % 3); });
  EXPECT_EQ(s.base_samples, 2);
  const Sobol constant = sobol(10, 2, [](std::int64_t) { return 5.0; });
  EXPECT_EQ(constant.mean, 5);
  EXPECT_TRUE(std::isnan(constant.parameters[0].first));
  EXPECT_TRUE(std::isnan(constant.parameters[1].total));
  EXPECT_EQ(sobol(2, 1, [](std::int64_t) { return NAN; }).base_samples, 0);
}

}  // namespace
}  // namespace ostium::network
