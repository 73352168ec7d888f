#include "network/calibrate.hpp"

#include <cmath>

#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

using testing::HasSubstr;

const double q0 = 90e-6, q1 = 60e-6;  // m3/s: mean and amplitude of the source
const std::string source =
    "in: {type: flow_source, to: A, flow: {fourier: {mean: 90, cos: [-60]}, unit: mL/s, period: 1 s}}\n";
const std::string rcr =
    source + "bed: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 3e-9 m3/Pa, Rd: 4e8 Pa.s/m3}\n";
const SensitivityRun periodic{.end = 1, .period = 1, .initial = Initial::periodic};

Target target(const Model& m, const std::string& text, double value, double tolerance, double weight = 1) {
  return {read_index(text, Network(m).series_names(), "case.yaml:1:1"), value, tolerance, weight};
}

FreeParameter between(const Model& m, const std::string& name, double low, double high,
                      bool logarithmic = true) {
  return {parameter(m, name, "case.yaml:1:1"), low, high, logarithmic};
}

/// Mean and pulse of the pressure at a Windkessel are q0 (Rp + Rd) and 2 q1 |Z(2 pi)|.
TEST(Calibrate, WindkesselFromMeanAndPulse) {
  const double Rp = 1e7, C = 1e-8, Rd = 1.5e8, w = 2 * pi;
  const double pulse = 2 * q1 * std::abs(Rp + Rd / std::complex<double>(1, w * Rd * C));
  const Model m = model(rcr);
  for (const bool logarithmic : {true, false}) {
    const auto c = calibrate(
        m, {target(m, "mean p:A", q0 * (Rp + Rd), 130), target(m, "pulse p:A", pulse, 130)},
        {between(m, "bed.Rd", 1e7, 1e9, logarithmic), between(m, "bed.C", 1e-10, 1e-7, logarithmic)},
        periodic);
    EXPECT_NEAR(c.values[0], Rd, 1e-5 * Rd);
    EXPECT_NEAR(c.values[1], C, 1e-5 * C);
    EXPECT_NEAR(c.before[0], q0 * 4.1e8, 1e-4 * q0 * 4.1e8);
    EXPECT_NEAR(c.after[1], pulse, 1e-4 * pulse);
    EXPECT_LT(c.misfit, 1e-3);
    EXPECT_LE(c.runs, 15);
    EXPECT_TRUE(c.correlations.empty());
    Network n(c.model);  // the model has the values
    EXPECT_NEAR(parameter(c.model, "bed.Rd", "").value, c.values[0], 1e-12 * Rd);
  }
}

/// Two resistances in series: one pressure says their sum only.
TEST(Calibrate, WhatTheTargetsDoNotTell) {
  const Model m = model(source +
                        "r1: {type: resistor, from: A, to: B, R: 1e8 Pa.s/m3}\n"
                        "r2: {type: resistor, from: B, ground: 0 Pa, R: 3e8 Pa.s/m3}\n");
  const auto c = calibrate(m, {target(m, "mean p:A", q0 * 5e8, 100)},
                           {between(m, "r1.R", 1e6, 1e10), between(m, "r2.R", 1e6, 1e10)}, periodic);
  EXPECT_NEAR(c.values[0] + c.values[1], 5e8, 1e-5 * 5e8);
  ASSERT_EQ(c.singular_values.size(), 2);
  const double expected =
      q0 * std::hypot(c.values[0], c.values[1]) / 100;  // d(mean)/d ln R over the tolerance
  EXPECT_NEAR(c.singular_values[0], expected, 1e-4 * expected);
  EXPECT_LT(c.singular_values[1], Calibration::undetermined);
  EXPECT_NEAR(std::abs(c.directions(0, 1) / c.directions(1, 1)), c.values[1] / c.values[0], 1e-3);
  EXPECT_TRUE(std::isinf(c.uncertainty[0]));
  ASSERT_EQ(c.correlations.size(), 1u);
  EXPECT_NEAR(c.correlations[0].value, -1, 1e-6);
}

/// Targets that contradict each other: the weighted mean.
TEST(Calibrate, WeightsAndUncertainty) {
  const Model m = model(rcr);
  const double first = q0 * 2e8, second = q0 * 3e8;
  const auto c = calibrate(m, {target(m, "mean p:A", first, 100), target(m, "mean p:A", second, 100, 3)},
                           {between(m, "bed.Rd", 1e7, 1e9)}, periodic);
  const double sum = (first + 3 * second) / 4 / q0;
  EXPECT_NEAR(c.values[0], sum - 1e7, 1e-5 * sum);
  EXPECT_NEAR(c.residuals[0], (q0 * sum - first) / 100, 1e-3);
  EXPECT_NEAR(c.uncertainty[0], 100 / (2 * q0 * c.values[0]), 1e-4);  // J = (1, sqrt 3) q0 Rd/100
}

TEST(Calibrate, BoundsHold) {
  const Model m = model(rcr);
  const auto c =
      calibrate(m, {target(m, "mean p:A", q0 * 1.1e9, 100)}, {between(m, "bed.Rd", 1e8, 6e8)}, periodic);
  EXPECT_NEAR(c.values[0], 6e8, 1);
  EXPECT_TRUE(c.at_bound[0]);
  EXPECT_EQ(c.stopped, "steps are small");
}

std::string refusal(double low, double high, bool logarithmic, double tolerance = 100) {
  const Model m = model(rcr);
  try {
    calibrate(m, {target(m, "mean p:A", 1e4, tolerance)}, {between(m, "bed.Rd", low, high, logarithmic)},
              periodic);
  } catch (const UserError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Calibrate, Refusals) {
  EXPECT_THAT(refusal(1e9, 1e8, true),
              HasSubstr("bed.Rd: low is 1e+09 and high 1e+08 Pa.s/m3; low must be below high"));
  EXPECT_THAT(refusal(0, 1e9, true),
              HasSubstr("a logarithmic scale needs low > 0; raise it, or choose `scale: linear`"));
  EXPECT_THAT(refusal(1e7, 1e8, true),
              HasSubstr("bed.Rd starts at 4e+08 Pa.s/m3, outside its bounds 1e+07 .. 1e+08"));
  EXPECT_THAT(refusal(1e7, 1e9, true, 0),
              HasSubstr("\"mean p:A\" has the tolerance 0 and the weight 1; both must be > 0"));
  EXPECT_THAT(refusal(-1e7, 1e9, false), HasSubstr("bed.Rd is -1e+07 Pa.s/m3, and must be"));
}

}  // namespace
}  // namespace ostium::network
