#include <fmt/format.h>

#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

const double w = 2 * pi;  // rad/s, the source's
const std::string sine =
    "s: {type: pressure_source, to: A, pressure: {fourier: {mean: 0, sin: [1000]}, unit: Pa, period: 1 s}}\n";
const std::string load = "r: {type: resistor, from: B, ground: 0 Pa, R: 3e7 Pa.s/m3}\n";

TEST(Valves, RectifierWithResistiveLoad) {
  Network n(model(sine + load + "v: {type: valve, from: A, to: B, R: 1e7 Pa.s/m3}\n"));
  for (int i = 1; i <= 60; ++i) {
    run_to(n, 0.037 * i);
    EXPECT_NEAR(series(n, "q:v_m3_s"), std::max(1000 * std::sin(w * n.time()), 0.0) / 4e7, 1e-15) << n.time();
    EXPECT_EQ(series(n, "x:v.open"), std::sin(w * n.time()) > 0) << n.time();
  }
}

TEST(Valves, LeakingRectifier) {
  Network n(model(sine + load + "v: {type: valve, from: A, to: B, R: 1e7 Pa.s/m3, R_closed: 9e7 Pa.s/m3}\n"));
  for (int i = 1; i <= 60; ++i) {
    run_to(n, 0.037 * i);
    const double P = 1000 * std::sin(w * n.time());
    EXPECT_NEAR(series(n, "q:v_m3_s"), P / (P > 0 ? 4e7 : 12e7), 1e-15) << n.time();
  }
}

/// L dq/dt + R q = P sin(w t) from the rise of P on; the inertance carries the flow on until it is spent.
TEST(Valves, InertanceDelaysTheClosure) {
  const double R = 4e7, L = 5e6, Z2 = R * R + w * w * L * L;
  const auto open = [&](double t) {
    return 1000 / Z2 * (R * std::sin(w * t) - w * L * std::cos(w * t) + w * L * std::exp(-R / L * t));
  };
  double a = 0.5, b = 0.9;  // the zero of the flow, by bisection
  for (int i = 0; i < 100; ++i) (open(0.5 * (a + b)) > 0 ? a : b) = 0.5 * (a + b);
  Network n(model(sine + load + "v: {type: valve, from: A, to: B, R: 1e7 Pa.s/m3, L: 5e6 Pa.s2/m3}\n"));
  for (int i = 1; i <= 100; ++i) {
    run_to(n, 0.0237 * i);
    const double t = n.time() - std::floor(n.time());
    EXPECT_NEAR(series(n, "q:v_m3_s"), t < a ? open(t) : 0, 1e-6 * 1000 / R) << n.time();
    if (t > a) {
      EXPECT_EQ(series(n, "q:v_m3_s"), 0) << n.time();
    }
  }
}

/// At the start nothing flows and nothing pushes: the guard of the switch is zero, and leaves it to the open side.
TEST(Valves, LeakingInertanceOpensFromNothing) {
  const double R = 4e7, L = 5e6, Z2 = R * R + w * w * L * L;
  for (Method method : {Method::runge_kutta, Method::ida}) {
    Network n(
        model(sine + load +
              "v: {type: valve, from: A, to: B, R: 1e7 Pa.s/m3, L: 5e6 Pa.s2/m3, R_closed: 9e7 Pa.s/m3}\n"),
        {}, {.method = method});
    for (int i = 1; i <= 20; ++i) {
      run_to(n, 0.0237 * i);
      const double t = n.time();
      const double q =
          1000 / Z2 * (R * std::sin(w * t) - w * L * std::cos(w * t) + w * L * std::exp(-R / L * t));
      EXPECT_NEAR(series(n, "q:v_m3_s"), q, 1e-6 * 1000 / R) << t;
      EXPECT_EQ(series(n, "x:v.open"), 1) << t;
    }
  }
}

/// A compliance behind a tight valve keeps the highest pressure it has seen.
TEST(Valves, PeakIsHeld) {
  Network n(model(
      sine +
      "v: {type: valve, from: A, to: B, R: 1e5 Pa.s/m3}\nc: {type: capacitor, from: B, C: 1e-10 m3/Pa}\n"));
  run_to(n, 0.4);
  const double held = series(n, "p:B_Pa");
  EXPECT_NEAR(held, 1000, 1e-6 * 13332);  // of 100 mmHg
  run_to(n, 0.99);
  EXPECT_EQ(series(n, "p:B_Pa"), held);
}

