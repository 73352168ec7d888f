#include <gmock/gmock.h>

#include <algorithm>

#include "core/vec.hpp"
#include "lumped/activation.hpp"
#include "tests/lumped/support.hpp"

namespace ostium::lumped {
namespace {

using testing::HasSubstr;

Activation activation(const std::string& yaml) {
  auto a = config::read<Activation>(config::Node::parse(yaml, "case.yaml"));
  a.prepare();
  return a;
}

std::string refused(const std::string& yaml) {
  try {
    activation(yaml);
  } catch (const UserError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Activation, HalfCosine) {
  const auto a = activation("{type: half_cosine, start: 0.2 s, duration: 0.4 s, period: 0.8 s}");
  EXPECT_EQ(a(0.1), 0);
  EXPECT_NEAR(a(0.3), 0.5, 1e-14);
  EXPECT_NEAR(a(0.4), 1, 1e-14);
  EXPECT_DOUBLE_EQ(a(0.4 + 5 * 0.8), 1);
  EXPECT_EQ(a(0.7), 0);
  const auto kinks = a.kinks(0, 1.1);
  ASSERT_EQ(kinks.size(), 3u);
  EXPECT_DOUBLE_EQ(kinks[1], 1.0);
}

/// The atrium begins in the beat before: both halves of the curve as published.
TEST(Activation, WrappingCosine) {
  const double T = 1.0169, Tsa = 0.40742 * T, end = T / 8.976868;
  const auto a = activation(
      fmt::format("{{type: wrapping_cosine, end: {} s, duration: {} s, period: {} s}}", end, Tsa, T));
  for (double t : {0.0, 0.05, 0.11, 0.2, 0.6, 0.75, 0.9, 1.01}) {
    double expected = 0;
    if (t <= end) expected = 0.5 * (1 - std::cos(2 * pi * (t - end + Tsa) / Tsa));
    if (t >= T - Tsa + end) expected = 0.5 * (1 - std::cos(2 * pi * (t - end - (T - Tsa)) / Tsa));
    EXPECT_NEAR(a(t), expected, 1e-14) << t;
    EXPECT_NEAR(a(t + 3 * T), expected, 1e-13) << t;
  }
}

TEST(Activation, PiecewiseCosineAlsoAcrossTheEndOfTheBeat) {
  const auto a = activation(
      "{type: piecewise_cosine, contract_start: 0.7 s, contract_duration: 0.2 s, relax_start: 1.0 s, "
      "relax_duration: 0.3 "
      "s, period: 0.8 s}");
  EXPECT_EQ(a(0.6), 0);
  EXPECT_NEAR(a(0.8), 0.5, 1e-14);
  EXPECT_NEAR(a(0.0), 0.5, 1e-14);
  EXPECT_EQ(a(0.15), 1);  // contracted until 0.2
  EXPECT_NEAR(a(0.35), 0.5, 1e-14);
  EXPECT_EQ(a(0.55), 0);
}

TEST(Activation, DoubleHillHasAMaximumOfOne) {
  const auto a = activation(
      "{type: double_hill, start: 0.2 s, tau_1: 0.215 s, tau_2: 0.362 s, m1: 1.32, m2: 27.4, period: 0.8 s}");
  double largest = 0;
  for (int i = 0; i < 80000; ++i) largest = std::max(largest, a(1e-5 * i));
  EXPECT_LE(largest, 1 + 1e-14);
  EXPECT_NEAR(largest, 1, 1e-8);
  const auto raw = [](double s) {
    const double g1 = std::pow(s / 0.215, 1.32), g2 = std::pow(s / 0.362, 27.4);
    return g1 / (1 + g1) / (1 + g2);
  };
  EXPECT_NEAR(a(0.4) / a(0.6), raw(0.2) / raw(0.4), 1e-12);
}

TEST(Activation, FourierIsItsSeries) {
  const auto a =
      activation("{type: fourier, mean: 0.5, cos: [0.25, 0, 0.125], sin: [0.0625], period: 0.8 s}");
  for (double t : {0.0, 0.13, 0.5, 2.1}) {
    const double x = 2 * pi * t / 0.8;
    EXPECT_NEAR(a(t), 0.5 + 0.25 * std::cos(x) + 0.125 * std::cos(3 * x) + 0.0625 * std::sin(x), 1e-14);
  }
}

TEST(Activation, VentricleGoesFromZeroToOne) {
  const auto a = activation("{type: ventricle, period: 2 s}");
  double low = 1, high = 0;
  for (int i = 0; i < 20000; ++i) low = std::min(low, a(1e-4 * i)), high = std::max(high, a(1e-4 * i));
  EXPECT_NEAR(low, 0, 1e-7);
  EXPECT_NEAR(high, 1, 1e-7);
  const auto range = ventricular_range();
  EXPECT_NEAR(range.low, 0.0511, 1e-4);
  EXPECT_NEAR(range.high, 0.9874, 1e-4);
}

TEST(Activation, Table) {
  const auto a = activation(
      "{type: table, table: {times: [0, 0.2, 0.8], time_unit: s, values: [0, 1, 0], unit: \"1\", period: 0.8 "
      "s}}");
  EXPECT_DOUBLE_EQ(a(0.1), 0.5);
  EXPECT_DOUBLE_EQ(a(1.0), 1);
}

TEST(Activation, SaysWhatIsMissingOrTooMuch) {
  EXPECT_THAT(refused("{type: half_cosine, start: 0.2 s, period: 0.8 s}"),
              HasSubstr("case.yaml:1:1: the activation \"half_cosine\" needs \"duration\""));
  EXPECT_THAT(refused("{type: ventricle, period: 0.8 s, tau_1: 1 s}"), HasSubstr("has no key \"tau_1\""));
  EXPECT_THAT(refused("{type: half_cosin, period: 0.8 s}"), HasSubstr("did you mean \"half_cosine\"?"));
  EXPECT_THAT(refused("{type: half_cosine, start: 0.2 s, duration: 1 s, period: 0.8 s}"),
              HasSubstr("\"duration\" is 1 s, longer than the period of 0.8 s"));
}

}  // namespace
}  // namespace ostium::lumped
