#include "network/periodic.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

struct Rcr {
  const char* name;
  double Rp, C, Rd;
};
/// Five outlets of an aorta.
const Rcr outlets[] = {{"DAo", 9.8e6, 6.02e-9, 1.65e8},
                       {"BCA", 3.1e7, 1.9e-9, 5.2e8},
                       {"LCCA", 9.2e7, 6.2e-10, 1.6e9},
                       {"LSA", 5.4e7, 1.1e-9, 9.0e8},
                       {"RSA", 6.6e7, 8.8e-10, 1.1e9}};
constexpr double period = 0.66;

std::string aorta() {
  std::string yaml =
      "heart: {type: flow_source, to: AAo, flow: {fourier: {mean: 90, cos: [-60, 10], sin: [25, 5]}, unit: "
      "mL/s, period: 0.66 s}}\n";
  for (const auto& o : outlets)
    yaml += fmt::format("{}_b: {{type: windkessel, from: {}, Rp: {} Pa.s/m3, C: {} m3/Pa, Rd: {} Pa.s/m3}}\n",
                        o.name, o.name, o.Rp, o.C, o.Rd);
  return yaml;
}

std::vector<Port> ports() {
  std::vector<Port> all{{"AAo", 4e-4}};
  for (const auto& o : outlets) all.push_back({o.name, 1e-4});
  return all;
}

/// Phasors of mean and harmonics: common pressure = inflow / sum of admittances.
struct ClosedForm {
  std::complex<double> inflow[3] = {90e-6, {-60e-6, -25e-6}, {10e-6, -5e-6}};
  static std::complex<double> impedance(const Rcr& o, int k) {
    return o.Rp + o.Rd / std::complex<double>(1, 2 * pi * k / period * o.Rd * o.C);
  }
  std::complex<double> pressure(int k) const {
    std::complex<double> Y = 0;
    for (const auto& o : outlets) Y += 1.0 / impedance(o, k);
    return inflow[k] / Y;
  }
  double at(double t, auto phasor) const {
    double sum = 0;
    for (int k = 0; k < 3; ++k)
      sum += (phasor(k) * std::exp(std::complex<double>(0, 2 * pi * k * t / period))).real();
    return sum;
  }
  double pressure_at(double t) const {
    return at(t, [&](int k) { return pressure(k); });
  }
  double flow_at(double t, const Rcr& o) const {
    return at(t, [&](int k) { return pressure(k) / impedance(o, k); });
  }
};

TEST(PeriodicStart, FiveWindkesselsAgainstTheClosedForm) {
  const Start s = periodic_start(model(aorta()), ports(), period);
  const ClosedForm exact;
  EXPECT_NEAR(s.pressure, exact.pressure_at(0), 1e-9 * s.pressure);
  EXPECT_NEAR(s.mean_pressure, exact.pressure(0).real(), 1e-9 * s.mean_pressure);
  EXPECT_NEAR(s.port_flow[0], -(90e-6 - 60e-6 + 10e-6), 1e-12 * 4e-5);
  double low = 1e9, high = -1e9, rate = 0;
  for (int i = 0; i < 2000; ++i) {
    const double t = period * i / 2000, P = exact.pressure_at(t);
    low = std::min(low, P), high = std::max(high, P);
    rate = std::max(rate, std::abs(exact.pressure_at(t + 1e-5) - P) / 1e-5);
  }
  EXPECT_NEAR(s.min_pressure, low, 1e-4 * (high - low));
  EXPECT_NEAR(s.max_pressure, high, 1e-4 * (high - low));
  EXPECT_NEAR(s.max_pressure_rate, rate, 1e-3 * rate);
  for (int k = 0; k < 5; ++k) {
    const auto& o = outlets[k];
    EXPECT_NEAR(s.port_flow[k + 1], exact.flow_at(0, o), 1e-9 * 1e-4) << o.name;
    EXPECT_NEAR(s.mean_port_flow[k + 1], exact.pressure(0).real() / (o.Rp + o.Rd), 1e-9 * 1e-4) << o.name;
  }
}

/// The coupled network, fed with the closed form's flows from this start, shows the closed form's pressure at
/// once.
TEST(PeriodicStart, StartsTheCoupledNetworkWithoutTransient) {
  const Start s = periodic_start(model(aorta()), ports(), period);
  Network n(model(aorta()), ports());
  n.load(s.state);
  const ClosedForm exact;
  const double dt = period / 400;
  std::vector<double> q0 = s.port_flow, q1 = q0;
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    for (int k = 0; k < 5; ++k) q1[k + 1] = exact.flow_at((i + 1) * dt, outlets[k]);
    n.advance(dt, q0, q1);
    q0 = q1;
    for (int k = 1; k <= 5; ++k)
      worst = std::max(worst, std::abs(n.pressure(k) - exact.pressure_at(n.time())));
  }
  EXPECT_LT(worst, 2e-5 * s.max_pressure);  // linear pieces of the flow: second order in dt
}

