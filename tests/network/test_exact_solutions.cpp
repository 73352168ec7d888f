#include "network/simulate.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

constexpr double Rp = 1.21e7, C = 1.5e-9, Rd = 1.212e8;
const std::string rcr =
    "out: {type: windkessel, from: A, Rp: 1.21e7 Pa.s/m3, C: 1.5e-9 m3/Pa, Rd: 1.212e8 Pa.s/m3}\n";

/// Mean and two harmonics of 0.8 s; amplitudes in mL/s.
const std::string fourier_inflow =
    "in: {type: flow_source, to: A, flow: {fourier: {mean: 80, cos: [-50, 12], sin: [20, 9]}, unit: mL/s, "
    "period: 0.8 s}}\n";
constexpr double period = 0.8;

/// Closed form: periodic part through the impedance, transient of the compliance started at zero.
double fourier_pressure(double t) {
  const double T = Rd * C, w = 2 * pi / period;
  const std::complex<double> i(0, 1),
      amplitude[] = {{-50e-6, -20e-6}, {12e-6, -9e-6}};  // a cos + b sin = Re((a - ib) e^iwt)
  double P = 80e-6 * (Rp + Rd), Pc0 = 80e-6 * Rd;
  for (int k = 1; k <= 2; ++k) {
    const auto Zc = Rd / (1.0 + i * (k * w * T));
    P += ((Rp + Zc) * amplitude[k - 1] * std::exp(i * (k * w * t))).real();
    Pc0 += (Zc * amplitude[k - 1]).real();
  }
  return P - Pc0 * std::exp(-t / T);
}

class Exact : public testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Engines, Exact, testing::Values(Method::exact, Method::runge_kutta, Method::ida),
                         [](const auto& i) {
                           return i.param == Method::exact ? "exponential"
                                  : i.param == Method::ida ? "ida"
                                                           : "runge_kutta";
                         });

double relative_tolerance() { return Exact::GetParam() == Method::exact ? 1e-10 : 1e-6; }

TEST_P(Exact, WindkesselWithFourierInflow) {
  Network n(model(rcr + fourier_inflow), {}, with(GetParam()));
  double worst = 0, largest = 0;
  for (int k = 1; k <= 240; ++k) {
    run_to(n, 0.01 * k);
    worst = std::max(worst, std::abs(series(n, "p:A_Pa") - fourier_pressure(n.time())));
    largest = std::max(largest, std::abs(fourier_pressure(n.time())));
  }
  RecordProperty("worst_relative_error", std::to_string(worst / largest));
  EXPECT_LT(worst / largest, relative_tolerance());
}

/// Intervals that fit the source's period, or end where it is odd about their middle, must not fool the integrator.
TEST_P(Exact, LongIntervalsSeeEveryPeriod) {
  const double w = 2 * pi / period;
  const auto Z = Rd / std::complex<double>(1, w * Rd * C);
  const auto periodic = [&](double t) {
    return 80e-6 * Rd - 50e-6 * (Z * std::exp(std::complex<double>(0, w * t))).real();
  };
  for (double interval : {0.4, 0.8, 1.2, 4.8, 19.2}) {
    Network n(model(rcr + "in: {type: flow_source, to: A, flow: {fourier: {mean: 80, cos: [-50]}, unit: "
                          "mL/s, period: 0.8 s}}"),
              {}, with(GetParam()));
    run_to(n, interval);
    const double exact = periodic(interval) - periodic(0) * std::exp(-interval / (Rd * C));
    EXPECT_NEAR(series(n, "p:out.Pc_Pa"), exact, relative_tolerance() * 1e4) << interval;
  }
}

TEST_P(Exact, WindkesselAsPortWithLinearFlow) {
  Network n(model(rcr), {{"A", 1e-4}}, with(GetParam()));
  const double q[] = {10e-6}, q1[] = {70e-6}, dt = 0.05, T = Rd * C, e = std::exp(-dt / T);
  n.advance(dt, q, q1);
  const double Pc = Rd * (q[0] * (1 - e) + (q1[0] - q[0]) * (1 - T / dt * (1 - e)));
  EXPECT_NEAR(n.pressure(0), Pc + Rp * q1[0], 1e-6 * (Pc + Rp * q1[0]));
  const double slope = (q1[0] - Pc / Rd) / C;
  EXPECT_NEAR(n.pressure_slope(0), slope, 1e-6 * std::abs(slope));
}

TEST_P(Exact, CapacitorIsChargedThroughAResistor) {
  Network n(model("s: {type: pressure_source, to: A, pressure: 1000 Pa}\n"
                  "r: {type: resistor, from: A, to: B, R: 1e7 Pa.s/m3}\n"
                  "c: {type: capacitor, from: B, C: 2e-9 m3/Pa, initial_pressure: 200 Pa}\n"),
            {}, with(GetParam()));
  for (double t : {0.003, 0.02, 0.1}) {
    run_to(n, t);
    EXPECT_NEAR(series(n, "p:B_Pa"), 1000 - 800 * std::exp(-t / 0.02), 1e-5 * 1000);
    EXPECT_NEAR(series(n, "q:c_m3_s"), 800 * std::exp(-t / 0.02) / 1e7, 1e-5 * 8e-5);
  }
}

