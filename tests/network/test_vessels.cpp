#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

/// A step of pressure on R, C, L in a row towards zero pressure, both orders: closed forms of the second-order circuits.
TEST(Vessels, StepOnTheComplianceBehindTheLoss) {
  const double R = 2e6, C = 1e-9, L = 1e5, P = 1000;
  Network n(
      model("s: {type: pressure_source, to: A, pressure: 1000 Pa}\n"
            "v: {type: vessel, from: A, ground: 0 Pa, R: 2e6 Pa.s/m3, C: 1e-9 m3/Pa, L: 1e5 Pa.s2/m3}\n"));
  EXPECT_TRUE(n.linear());
  // C u' = (P - u)/R - j, L j' = u: u'' + u'/(RC) + u/(LC) = 0, u(0) = 0, u'(0) = P/(RC)
  const double a = 1 / (2 * R * C),
               w = std::sqrt(1 / (L * C) - a * a < 0 ? a * a - 1 / (L * C) : 1 / (L * C) - a * a);
  for (double t : {1e-3, 5e-3, 0.02, 0.1}) {
    run_to(n, t);
    const double swing = 1 / (L * C) > a * a ? std::sin(w * t) / w : std::sinh(w * t) / w;
    EXPECT_NEAR(series(n, "p:v.u_Pa"), P / (R * C) * std::exp(-a * t) * swing, 1e-8 * P) << t;
  }
}

TEST(Vessels, StepOfFlowOnTheComplianceAtTheInlet) {
  const double R = 2e6, C = 1e-8, L = 1e5, Q = 1e-4;
  Network n(
      model("s: {type: flow_source, to: A, flow: 100 mL/s}\n"
            "v: {type: vessel, from: A, ground: 0 Pa, R: 2e6 Pa.s/m3, C: 1e-8 m3/Pa, L: 1e5 Pa.s2/m3, order: "
            "CRL}\n"));
  // C u' = Q - j, L j' = u - R j: j'' + R/L j' + j/(LC) = Q/(LC)
  const double a = R / (2 * L), w = std::sqrt(1 / (L * C) - a * a);
  for (double t : {1e-3, 0.02, 0.1}) {
    run_to(n, t);
    const double j = Q * (1 - std::exp(-a * t) * (std::cos(w * t) + a / w * std::sin(w * t)));
    EXPECT_NEAR(series(n, "q:v.q_out_m3_s"), j, 1e-8 * Q) << t;
  }
}

TEST(Vessels, SteadyStenosis) {
  Network n(
      model("s: {type: flow_source, to: A, flow: 5 mL/s}\n"
            "v: {type: vessel, from: A, to: B, R: 1e8 Pa.s/m3, K: 1e14 Pa.s2/m6}\n"
            "r: {type: resistor, from: B, ground: 100 Pa, R: 1e8 Pa.s/m3}\n"));
  EXPECT_NEAR(series(n, "p:A_Pa"), 100 + 5e-6 * (2e8 + 1e14 * 5e-6), 1e-9);
}

/// Losses of the branches of a junction: the flows and pressures of hand calculation.
TEST(Vessels, BranchesOfAJunctionWithLosses) {
  Network n(
      model("s: {type: flow_source, to: A, flow: 5 mL/s}\n"
            "left: {type: vessel, from: A, to: B, R: 100 Pa.s/m3, K: 2e8 Pa.s2/m6}\n"
            "right: {type: vessel, from: A, to: D, R: 200 Pa.s/m3}\n"
            "l: {type: resistor, from: B, ground: 50 Pa, R: 400 Pa.s/m3}\n"
            "r: {type: resistor, from: D, ground: 50 Pa, R: 1300 Pa.s/m3}\n"));
  const double q = series(n, "q:left_m3_s"), p = series(n, "p:A_Pa");
  EXPECT_NEAR(q + series(n, "q:right_m3_s"), 5e-6, 1e-18);
  EXPECT_NEAR(p, 50 + 1500 * (5e-6 - q), 1e-12);
  EXPECT_NEAR(p, 50 + 500 * q + 2e8 * q * q, 1e-12);
}

/// A short vessel is a wire, a compliance alone is one at both nodes.
TEST(Vessels, WithoutLossAndInertance) {
  Network n(
      model("s: {type: flow_source, to: A, flow: 5 mL/s}\n"
            "wire: {type: vessel, from: A, to: B, R: 0 Pa.s/m3}\n"
            "cap: {type: vessel, from: B, to: D, R: 0 Pa.s/m3, C: 1e-9 m3/Pa, initial_pressure: 200 Pa}\n"
            "r: {type: resistor, from: D, ground: 0 Pa, R: 1e8 Pa.s/m3}\n"));
  run_to(n, 0.05);
  const double p = 500 - 300 * std::exp(-0.5);
  for (const char* node : {"p:A_Pa", "p:B_Pa", "p:D_Pa"}) EXPECT_NEAR(series(n, node), p, 1e-8 * p);
}

/// The bed that lags in pressure without storing blood: what enters leaves at once.
TEST(Vessels, BedThatDoesNotStore) {
  const double R = 1e7, C = 3e-8, Q = 1e-4;
  Network n(
      model("s: {type: flow_source, to: A, flow: 100 mL/s}\n"
            "b: {type: rc, from: A, to: B, R: 1e7 Pa.s/m3, C: 3e-8 m3/Pa, stores: false}\n"
            "r: {type: resistor, from: B, ground: 0 Pa, R: 1e6 Pa.s/m3}\n"));
  run_to(n, 0.2);
  EXPECT_NEAR(series(n, "q:r_m3_s"), Q, 1e-16);
  const double p = 1e6 * Q + R * Q - (1e6 * Q + R * Q) * std::exp(-0.2 / (R * C));
  EXPECT_NEAR(series(n, "p:A_Pa"), p, 1e-8 * p);
}

}  // namespace
}  // namespace ostium::network
