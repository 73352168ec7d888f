// The pipe in full length against its closed form; the same bits for any number of threads.
#include <cmath>
#include <numbers>

#include "case_run.hpp"

namespace ostium::test {
namespace {

class FullPipe : public CaseRun {
 protected:
  void compare(const std::string& name) {
    const auto surface = data("pipe_rcr/pipe_exterior.vtp");
    if (!surface) GTEST_SKIP() << "needs the reference data (vessels/pipe_rcr)";
    run(name, "--surface '" + surface->string() + "'");
    const Table exact = reference(name);
    const Signal pressure = column(exact, "outlet_pressure_Pa"), flow = column(exact, "outlet_flow_m3_s");
    const PortSignals outlet = ports().at("outlet");
    const Signal p = outlet.pressure.between(1, 2), q = outlet.flow_out.between(1, 2);
    const double swing = pressure.max() - pressure.min();
    EXPECT_NEAR(noted("largest pressure, error over the swing", (p.max() - pressure.max()) / swing), 0, 0.03);
    EXPECT_NEAR(noted("smallest pressure", (p.min() - pressure.min()) / swing), 0, 0.03);
    EXPECT_NEAR(noted("mean pressure", (p.mean() - pressure.mean()) / swing), 0, 0.03);
    EXPECT_LT(noted("outlet flow, rms over its mean", rms_difference(q, flow, 1) / flow.mean()), 0.02);
    EXPECT_LE(summary()["mass_balance_relative_to_inflow"].get<double>(), 1e-10);
  }
};

TEST_F(FullPipe, Compliant) { compare("pipe_rcr"); }
TEST_F(FullPipe, NearlyStiff) { compare("pipe_rcr_small_compliance"); }

/// First harmonic of what the two ends differ by, against Womersley's exact solution (alpha = 25.8): 105.36 Pa in phase
/// with the acceleration. Finite elements on the fine mesh of this pipe's sources give 105.0 Pa; those on its coarse mesh
/// (elements six times as wide as the Stokes layer) 132.6 Pa, which is why they are not the reference.
TEST_F(FullPipe, PressureDifferenceOfTheEnds) {
  const auto surface = data("pipe_rcr/pipe_exterior.vtp");
  if (!surface) GTEST_SKIP() << "needs the reference data (vessels/pipe_rcr)";
  run("pipe_rcr", "--surface '" + surface->string() + "'");
  const auto all = ports();
  const Signal in = all.at("inlet").pressure.between(1, 2), out = all.at("outlet").pressure;
  double sine = 0, mean = 0, span = 0;
  for (std::size_t i = 1; i < in.time.size(); ++i) {
    const double dt = in.time[i] - in.time[i - 1], difference = in.value[i] - out.at(in.time[i]);
    sine += 2 * dt * difference * std::sin(2 * std::numbers::pi * in.time[i]);
    mean += dt * difference;
    span += dt;
  }
  EXPECT_NEAR(noted("first harmonic, Pa", sine / span), 105.36, 0.05 * 105.36);
  EXPECT_NEAR(mean / span, 1.2,
              0.05 * 105.36);  // Poiseuille's loss; entrance and noise within 5 % of the amplitude
}

class FullThreads : public CaseRun {};

TEST_F(FullThreads, OneAndTwoGiveTheSameBits) {
  const std::string options = "--set 'vessel.spacing=0.5 mm' --set 'time={period: 0.5 s, end: 0.1 s}'";
  run("backflow_branch", options + " --threads 1");
  const std::string one = content("results/ports.csv");
  run("backflow_branch", "--force " + options + " --threads 2");
  EXPECT_EQ(content("results/ports.csv"), one);
}

}  // namespace
}  // namespace ostium::test