TEST_P(Exact, StepOfAnOscillatingCircuit) {
  const double R = 2e6, L = 1e5, C = 1e-9, P0 = 1000;
  Network n(model("s: {type: pressure_source, to: A, pressure: 1000 Pa}\n"
                  "r: {type: resistor, from: A, to: B, R: 2e6 Pa.s/m3}\n"
                  "l: {type: inductor, from: B, to: D, L: 1e5 Pa.s2/m3}\n"
                  "b: {type: capacitor, from: B, C: 1e-16 m3/Pa}\n"  // so small that the exact circuit is the
                                                                     // plain RLC
                  "c: {type: capacitor, from: D, C: 1e-9 m3/Pa}\n"),
            {}, with(GetParam()));
  const double a = R / (2 * L), w = std::sqrt(1 / (L * C) - a * a);
  for (double t : {0.01, 0.05, 0.2}) {
    run_to(n, t);
    const double u = P0 * (1 - std::exp(-a * t) * (std::cos(w * t) + a / w * std::sin(w * t)));
    EXPECT_NEAR(series(n, "p:D_Pa"), u, 1e-5 * P0) << t;
  }
}

TEST_P(Exact, PressureSourceThroughResistorFollowsItsTable) {
  Network n(model("s: {type: pressure_source, to: A, pressure: {times: [0, 0.1, 0.3], time_unit: s, values: "
                  "[0, 50, 0], "
                  "unit: Pa, period: 0.3 s}}\n"
                  "r: {type: resistor, from: A, ground: 10 Pa, R: 2e6 Pa.s/m3}\n"),
            {}, with(GetParam()));
  for (double t : {0.05, 0.1, 0.2, 0.45}) {
    run_to(n, t);
    const double s = std::fmod(t, 0.3), P = s < 0.1 ? 500 * s : 250 * (0.3 - s);
    EXPECT_NEAR(series(n, "q:r_m3_s"), (P - 10) / 2e6, 1e-14);
    EXPECT_NEAR(series(n, "q:s_m3_s"), (P - 10) / 2e6, 1e-14);
  }
}

/// A table has kinks; the volume it sends must arrive to the last drop all the same.
TEST_P(Exact, KinksLoseNoVolume) {
  Network n(model("s: {type: flow_source, to: A, flow: {times: [0, 0.037, 0.05, 0.2], time_unit: s, values: "
                  "[0, 90, -20, "
                  "0], unit: mL/s, "
                  "period: 0.2 s}}\n"
                  "c: {type: capacitor, from: A, C: 1e-9 m3/Pa}\n"),
            {}, with(GetParam()));
  run_to(n, 0.2);
  const double volume = 1e-6 * (0.5 * 90 * 0.037 + 0.5 * (90 - 20) * 0.013 - 0.5 * 20 * 0.15);
  EXPECT_NEAR(series(n, "p:c.u_Pa"), volume / 1e-9, relative_tolerance() * volume / 1e-9);
}

/// Wheatstone bridge of resistors: no states at all.
TEST_P(Exact, NetworkWithoutStates) {
  Network n(model("s: {type: flow_source, to: A, flow: 6 mL/s}\n"
                  "ab: {type: resistor, from: A, to: B, R: 1e6 Pa.s/m3}\n"
                  "ad: {type: resistor, from: A, to: D, R: 2e6 Pa.s/m3}\n"
                  "bd: {type: resistor, from: B, to: D, R: 5e6 Pa.s/m3}\n"
                  "bg: {type: resistor, from: B, ground: 0 Pa, R: 1e6 Pa.s/m3}\n"
                  "dg: {type: resistor, from: D, ground: 0 Pa, R: 2e6 Pa.s/m3}\n"),
            {}, with(GetParam()));
  run_to(n, 0.1);
  EXPECT_NEAR(series(n, "q:bd_m3_s"), 0, 1e-16);
  EXPECT_NEAR(series(n, "p:A_Pa"), 6e-6 * 4e6 / 3, 1e-9);
}

TEST(Simulate, RowsAtEveryOutputAndTheEnd) {
  std::vector<double> times;
  std::vector<std::string> names;
  simulate(model(rcr + fourier_inflow), {.end = 0.035, .every = 0.01},
           {.begin = [&](const auto& n) { names = n; },
            .row =
                [&](double t, std::span<const double> values) {
                  EXPECT_EQ(values.size(), names.size());
                  EXPECT_NEAR(values[0], fourier_pressure(t), 1e-6 * 1e4);
                  times.push_back(t);
                  return true;
                }});
  EXPECT_EQ(times, (std::vector<double>{0, 0.01, 0.02, 0.03, 0.035}));
  EXPECT_EQ(names, (std::vector<std::string>{"p:A_Pa", "q:out_m3_s", "p:out.Pc_Pa", "q:in_m3_s"}));
}

TEST(Simulate, StopsWhenTold) {
  int rows = 0;
  simulate(model(rcr + fourier_inflow), {.end = 1, .every = 0.01},
           {.begin = [](const auto&) {}, .row = [&](double, auto) { return ++rows < 3; }});
  EXPECT_EQ(rows, 3);
}

TEST(Simulate, PeriodicStartRepeats) {
  std::vector<double> first, last;
  simulate(model(rcr + fourier_inflow),
           {.end = 0.8, .every = 0.1, .initial = Initial::periodic, .period = 0.8},
           {.begin = [](const auto&) {},
            .row =
                [&](double, std::span<const double> v) {
                  last.assign(v.begin(), v.end());
                  if (first.empty()) first = last;
                  return true;
                }});
  for (size_t i = 0; i < first.size(); ++i) EXPECT_NEAR(last[i], first[i], 1e-10 * std::abs(first[i]));
}

}  // namespace
}  // namespace ostium::network