/// A patient's aorta with published Windkessels; its mean pressure is 84.1 mL/s over five beds in parallel.
TEST(PeriodicStart, AortaOfAPatient) {
  const Rcr beds[] = {{"LCCA", 7.13e7, 8.26e-10, 1.20e9},
                      {"RCCA", 7.13e7, 8.26e-10, 1.20e9},
                      {"LSA", 6.02e7, 9.79e-10, 1.01e9},
                      {"RSA", 6.89e7, 8.55e-10, 1.16e9},
                      {"DAo", 9.80e6, 6.02e-9, 1.65e8}};
  std::string yaml =
      "heart: {type: flow_source, to: AAo, flow: {fourier: {mean: 5.0487, "
      "cos: [4.5287, -4.3509, -5.8551, -1.5063, 1.2800, 0.9012, 0.0855, -0.0480], "
      "sin: [-8.0420, -6.2637, 0.7465, 3.5239, 1.6283, -0.1306, -0.2738, -0.0449]}, unit: L/min, period: "
      "0.66 "
      "s}}\n";
  std::vector<Port> openings{{"AAo", 4.5e-4}};
  for (const auto& b : beds) {
    yaml +=
        fmt::format("b{0}: {{type: windkessel, from: {0}, Rp: {1} Pa.s/m3, C: {2} m3/Pa, Rd: {3} Pa.s/m3}}\n",
                    b.name, b.Rp, b.C, b.Rd);
    openings.push_back({b.name, 1e-4});
  }
  const Start s = periodic_start(model(yaml), openings, 0.66);
  constexpr double mmHg = 133.322;
  EXPECT_NEAR(s.mean_pressure / mmHg, 69.8, 0.1);
  EXPECT_NEAR(s.min_pressure / mmHg, 52.0, 0.1);
  EXPECT_NEAR(s.max_pressure / mmHg, 98.6, 0.1);
  const double share[] = {0.0870, 0.0870, 0.1033, 0.0900, 0.6327};
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(s.mean_port_flow[k + 1] / (5.0487 / 60000), share[k], 1e-4) << beds[k].name;
}

TEST(PeriodicStart, TableWithKinksRepeatsItself) {
  const std::string yaml =
      "in: {type: flow_source, to: A, flow: {times: [0, 0.1, 0.3, 0.35, 1.0], time_unit: s, "
      "values: [0, 300, 0, -20, 0], unit: mL/s, period: 1 s}}\n"
      "out: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1.2e8 Pa.s/m3}\n";
  const Start s = periodic_start(model(yaml), {}, 1.0);
  Network n(model(yaml));
  n.load(s.state);
  n.advance(1.0, {}, {});
  for (size_t i = 0; i < s.state.y.size(); ++i) EXPECT_NEAR(n.save().y[i], s.state.y[i], 1e-11 * 13332);
}

/// Two openings that each end in a capacitor cannot be one node; the star between them costs 0.1 Pa.
TEST(PeriodicStart, OpeningsThatFixTheirOwnPressure) {
  const Model m = model(
      "heart: {type: flow_source, to: AAo, flow: {fourier: {mean: 90, cos: [-60]}, unit: mL/s, period: 1 "
      "s}}\n"
      "ca: {type: capacitor, from: A, C: 2e-9 m3/Pa}\nra: {type: resistor, from: A, ground: 0 Pa, R: 1.5e8 "
      "Pa.s/m3}\n"
      "cb: {type: capacitor, from: B, C: 1e-9 m3/Pa}\nrb: {type: resistor, from: B, ground: 0 Pa, R: 3e8 "
      "Pa.s/m3}\n");
  const Start s = periodic_start(m, {{"AAo", 4e-4}, {"A", 1e-4}, {"B", 1e-4}}, 1.0);
  const std::complex<double> Z = 1e8 / std::complex<double>(1, 2 * pi * 1e8 * 3e-9);
  EXPECT_NEAR(s.pressure, 90e-6 * 1e8 - 60e-6 * Z.real(), 1.0);
  EXPECT_NEAR(s.mean_port_flow[1], 60e-6, 1e-9);
  EXPECT_NEAR(s.port_flow[0], -30e-6, 1e-12);
  EXPECT_NEAR(s.port_flow[0] + s.port_flow[1] + s.port_flow[2], 0, 1e-12);
}

TEST(PeriodicStart, StoreWithoutAWayOutIsRefused) {
  try {
    periodic_start(
        model("in: {type: flow_source, to: A, flow: 5 mL/s}\nc: {type: capacitor, from: A, C: 1e-9 m3/Pa}\n"),
        {}, 1.0);
    FAIL();
  } catch (const UserError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("nothing brings p:c.u_Pa back to one value"));
  }
}

TEST(PeriodicStart, PeriodMustBePositive) {
  EXPECT_THROW(periodic_start(model(aorta()), ports(), 0.0), UserError);
  EXPECT_THROW(periodic_start(model(aorta()), ports(), NAN), UserError);
}

TEST(PeriodicStart, LongLadderByIda) {
  std::string yaml =
      "in: {type: pressure_source, to: n0, pressure: {fourier: {mean: 100, cos: [20]}, unit: mmHg, period: 1 "
      "s}}\n";
  for (int i = 0; i < 30; ++i)
    yaml += fmt::format(
        "r{0}: {{type: resistor, from: n{0}, to: n{1}, R: 1e6 Pa.s/m3}}\nc{0}: {{type: capacitor, from: "
        "n{1}, C: "
        "1e-10 m3/Pa}}\n",
        i, i + 1);
  yaml += "end: {type: resistor, from: n30, ground: 0 Pa, R: 2e7 Pa.s/m3}\n";
  const Start s = periodic_start(model(yaml), {}, 1.0);
  Network n(model(yaml));
  n.load(s.state);
  n.advance(1.0, {}, {});
  for (size_t i = 0; i < 31; ++i) EXPECT_NEAR(n.save().y[i], s.state.y[i], 1e-6 * 13332);
}

}  // namespace
}  // namespace ostium::network