/// Two events in one instant: a bridge of four valves turns the sine into its magnitude.
TEST(Valves, BridgeOfFour) {
  Network n(model(
      "s: {type: pressure_source, from: A, to: D, pressure: {fourier: {mean: 0, sin: [1000]}, unit: Pa, "
      "period: 1 s}}\n"
      "v1: {type: valve, from: D, to: B, R: 1e6 Pa.s/m3, R_closed: 1e12 Pa.s/m3}\n"
      "v2: {type: valve, from: A, to: B, R: 1e6 Pa.s/m3, R_closed: 1e12 Pa.s/m3}\n"
      "v3: {type: valve, from: E, to: A, R: 1e6 Pa.s/m3, R_closed: 1e12 Pa.s/m3}\n"
      "v4: {type: valve, from: E, to: D, R: 1e6 Pa.s/m3, R_closed: 1e12 Pa.s/m3}\n"
      "r: {type: resistor, from: B, to: E, R: 1e8 Pa.s/m3}\n"
      "g: {type: resistor, from: E, ground: 0 Pa, R: 1e9 Pa.s/m3}\n"));
  for (int i = 1; i <= 40; ++i) {
    run_to(n, 0.053 * i);
    const double expected = std::abs(1000 * std::sin(w * n.time())) / 1.02e8;
    EXPECT_NEAR(series(n, "q:r_m3_s"), expected, 1e-3 * 1e-5) << n.time();
  }
}

/// Two valves open a millisecond apart, within one step. The later one is further on the wrong side at its end; the earlier one must
/// not wait for it.
TEST(Valves, TheEarlierOfTwoOpensFirst) {
  const double R = 1e7, C = 1e-9, T = R * C, first = 0.1;  // Pa.s/m3, m3/Pa, s, s
  const auto side = [](const std::string& k, double amplitude, double opens) {
    return fmt::format(
        "s{0}: {{type: pressure_source, to: A{0}, pressure: {{fourier: {{mean: 0, cos: [{1}], sin: [{2}]}}, "
        "unit: Pa, "
        "period: 1 s}}}}\n"
        "v{0}: {{type: valve, from: A{0}, to: B{0}, R: 1e7 Pa.s/m3}}\n"
        "c{0}: {{type: capacitor, from: B{0}, C: 1e-9 m3/Pa}}\n",
        k, -amplitude * std::sin(w * opens), amplitude * std::cos(w * opens));
  };
  Network n(model(side("1", 1000, first) + side("2", 9000, first + 1e-3)), {}, with(Method::runge_kutta));
  for (const double t : {0.105, 0.12}) {
    run_to(n, t);
    const double s = w * (t - first), wT = w * T;
    const double P =
        1000 / (1 + wT * wT) * (std::sin(s) - wT * std::cos(s) + wT * std::exp(-(t - first) / T));
    EXPECT_NEAR(series(n, "p:B1_Pa"), P, 1e-4 * 1000) << t;
  }
}

TEST(Valves, RestartInMidBeatIsExact) {
  const auto m = [] {
    return model(sine + load + "v: {type: valve, from: A, to: B, R: 1e7 Pa.s/m3, L: 5e6 Pa.s2/m3}\n");
  };
  Network n(m()), other(m());
  for (double t : {0.3, 0.7}) {
    run_to(n, t);
    other.load(n.save());
    run_to(n, t + 0.2);
    run_to(other, t + 0.2);
    EXPECT_EQ(n.save().y, other.save().y);
  }
}

/// Against a Runge-Kutta solution of the same equations with tiny steps.
TEST(Valves, OrificeOpensAndCloses) {
  const double Ao = 4e-4, Ac = 1e-8, l = 0.01, rho = 1060, K = 0.02, Rl = 3e7;
  const auto rate = [&](double t, double q, double z) {
    const double A = Ac + (Ao - Ac) * z, drop = 1000 * std::sin(w * t) - Rl * q;
    return std::pair{A / (rho * l) * drop - std::abs(q) * q / (2 * l * A),
                     drop > 0 ? K * (1 - z) * drop : K * z * drop};
  };
  double q = 0, z = 0;
  const double h = 2e-6;
  Network n(model(
      sine + load +
      "v: {type: orifice_valve, from: A, to: B, A_open: 4 cm2, A_closed: 1e-4 cm2, l: 1 cm, K_open: 0.02 "
      "1/(Pa.s), K_close: 0.02 1/(Pa.s)}\n"));
  int steps = 0;
  for (double until : {0.1, 0.4, 0.6, 0.9}) {
    for (; steps < std::lround(until / h); ++steps) {
      const double t = steps * h;
      const auto [a1, b1] = rate(t, q, z);
      const auto [a2, b2] = rate(t + h / 2, q + h / 2 * a1, z + h / 2 * b1);
      const auto [a3, b3] = rate(t + h / 2, q + h / 2 * a2, z + h / 2 * b2);
      const auto [a4, b4] = rate(t + h, q + h * a3, z + h * b3);
      q += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4), z += h / 6 * (b1 + 2 * b2 + 2 * b3 + b4);
    }
    run_to(n, until);
    EXPECT_NEAR(series(n, "q:v_m3_s"), q, 1e-5 * 1000 / Rl) << until;
    EXPECT_NEAR(series(n, "x:v.z"), z, 1e-5) << until;
  }
}

}  // namespace
}  // namespace ostium::network
