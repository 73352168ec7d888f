#include "network/periodic.hpp"
#include "network/system.hpp"
#include "tests/network/closed_loop.hpp"

namespace ostium::network {
namespace {

/// Largest change of a state over a further period, over its scale: by the integrator without sensitivities.
double change_over_a_period(const std::string& yaml, const Start& start, double period) {
  Network n(model(yaml));
  n.load(start.state);
  n.advance(period, {}, {});
  const System system(model(yaml), {});
  double worst = 0;
  for (int j : system.states())
    worst = std::max(worst, std::abs(n.save().y[j] - start.state.y[j]) / system.scale()[j]);
  return worst;
}

TEST(Shooting, ClosedLoopHeartWithCoronariesInAtMostFourCycles) {
  const Start s = periodic_start(model(closed_loop), {}, 0.8);
  EXPECT_EQ(s.report.method, "newton");
  EXPECT_LE(s.report.cycle_integrations, 4);
  EXPECT_EQ(s.report.invariants, 1);
  EXPECT_LT(change_over_a_period(closed_loop, s, 0.8), 1e-6);
  RecordProperty("cycle_integrations", s.report.cycle_integrations);
  RecordProperty("change_over_a_period", std::to_string(change_over_a_period(closed_loop, s, 0.8)));
}

/// The periodic state is the one that has the blood of the start, and where the beats go by themselves.
TEST(Shooting, ClosedLoopKeepsItsVolumeAndIsWhereTheBeatsGo) {
  const Start s = periodic_start(model(closed_loop), {}, 0.8);
  Network beats(model(closed_loop)), periodic(model(closed_loop));
  const double volume = blood(beats);
  periodic.load(s.state);
  EXPECT_NEAR(blood(periodic), volume, 1e-10 * volume);
  run_to(beats, 80);  // 100 beats
  EXPECT_NEAR(blood(beats), volume, 1e-10 * volume);
  const System system(model(closed_loop), {});
  for (int j : system.states())
    EXPECT_NEAR(beats.save().y[j], s.state.y[j], 1e-6 * system.scale()[j]) << system.names()[j];
}

TEST(Shooting, LinearNetworksInTwoCycles) {
  const std::string yaml =
      "in: {type: flow_source, to: A, flow: {fourier: {mean: 90, cos: [-60]}, unit: mL/s, period: 1 s}}\n"
      "bed: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1.5e9 Pa.s/m3}\n";  // 15 s
  const Start s = periodic_start(model(yaml), {}, 1);
  EXPECT_EQ(s.report.method, "exact");
  EXPECT_LE(s.report.cycle_integrations, 2);
  EXPECT_EQ(s.report.invariants, 0);
  ASSERT_EQ(s.report.residuals.size(), 1u);
  EXPECT_EQ(s.report.residuals[0].state, "p:bed.Pc_Pa");
  EXPECT_LT(std::abs(s.report.residuals[0].change), 1e-6);
}

/// A source of mean zero into a compliance adds nothing over a period: the mean of the pressure is that of the start.
TEST(Shooting, SourceWithoutMeanKeepsTheLevelOfTheStart) {
  const std::string yaml =
      "in: {type: flow_source, to: A, flow: {fourier: {mean: 0, cos: [60]}, unit: mL/s, period: 1 s}}\n"
      "c: {type: capacitor, from: A, C: 1e-8 m3/Pa, initial_pressure: 70 mmHg}\n";
  const Start s = periodic_start(model(yaml), {}, 1);
  EXPECT_EQ(s.report.invariants, 1);
  Network n(model(yaml));
  n.load(s.state);
  EXPECT_NEAR(series(n, "p:A_Pa"), 70 * 133.322387415, 1e-6);
  run_to(n, 0.25);
  EXPECT_NEAR(series(n, "p:A_Pa"), 70 * 133.322387415 + 60e-6 / 1e-8 / (2 * pi), 1e-6);
}

std::string ladder(int n, const std::string& K) {
  std::string yaml =
      "in: {type: pressure_source, to: n0, pressure: {fourier: {mean: 100, cos: [20]}, unit: mmHg, period: 1 "
      "s}}\n";
  for (int i = 0; i < n; ++i)
    yaml += fmt::format(
        "v{0}: {{type: vessel, from: n{0}, to: n{1}, R: 1e6 Pa.s/m3, C: 1e-10 m3/Pa, L: 2e4 Pa.s2/m3, K: {2} "
        "Pa.s2/m6}}\n",
        i, i + 1, K);
  return yaml +
         fmt::format(
             "end: {{type: windkessel, from: n{}, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 2e8 Pa.s/m3}}\n", n);
}

TEST(Shooting, LargeNetworksByAndersonMixing) {
  const std::string yaml = ladder(40, "1e9");  // 81 states, nonlinear
  const Start s = periodic_start(model(yaml), {}, 1);
  EXPECT_EQ(s.report.method, "anderson");
  EXPECT_LT(change_over_a_period(yaml, s, 1), 1e-6);
  EXPECT_LT(s.report.cycle_integrations, 12);  // the slowest mode alone, e^(-1/2.1) per cycle, needs 29
}

/// The sphere's volume follows from its radius: a conserved quantity that is not linear in the states.
TEST(Shooting, ConservedButNotLinear) {
  const auto yaml = [](const std::string& filling) {
    return "vein: {type: pressure_source, to: LA, pressure: " + filling +
           "}\n"
           "mitral: {type: valve, from: LA, to: LV, R: 2e6 Pa.s/m3, R_closed: 1e9 Pa.s/m3}\n"
           "lv: {type: sphere_chamber, from: LV, rho: 1000 kg/m3, d0: 10 mm, r0: 30 mm, W1: 1 kPa, W2: 40 "
           "Pa, "
           "eta: 10 Pa.s, sigma_max: 100 kPa, alpha_max: 30 1/s, alpha_min: -30 1/s, t_systole: 0.1 s, "
           "t_diastole: "
           "0.4 s, steepness: 0.01 s, period: 0.8 s}\n"
           "aortic: {type: valve, from: LV, to: Ao, R: 2e6 Pa.s/m3, R_closed: 1e9 Pa.s/m3}\n"
           "bed: {type: windkessel, from: Ao, Rp: 5e6 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1.3e8 Pa.s/m3, "
           "initial_pressure: 80 mmHg}\n";
  };
  for (const char* filling : {"8 mmHg", "10 mmHg"}) {  // the second starts far away
    SCOPED_TRACE(filling);
    const Start s = periodic_start(model(yaml(filling)), {}, 0.8);
    EXPECT_LT(change_over_a_period(yaml(filling), s, 0.8), 1e-6);
    Network beats(model(yaml(filling))), periodic(model(yaml(filling)));
    periodic.load(s.state);
    run_to(beats, 40);  // 50 beats
    EXPECT_NEAR(series(beats, "p:bed.Pc_Pa"), series(periodic, "p:bed.Pc_Pa"), 1e-4 * 13332);
  }
}

}  // namespace
}  // namespace ostium::network
