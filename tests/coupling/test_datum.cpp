#include "coupling/datum.hpp"

#include "tests/coupling/acoustic_pipe.hpp"
#include "tests/coupling/support.hpp"

namespace ostium::coupling {
namespace {

/// Pipe of 371 mL and 0.3 m with c = 32 m/s: the fluid stores 3.42e-10 m3/Pa, 23 % and 228 % of the two compliances.
const OneMinusCosine inflow{.mean = 62.83e-6};

struct Cycle {
  double high = -1e9, low = 1e9, mean = 0;    // dyn/cm2
  double pressure_error = 0, flow_error = 0;  // rms over the mean
};

Cycle third_cycle(double C, double tau, double stiffer = 1, double c = 32) {
  Rcr w{.Rp = 1.21e7 * stiffer, .C = C, .Rd = 1.212e8};
  w.start = inflow.periodic_start(w);
  auto network = network_of(w.yaml(), {{"A", 1e-3}});
  auto scheme = make_scheme(SchemeKind::linearised, network);
  PipeSetup setup{.rho = 1060, .c = c, .length = 0.3, .area = 371e-6 / 0.3};
  setup.inflow = [](double t) { return inflow.flow(t); };
  setup.end = 3, setup.window = 1e-3, setup.filter_time = 0.01;
  if (tau > 0)
    setup.datum = sph3d::PressureDatum{.tau = tau, .weights = datum_weights(network, inflow.omega())};
  Cycle cycle;
  int n = 0;
  for (const auto& s : AcousticPipe(setup, network, *scheme).run()) {
    if (s.time < 2 + 1e-6) continue;
    cycle.high = std::max(cycle.high, 10 * s.pressure), cycle.low = std::min(cycle.low, 10 * s.pressure);
    cycle.mean += 10 * s.pressure, ++n;
    cycle.pressure_error += std::pow(10 * (s.pressure - inflow.periodic_pressure(w, s.time)), 2);
    cycle.flow_error += std::pow(s.mean_flow - inflow.flow(s.time - 0.5e-3), 2);
  }
  cycle.mean /= n;
  cycle.pressure_error = std::sqrt(cycle.pressure_error / n) / cycle.mean;
  cycle.flow_error = std::sqrt(cycle.flow_error / n) / inflow.mean;
  return cycle;
}

void expect_cycle(const Cycle& c, double high, double low, double pressure_error, double flow_error) {
  EXPECT_NEAR(c.high, high, 0.002 * 167e3);
  EXPECT_NEAR(c.low, low, 0.002 * 167e3);
  EXPECT_NEAR(c.mean, 83751, 5);
  EXPECT_LT(c.pressure_error, pressure_error);
  EXPECT_LT(c.flow_error, flow_error);
}

TEST(Datum, PipeWithTheLargeCompliance) {
  expect_cycle(third_cycle(1.5e-9, 10e-3), 139822, 27706, 0.0075, 0.013);
  expect_cycle(third_cycle(1.5e-9, 5e-3), 139625, 27921, 0.0048, 0.010);
}

TEST(Datum, PipeWithTheSmallCompliance) {
  expect_cycle(third_cycle(1.5e-10, 10e-3), 168796, -1141, 0.0155, 0.019);
  expect_cycle(third_cycle(1.5e-10, 5e-3), 168050, -392, 0.0085, 0.015);
  expect_cycle(third_cycle(1.5e-10, 2e-3), 167612, 56, 0.0055, 0.013);
}

TEST(Datum, WithoutItTheFluidStoresWhatTheNetworkShould) {
  const Cycle large = third_cycle(1.5e-9, 0), small = third_cycle(1.5e-10, 0);
  EXPECT_NEAR(large.pressure_error, 0.079, 0.004);
  EXPECT_NEAR(large.flow_error, 0.12, 0.01);
  EXPECT_NEAR(small.pressure_error, 0.189, 0.006);
  EXPECT_NEAR(small.flow_error, 0.19, 0.01);
}

TEST(Datum, StaysStableForAStiffOutletAndASlowFluid) {
  EXPECT_LT(third_cycle(1.5e-9, 10e-3, 20).pressure_error, 0.03);
  EXPECT_NEAR(third_cycle(1.5e-9, 5e-3, 1, 16).pressure_error, 0.015, 0.001);
  EXPECT_NEAR(third_cycle(1.5e-9, 5e-3, 1, 10).pressure_error, 0.038,
              0.001);  // stores 2.3 times the network's volume
}

TEST(Datum, WeightsGoWithTheAdmittances) {
  const Rcr a{.Rp = 1e7, .C = 1e-9, .Rd = 1e8}, b{.Rp = 3e7, .C = 3e-10, .Rd = 4e8};
  auto network = network_of(a.yaml('A') + b.yaml('B') + "heart: {type: flow_source, to: In, flow: 5 L/min}\n",
                            {{"In", 1e-4}, {"A", 1e-4}, {"B", 1e-4}});
  const auto w = datum_weights(network, 2 * pi);
  EXPECT_EQ(w[0], 0);
  EXPECT_NEAR(w[1] / w[2], std::abs(b.impedance(2 * pi)) / std::abs(a.impedance(2 * pi)), 1e-12);
  EXPECT_NEAR(w[1] + w[2], 1, 1e-15);
}

TEST(Datum, FixedPressureTakesTheWeight) {
  const Rcr a{.Rp = 1e7, .C = 1e-9, .Rd = 1e8};
  auto network = network_of(a.yaml('A') + "b: {type: pressure_source, from: B, pressure: 80 mmHg}\n",
                            {{"A", 1e-4}, {"B", 1e-4}});
  const auto w = datum_weights(network, 2 * pi);
  EXPECT_LT(w[0], 1e-5);
  EXPECT_NEAR(w[0] + w[1], 1, 1e-15);
  auto fixed = network_of("b: {type: pressure_source, from: B, pressure: 80 mmHg}\n", {{"B", 1e-4}});
  EXPECT_EQ(datum_weights(fixed, 2 * pi)[0], 1);
}

TEST(Datum, BackgroundCoversWhatTheDatumDoesNot) {
  EXPECT_DOUBLE_EQ(
      background_pressure(
          {.density = 1000, .max_speed = 2, .pressure_drop = 500, .tau = 0.005, .max_pressure_rate = 1e5}),
      4000 + 500 + 500);
}

}  // namespace
}  // namespace ostium::coupling
