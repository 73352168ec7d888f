#include "network/sweep.hpp"

#include <cmath>

#include "network/sobol.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

using testing::HasSubstr;
using Law = Variation::Law;

const double q0 = 90e-6, q1 = 60e-6;  // m3/s: mean and amplitude of the source
const std::string source =
    "in: {type: flow_source, to: A, flow: {fourier: {mean: 90, cos: [-60]}, unit: mL/s, period: 1 s}}\n";
const std::string rcr =
    source + "bed: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 3e-9 m3/Pa, Rd: 4e8 Pa.s/m3}\n";
const StudyRun periodic{.end = 1, .every = 0.01, .period = 1, .initial = Initial::periodic};
const StudyRun from_rest{.end = 2, .every = 0.01, .period = 1, .initial = Initial::rest};

Variation varied(const Model& m, const std::string& name, double low, double high, Law law = Law::uniform) {
  return {.parameter = parameter(m, name, "here"), .law = law, .low = low, .high = high};
}

std::vector<Index> indices(const Model& m, const std::vector<std::string>& texts) {
  std::vector<Index> all;
  for (const auto& text : texts) all.push_back(read_index(text, Network(m).series_names(), "here"));
  return all;
}

std::vector<SampleResult> run(Sweep& sweep, std::int64_t first = 0, std::int64_t stride = 1) {
  return sweep.run(first, sweep.design().rows(), stride, [] { return false; });
}

std::vector<double> row(const Design& d, std::int64_t i) {
  std::vector<double> values(static_cast<std::size_t>(d.columns()));
  d.row(i, values);
  return values;
}

/// Mean and pulse of the pressure at a Windkessel are q0 (Rp + Rd) and 2 q1 |Z(2 pi)|.
TEST(Sweep, WindkesselsInClosedForm) {
  const Model m = model(rcr);
  Sweep sweep(m,
              Design({.sampling = Sampling::latin_hypercube,
                      .count = 40,
                      .parameters = {varied(m, "bed.Rd", 5e7, 5e8), varied(m, "bed.Rp", 1e6, 5e7),
                                     varied(m, "bed.C", 1e-9, 1e-8, Law::log_uniform)}}),
              indices(m, {"mean p:A", "pulse p:A", "stroke_volume q:bed"}), periodic, 1);
  const auto all = run(sweep);
  for (std::int64_t i = 0; i < 40; ++i) {
    const auto p = row(sweep.design(), i);
    const double Rd = p[0], Rp = p[1], C = p[2], mean = q0 * (Rp + Rd);
    const double pulse = 2 * q1 * std::abs(Rp + Rd / std::complex<double>(1, 2 * pi * Rd * C));
    const auto& s = all[static_cast<std::size_t>(i)];
    ASSERT_EQ(s.outcome, Outcome::ok) << s.reason;
    EXPECT_NEAR(s.results[0], mean, 1e-9 * mean);
    EXPECT_NEAR(s.results[1], pulse, 5e-4 * pulse);  // 100 rows a period: (pi/100)^2/2
    EXPECT_NEAR(s.results[2], q0, 1e-9 * q0);
  }
}

/// A divider of two resistances: P = q0 (R1 + R2), so that the indices of the mean are shares of Var R.
TEST(Sweep, SobolIndicesOfADivider) {
  const Model m = model(source +
                        "r1: {type: resistor, from: A, to: B, R: 1e8 Pa.s/m3}\n"
                        "r2: {type: resistor, from: B, ground: 0 Pa, R: 3e8 Pa.s/m3}\n");
  const std::int64_t N = 500;
  Sweep sweep(m,
              Design({.sampling = Sampling::saltelli,
                      .count = N,
                      .parameters = {varied(m, "r1.R", 1e8, 2e8), varied(m, "r2.R", 1e8, 4e8)}}),
              indices(m, {"mean p:A"}), {.end = 1, .every = 0.1}, 2);
  const auto all = run(sweep);
  const Sobol s = sobol(N, 2, [&](std::int64_t i) { return all[static_cast<std::size_t>(i)].results[0]; });
  const double exact[] = {0.1, 0.9};
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_NEAR(s.parameters[k].first, exact[k], 1.5 * s.parameters[k].first_half);
    EXPECT_NEAR(s.parameters[k].total, exact[k], 1.5 * s.parameters[k].total_half);
  }
}

