#include "core/waveform.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "errors.hpp"

namespace ostium {
namespace {

using test::error_of;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double tau = 2 * std::numbers::pi;

Waveform triangle(Interpolation kind = Interpolation::linear) {
  return Waveform::table({{0, 0.25, 0.75}, {0, 1, -1}, 1.0, kind});
}

TEST(Waveform, Constant) {
  const Waveform w = Waveform::constant(3);
  EXPECT_EQ(w(-1e9), 3);
  EXPECT_EQ(w.derivative(5), 0);
  EXPECT_EQ(w.mean(), 3);
  EXPECT_EQ(w.integral(1, 3), 6);
  EXPECT_TRUE(w.kinks(0, 10).empty());
  EXPECT_EQ(Waveform()(1.0), 0);
}

TEST(Waveform, LinearTableClosesOverThePeriod) {
  const Waveform w = triangle();
  EXPECT_DOUBLE_EQ(w(0.125), 0.5);
  EXPECT_DOUBLE_EQ(w(0.5), 0);
  EXPECT_NEAR(w(0.875), -0.5, 1e-15);
  EXPECT_NEAR(w(7.125), 0.5, 1e-12);
  EXPECT_NEAR(w(-0.125), -0.5, 1e-12);
  EXPECT_DOUBLE_EQ(w.derivative(0.3), -4);
  EXPECT_NEAR(w.mean(), 0, 1e-16);
  EXPECT_EQ(w.max(), 1);
  EXPECT_EQ(w.min(), -1);
}

TEST(Waveform, TableNotBeginningAtZero) {
  const Waveform w = Waveform::table({{0.1, 0.6}, {1, 2}, 1.0, Interpolation::linear});
  EXPECT_DOUBLE_EQ(w(0.1), 1);
  EXPECT_DOUBLE_EQ(w(0.35), 1.5);
  EXPECT_NEAR(w(0.85), 1.5, 1e-12);
  EXPECT_NEAR(w(0.0), 1.2, 1e-12);
}

TEST(Waveform, LastSampleOnePeriodLaterIsTheFirst) {
  const Waveform w = Waveform::table({{0, 0.5, 1.0}, {1, 2, 1.001}, 1.0, Interpolation::linear});
  EXPECT_DOUBLE_EQ(w(1.0), 1);
  EXPECT_DOUBLE_EQ(w(0.75), 1.5);
}

TEST(Waveform, NotPeriodicHoldsItsEnds) {
  const Waveform w = Waveform::table({{1, 2}, {10, 20}, 0, Interpolation::linear});
  EXPECT_EQ(w(0), 10);
  EXPECT_EQ(w(5), 20);
  EXPECT_EQ(w.derivative(0), 0);
  EXPECT_EQ(w.derivative(1.5), 10);
  EXPECT_EQ(w.derivative(3), 0);
  EXPECT_DOUBLE_EQ(w.integral(0, 3), 10 + 15 + 20);
  EXPECT_THAT(w.kinks(0, 5), ElementsAre(1, 2));
}

TEST(Waveform, KinksWhereTheSlopeJumps) {
  EXPECT_THAT(triangle().kinks(0, 2), ElementsAre(0.25, 0.75, 1.25, 1.75));  // at 0 the slope goes on
  EXPECT_THAT(triangle().kinks(0.25, 0.75), ElementsAre());
  EXPECT_THAT(triangle().kinks(-0.5, 0.3), ElementsAre(-0.25, 0.25));
  EXPECT_TRUE(triangle(Interpolation::monotone_cubic).kinks(0, 2).empty());
}

TEST(Waveform, DerivativeAndIntegralAgreeWithTheValue) {
  for (const Waveform& w : {triangle(), triangle(Interpolation::monotone_cubic),
                            Waveform::fourier({1.5, {1, -0.3}, {0.2, 0.7}, 0.8})}) {
    const double h = 1e-6;
    for (double t : {-1.37, 0.05, 0.31, 0.62, 2.91}) {
      EXPECT_NEAR(w.derivative(t), (w(t + h) - w(t - h)) / (2 * h), 1e-6);
      EXPECT_NEAR(w(t), w.integral(t - h, t + h) / (2 * h), 1e-6);
    }
    EXPECT_NEAR(w.integral(0.3, 0.3 + 3 * w.period()), 3 * w.period() * w.mean(), 1e-12);
  }
}

TEST(Waveform, MonotoneCubicIsMonotoneAndConverges) {
  double error[2];
  for (int level = 0; level < 2; ++level) {
    const int n = 40 << level;
    Waveform::Table table{{}, {}, 1.0, Interpolation::monotone_cubic};
    for (int i = 0; i < n; ++i)
      table.times.push_back(1.0 * i / n), table.values.push_back(std::sin(tau * i / n));
    const Waveform w = Waveform::table(table);
    error[level] = 0;
    for (double t = 0.1; t < 0.15; t += 1e-4)
      error[level] = std::max(error[level], std::abs(w(t) - std::sin(tau * t)));
  }
  EXPECT_GT(std::log2(error[0] / error[1]), 1.9);  // second order and better away from the extremes
  const Waveform step = Waveform::table({{0, 1, 2, 3}, {0, 0, 1, 1}, 0, Interpolation::monotone_cubic});
  for (double t = 0; t < 3; t += 0.01) {
    EXPECT_GE(step.derivative(t), -1e-14);
    EXPECT_GE(step(t), 0);
    EXPECT_LE(step(t), 1);
  }
}

TEST(Waveform, FourierSeries) {
  const Waveform w = Waveform::fourier({2, {3}, {4}, 0.5});
  EXPECT_DOUBLE_EQ(w(0), 5);
  EXPECT_NEAR(w(0.125), 6, 1e-14);
  EXPECT_EQ(w.mean(), 2);
  EXPECT_NEAR(w.max(), 7, 1e-12);
  EXPECT_NEAR(w.min(), -3, 1e-12);
}

TEST(Waveform, FourierOfATriangleMatchesItsSeries) {
  // sin_n of the triangle: 8/pi^2 (-1)^((n-1)/2) / n^2 for odd n
  const auto series =
      Waveform::fourier_of({{0, 0.25, 0.75}, {0, 1, -1}, 1.0, Interpolation::linear}, 5).series();
  const double a = 8 / (std::numbers::pi * std::numbers::pi);
  EXPECT_THAT(series.sin, ElementsAre(testing::DoubleNear(a, 1e-14), testing::DoubleNear(0, 1e-14),
                                      testing::DoubleNear(-a / 9, 1e-14), testing::DoubleNear(0, 1e-14),
                                      testing::DoubleNear(a / 25, 1e-14)));
  for (double c : series.cos) EXPECT_NEAR(c, 0, 1e-14);
}

TEST(Waveform, ScaledAndDelayed) {
  for (const Waveform& w : {triangle(), Waveform::fourier({1, {2}, {3}, 1})})
    for (double t : {0.1, 0.6, 1.3}) {
      EXPECT_NEAR(w.scaled(-2)(t), -2 * w(t), 1e-14);
      EXPECT_NEAR(w.delayed(0.2)(t), w(t - 0.2), 1e-12);
    }
}

TEST(Waveform, RoundingAtTheEndOfAPeriod) {
  const Waveform w = Waveform::table({{0, 0.33, 0.66}, {1, 2, 1}, 0.66, Interpolation::linear});
  for (int n = 0; n < 2000; ++n) EXPECT_NEAR(w(0.66 * n), 1, 1e-8);
}

TEST(WaveformErrors, Texts) {
  using T = Waveform::Table;
  EXPECT_EQ(error_of([] {
              Waveform::table(T{{0, 0.2, 0.1}, {1, 2, 3}});
            }),
            "row 3: the time 0.1 s does not come after 0.2 s of the row before; times must increase");
  EXPECT_THAT(error_of([] {
                Waveform::table(T{{0, 0}, {1, 2}});
              }),
              HasSubstr("row 2: the time 0 s does not come after"));
  EXPECT_EQ(error_of([] {
              Waveform::table(T{{0, 1}, {1, NAN}});
            }),
            "row 2: the value nan is not a finite number");
  EXPECT_EQ(error_of([] {
              Waveform::table(T{{0, INFINITY}, {1, 2}});
            }),
            "row 2: the time inf is not a finite number");
  EXPECT_EQ(error_of([] { Waveform::table(T{{0}, {1}}); }), "a waveform needs at least two samples, found 1");
  EXPECT_EQ(error_of([] { Waveform::table(T{{0, 1}, {1}}); }), "there are 2 times but 1 values");
  EXPECT_EQ(error_of([] {
              Waveform::table(T{{0, 0.7}, {1, 2}, 0.66});
            }),
            "the samples span 0.7 s, more than the period of 0.66 s; correct the period or cut the table");
  EXPECT_EQ(error_of([] { Waveform::fourier({1, {}, {}, 0}); }), "a Fourier series needs a period > 0");
  EXPECT_EQ(error_of([] {
              Waveform::fourier({1, {1, NAN}, {}, 1});
            }),
            "harmonic 2 of the Fourier series is not finite");
}

}  // namespace
}  // namespace ostium
