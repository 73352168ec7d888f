#include "sph3d/openings/port_law.hpp"

#include "sph3d/openings/pressure_datum.hpp"
#include "tests/coupling/support.hpp"

namespace ostium::sph3d {
namespace {

TEST(PortLaw, ImplicitPressureObeysTheLawAtTheNewFlow) {
  const PortLaw law{.p_star = 800, .slope = 50, .resistance = 3e7, .q_star = 1e-5};
  const double q_tilde = 4e-5, beta_dt = 2e-8;
  const double P = implicit_port_pressure(law.at(0.1), q_tilde, beta_dt);
  EXPECT_NEAR(P, law.pressure(0.1, q_tilde - beta_dt * P), 1e-9 * P);
}

/// Kinetic energy of a port alone, E = Q^2/(2 beta dt) per step: never grows, however large R dt.
TEST(PortLaw, IsPassive) {
  for (double r : {1e3, 1e7, 1e12}) {
    double q = 1e-4;
    const double beta_dt = 1e-8;
    for (int i = 0; i < 100; ++i) {
      const double before = q;
      q -= beta_dt * implicit_port_pressure({.resistance = r}, q, beta_dt);
      EXPECT_LE(std::abs(q), std::abs(before));
      EXPECT_GE(q, 0);
    }
  }
}

TEST(ComplementaryFilter, PassesTheMeanOfTheCountedFlowAndTheChangesOfTheConjugate) {
  const double tau = 0.01, bias = 0.8, R = 1e7, P = 100;
  auto f = ComplementaryFilter::started_at(0);
  for (int i = 0; i < 5000; ++i) f.step_conjugate(bias * 1e-5, 1e-4, tau), f.step_counted(1e-5, 1e-4, tau);
  // Steady: the biased conjugate flow has dropped out, the law is that of the counted flow.
  EXPECT_NEAR(f.corrected({P, 0, R, 0}).pressure(0, bias * 1e-5), P + R * 1e-5, 1e-9);
  // A jump of the conjugate flow acts at once and in full.
  EXPECT_NEAR(f.corrected({P, 0, R, 0}).pressure(0, bias * 1e-5 + 2e-6), P + R * 1.2e-5, 1e-9);
}

TEST(ComplementaryFilter, StepsAreExactForHeldFlow) {
  auto one = ComplementaryFilter::started_at(1), many = one;
  one.step_conjugate(3, 0.02, 0.01);
  for (int i = 0; i < 200; ++i) many.step_conjugate(3, 1e-4, 0.01);
  EXPECT_NEAR(one.q_conjugate, 3 - 2 * std::exp(-2), 1e-14);
  EXPECT_NEAR(many.q_conjugate, one.q_conjugate, 1e-12);
}

TEST(PressureDatum, RelaxesToTheWeightedPressure) {
  PressureDatum d{.reference = 0, .background = 50, .tau = 0.005, .weights = {0.25, 0.75}};
  const double P[] = {1000, 2000};
  d.start(P);
  EXPECT_DOUBLE_EQ(d.reference, 1700);
  const double Q[] = {1400, 2000};
  d.step(0.005, Q);
  EXPECT_NEAR(d.reference, 1800 - 100 * std::exp(-1), 1e-10);
  EXPECT_DOUBLE_EQ(d.relative({.p_star = 3000}).p_star, 3000 - d.reference);
}

TEST(PressureDatum, WithoutTimeConstantStaysWhereItIs) {
  PressureDatum d{.reference = 7, .background = 0, .tau = 0, .weights = {1.0}};
  const double P[] = {1000};
  d.step(1, P);
  EXPECT_EQ(d.reference, 7);
}

}  // namespace
}  // namespace ostium::sph3d