/// Neither threads nor what a study has run before change a bit, of linear networks and of one with valves.
TEST(Sweep, SameBitsForAnyThreadsAndOrder) {
  const std::string valve =
      rcr +
      "wire: {type: resistor, from: A, to: B, R: 1e7 Pa.s/m3}\n"
      "way: {type: valve, from: B, to: D, R: 1e6 Pa.s/m3}\n"
      "tank: {type: windkessel, from: D, Rp: 1e7 Pa.s/m3, C: 3e-9 m3/Pa, Rd: 4e8 Pa.s/m3}\n";
  for (const auto& [yaml, how] : {std::pair(rcr, periodic), std::pair(rcr, from_rest),
                                  std::pair(valve, periodic), std::pair(valve, from_rest)}) {
    const Model m = model(yaml);
    const Design design({.sampling = Sampling::random,
                         .count = 12,
                         .parameters = {varied(m, "bed.Rd", 5e7, 5e8), varied(m, "bed.C", 1e-9, 1e-8)}});
    const auto wanted = indices(m, {"mean p:A", "max p:A"});
    Sweep one(m, design, wanted, how, 1), three(m, design, wanted, how, 3);
    const auto a = run(one), b = run(three), odd = run(three, 1, 2);
    ASSERT_EQ(a.size(), 12u);
    ASSERT_EQ(odd.size(), 6u);
    for (std::size_t i = 0; i < 12; ++i) {
      ASSERT_EQ(a[i].outcome, Outcome::ok) << a[i].reason;
      EXPECT_EQ(a[i].results, b[i].results);
      if (i % 2 == 1) {
        EXPECT_EQ(a[i].results, odd[i / 2].results);
      }
      Study alone(m, design.parameters(), wanted, how);
      std::vector<double> results(2);
      alone.run(row(design, static_cast<std::int64_t>(i)), results);
      EXPECT_EQ(a[i].results, results);
    }
  }
}

/// The results are those of a run of the same network read with these values.
TEST(Sweep, AsARunFromTheCase) {
  const auto bed = [](double Rd) {
    return source + fmt::format(
                        "bed: {{type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 3e-9 m3/Pa, Rd: {} "
                        "Pa.s/m3}}\n",
                        Rd);
  };
  const Model m = model(bed(4e8));
  Study study(m, {parameter(m, "bed.Rd", "here")}, indices(m, {"max p:A", "min p:A", "mean p:A"}), from_rest);
  for (const double Rd : {1e8, 3e8}) {
    std::vector<double> found(3);
    study.run(std::vector{Rd}, found);
    double max = -1e300, min = 1e300, sum = 0, last = 0;
    simulate(model(bed(Rd)), {.end = 2, .every = 0.01},
             {.begin = [](const auto&) {},
              .row =
                  [&](double t, std::span<const double> y) {
                    if (t < 1 - 1e-9) return true;
                    max = std::max(max, y[0]), min = std::min(min, y[0]);
                    if (t > 1 + 1e-9) sum += 0.005 * (last + y[0]);
                    last = y[0];
                    return true;
                  }});
    EXPECT_NEAR(found[0], max, 1e-9 * max);
    EXPECT_NEAR(found[1], min, 1e-9 * max);
    EXPECT_NEAR(found[2], sum, 1e-9 * max);
  }
}

/// A sample without result keeps nobody from going on, and says why.
TEST(Sweep, SamplesWithoutResult) {
  const Model m = model(source +
                        "r1: {type: resistor, from: A, ground: 0 Pa, R: 1e8 Pa.s/m3}\n"
                        "r2: {type: resistor, from: A, ground: 0 Pa, R: 3e8 Pa.s/m3}\n");
  Variation factor = varied(m, "in.flow.factor", 0, 0, Law::listed), R = varied(m, "r1.R", 0, 0, Law::listed);
  factor.values = {1, 0, 1, 1}, R.values = {1e8, 1e8, -1, 3e8};
  Sweep sweep(m, Design({.sampling = Sampling::table, .parameters = {factor, R}}),
              indices(m, {"flow_split q:r1 / q:in"}), {.end = 1, .every = 0.1}, 1);
  const auto all = run(sweep);
  ASSERT_EQ(all.size(), 4u);
  EXPECT_NEAR(all[0].results[0], 0.75, 1e-12);
  EXPECT_EQ(all[1].outcome, Outcome::failed);
  EXPECT_THAT(all[1].reason, HasSubstr("the result \"flow_split q:r1 / q:in\" is"));
  EXPECT_TRUE(std::isnan(all[1].results[0]));
  EXPECT_EQ(all[2].outcome, Outcome::refused);
  EXPECT_THAT(all[2].reason, HasSubstr("r1.R is -1 Pa.s/m3, and must be"));
  EXPECT_NEAR(all[3].results[0], 0.5, 1e-12);
}

TEST(Sweep, WhatHasNotBegunStaysOpen) {
  const Model m = model(rcr);
  const Design design({.count = 10, .parameters = {varied(m, "bed.Rd", 5e7, 5e8)}});
  Sweep sweep(m, design, indices(m, {"mean p:A"}), periodic, 1);
  int asked = 0;
  const auto all = sweep.run(0, 10, 1, [&] { return ++asked > 4; });
  for (std::size_t i = 0; i < 10; ++i) EXPECT_EQ(all[i].outcome, i < 4 ? Outcome::ok : Outcome::open);
}

TEST(Sweep, AChangedPeriodHasNoPeriodicState) {
  const Model m = model(rcr);
  try {
    Study(m, {{.name = "in.flow.period", .unit = "s"}}, {}, periodic);
    FAIL();
  } catch (const UserError& e) {
    EXPECT_THAT(e.what(), HasSubstr("in.flow.period is the period of a source"));
  }
}

}  // namespace
}  // namespace ostium::network
