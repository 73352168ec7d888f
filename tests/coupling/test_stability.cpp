#include "coupling/stability.hpp"

#include "tests/coupling/acoustic_pipe.hpp"
#include "tests/coupling/support.hpp"

namespace ostium::coupling {
namespace {

const VesselNumbers channel{
    .density = 1000, .sound_speed = 10, .volume = 6.35e-3 * 0.03175, .length = 0.03175};
constexpr double Zc = 1000 * 10 / 6.35e-3;
const OneMinusCosine inflow{.mean = 0.75e-3};

Rcr windkessel(double Rp_over_Zc) { return {.Rp = Rp_over_Zc * Zc, .C = 1.96e-7, .Rd = 6.85e6}; }

network::Network coupled(const Rcr& w) {
  return network_of(w.yaml() + "heart: {type: flow_source, to: In, flow: 1 L/min}\n",
                    {{"A", 6.35e-3}, {"In", 6.35e-3}});
}

StabilityNumbers numbers(double r, double window) {
  return stability_numbers(coupled(windkessel(r)), channel, {.window = window}, 2 * pi);
}

bool refused(double r, double window, SchemeKind kind) {
  try {
    check_stability(numbers(r, window), kind, false);
  } catch (const UserError&) {
    return true;
  }
  return false;
}

TEST(Stability, Numbers) {
  const auto s = numbers(0.5, 1e-3);
  ASSERT_EQ(s.ports.size(), 1u);
  EXPECT_NEAR(s.ports[0].Zc, Zc, 1e-6);
  EXPECT_NEAR(s.ports[0].R_instant, 0.5 * Zc, 1e-3);
  EXPECT_NEAR(s.ports[0].inertance, 5000, 1e-9);
  EXPECT_NEAR(s.fluid_compliance, 2.016e-9, 1e-12);
  EXPECT_NEAR(s.network_compliance, 1.96e-7, 1e-15);
  EXPECT_NEAR(s.transit, 3.175e-3, 1e-12);
  EXPECT_TRUE(s.prescribed_inflow);
  EXPECT_NEAR(s.ports[0].Z1, std::abs(windkessel(0.5).impedance(2 * pi)), 1);
}

TEST(Stability, TextShowsThem) {
  const auto text = numbers(0.5, 1e-3).text();
  EXPECT_THAT(text, testing::HasSubstr("Exchange every 1 ms; transit time of the vessel 3.17 ms"));
  EXPECT_THAT(text, testing::HasSubstr("A            R/Zc      0.5"));
}

/// Whatever passes the check is stable in the undamped pipe.
TEST(Stability, NothingUnstableIsAccepted) {
  int accepted = 0, refusals = 0;
  for (auto kind : {SchemeKind::held, SchemeKind::extrapolated, SchemeKind::modified_euler})
    for (double r : {0.02, 0.2, 0.5, 0.9, 1.1, 2.0, 3.0, 10.0})
      for (double window : {2.4e-5, 2e-4, 1e-3, 4e-3, 8e-3, 12.7e-3, 20e-3, 60e-3}) {
        if (refused(r, window, kind)) {
          ++refusals;
          continue;
        }
        ++accepted;
        auto network = network_of(windkessel(r).yaml(), {{"A", 6.35e-3}});
        auto scheme = make_scheme(kind, network);
        PipeSetup setup{.inflow = [](double t) { return inflow.flow(t); }, .window = window};
        const auto last = AcousticPipe(setup, network, *scheme).run(1e9).back();
        EXPECT_NEAR(last.pressure, inflow.pressure(windkessel(r), last.time), 0.3 * 1e4)
            << name(kind) << " " << r << " " << window;
        EXPECT_GT(last.time, 0.55);
      }
  EXPECT_GT(accepted, 50);
  EXPECT_GT(refusals, 90);
}

TEST(Stability, RefusalSaysWhatToDo) {
  try {
    check_stability(numbers(3, 1e-3), SchemeKind::held, false);
    FAIL();
  } catch (const UserError& e) {
    const std::string text = e.what();
    EXPECT_THAT(text,
                testing::HasSubstr(
                    "the coupling scheme held would be unstable: the network answers at \"A\" with R ="));
    EXPECT_THAT(text, testing::HasSubstr("with an exchange every 1 ms it must be below"));
    EXPECT_THAT(text, testing::HasSubstr("or the exchanges at least"));
    EXPECT_THAT(text, testing::HasSubstr("Use `scheme: linearised`"));
    EXPECT_THAT(text, testing::HasSubstr("`force: true`"));
  }
}

TEST(Stability, ForcedIsAWarning) {
  const auto warnings = check_stability(numbers(3, 1e-3), SchemeKind::held, true);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], testing::HasSubstr("may be unstable"));
}

TEST(Stability, FastWindowsCompareWithTheImpedance) {
  EXPECT_FALSE(refused(0.9, 5e-5, SchemeKind::held));
  EXPECT_TRUE(refused(1.1, 5e-5, SchemeKind::held));
}

TEST(Stability, PressureUpstreamComparesWithTheInertance) {
  auto network = network_of(windkessel(0.9).yaml(), {{"A", 6.35e-3}});
  const auto at = [&](double window) {
    return stability_numbers(network, channel, {.window = window}, 2 * pi);
  };
  EXPECT_FALSE(at(1e-3).prescribed_inflow);
  EXPECT_THROW(check_stability(at(1e-3), SchemeKind::held, false), UserError);
  auto weak = network_of(windkessel(0.1).yaml(), {{"A", 6.35e-3}});
  EXPECT_NO_THROW(
      check_stability(stability_numbers(weak, channel, {.window = 5e-3}, 2 * pi), SchemeKind::held, false));
  EXPECT_THROW(
      check_stability(stability_numbers(weak, channel, {.window = 50e-3}, 2 * pi), SchemeKind::held, false),
      UserError);
}

TEST(Stability, LinearisedIsNeverRefused) {
  for (double r : {0.1, 10.0, 1000.0})
    for (double window : {1e-5, 1e-3, 0.1})
      EXPECT_TRUE(check_stability(numbers(r, window), SchemeKind::linearised, false).empty());
}

TEST(Stability, FilterShorterThanTheWindow) {
  auto s = numbers(0.5, 20e-3);
  s.exchange.filter_time = 10e-3;
  EXPECT_THROW(check_stability(s, SchemeKind::linearised, false), UserError);
  s.exchange.filter_time = 50e-3;
  const auto warnings = check_stability(s, SchemeKind::linearised, false);
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], testing::HasSubstr("at least five times the delay of the counted flow, 100 ms"));
  s.exchange.filter_time = 100e-3;
  EXPECT_TRUE(check_stability(s, SchemeKind::linearised, false).empty());
}

}  // namespace
}  // namespace ostium::coupling
