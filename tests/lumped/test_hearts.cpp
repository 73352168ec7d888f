#include "core/vec.hpp"
#include "tests/lumped/support.hpp"

namespace ostium::lumped {
namespace {

const std::string muscle = "activation: {type: half_cosine, start: 0 s, duration: 0.8 s, period: 0.8 s}";

TEST(ElastanceChamber, PressureOfItsVolume) {
  const auto b =
      block("{type: elastance_chamber, from: A, Emin: 2 Pa/m3, Emax: 10 Pa/m3, V0: 3 m3, V0_systole: 1 m3, " +
            muscle + "}");
  // p_from, p_to | q, q_out, V | their rates: A(0.2) = 1/2, E = 6, V0 = 2
  const auto f = answer(*b, {50, 0, 7, 0, 8, 0, 0, 4}, 0.2);
  EXPECT_NEAR(f[0], 50 - 6 * (8 - 2), 1e-12);
  EXPECT_EQ(f[1], 0);
  EXPECT_EQ(f[2], 4 - 7);
  EXPECT_EQ(f[3], 7);
  expect_exact_jacobian(*b, {50, 0, 7, 0.1, 8, 0.1, 0.1, 4});
}

TEST(ElastanceChamber, EmptiesThroughAnInertance) {
  const auto b =
      block("{type: elastance_chamber, from: A, to: B, L: 4 Pa.s2/m3, Emin: 2 Pa/m3, Emax: 10 Pa/m3, " +
            muscle + "}");
  const auto f = answer(*b, {50, 30, 7, 5, 8, 0, 3, 4}, 0);
  EXPECT_EQ(f[1], 4 * 3 - (50 - 30));
  EXPECT_EQ(f[2], 4 - (7 - 5));
  EXPECT_EQ(f[4], -5);
  EXPECT_TRUE(b->unknowns()[1].differential);
  EXPECT_EQ(b->branches()[1].nature, Nature::inductive);
}

TEST(ExponentialChamber, PassiveAndActive) {
  const auto b =
      block("{type: exponential_chamber, from: A, Emax: 10 Pa/m3, P0: 4 Pa, k: 0.5 1/m3, V0: 2 m3, " +
            muscle + "}");
  EXPECT_NEAR(answer(*b, {0, 0, 0, 0, 6, 0, 0, 0}, 0)[0], -4 * (std::exp(0.5 * 4) - 1), 1e-12);
  EXPECT_NEAR(answer(*b, {0, 0, 0, 0, 6, 0, 0, 0}, 0.4)[0], -10 * 4, 1e-12);
  expect_exact_jacobian(*b, {50, 0, 7, 0.1, 6, 0.1, 0.1, 4});
}

const std::string sphere =
    "{type: sphere_chamber, from: A, rho: 1000 kg/m3, d0: 10 mm, r0: 50 mm, W1: 10 kPa, W2: 40 Pa, eta: 10 "
    "Pa.s, "
    "sigma_max: 185 kPa, alpha_max: 30 1/s, alpha_min: -30 1/s, t_systole: 0.17 s, t_diastole: 0.484 s, "
    "steepness: 0.005 "
    "s, period: 1 s}";

TEST(SphereChamber, JacobianAndVolumeOfTheSphere) {
  const auto b = block(sphere);
  expect_exact_jacobian(*b, {2000, 1e-5, 0.002, 0.01, 3000, 500, 5e-4, 0, 0.01, 0.2, 0, 100, 1e-4}, 0.3);
  double y[6];
  b->initial(y);
  EXPECT_NEAR(y[5], 4.0 / 3 * pi * std::pow(0.05, 3), 1e-12);
}

/// The power of the pressure goes into tissue (two invariants), viscosity and motion: derived from energies alone.
TEST(SphereChamber, BalancesThePowerOfItsEnergies) {
  const auto b = block(sphere);
  const double r0 = 0.05, d0 = 0.01, rho = 1000, W1 = 1e4, W2 = 40, r = 0.004, v = 0.02, tau = 700;
  const double l = 1 + r / r0, c = l * l;
  // energy per volume W1 (I1 - 3) + W2 (I2 - 3) with I1 = 2 c + c^-2, I2 = c^2 + 2/c; its rate through dc/dt = 2 l v/r0
  const double dc = 2 * l * v / r0;
  const double elastic = (W1 * (2 - 2 / (c * c * c)) + W2 * (2 * c - 2 / (c * c))) * dc;
  const double active = tau * dc / 2, viscous = 10 * dc * dc * (1 + 2 * std::pow(c, -6)) / 2;
  const double wall = 4 * pi * r0 * r0 * d0, dv = 0.3;
  const double S =
      tau + 4 * (1 - std::pow(c, -3)) * (W1 + c * W2) + 2 * 10 * l * v / r0 * (1 + 2 * std::pow(c, -6));
  const double p = (wall * (elastic + active + viscous + rho * v * dv)) / (4 * pi * r0 * r0 * c * v);
  const auto f = answer(
      *b, {p, 4 * pi * r0 * r0 * c * v, r, v, S, tau, 5e-4, 0, v, dv, 0, 0, 4 * pi * r0 * r0 * c * v}, 0.3);
  for (int i : {0, 1, 2, 3, 5}) EXPECT_NEAR(f[i], 0, 1e-9 * (i == 0 || i == 3 ? S : 1)) << i;
}

TEST(Valve, OpenAndClosed) {
  const auto b = block("{type: valve, from: A, to: B, R: 2 Pa.s/m3, L: 4 Pa.s2/m3}");
  EXPECT_EQ(answer(*b, {30, 10, 3, 1, 0.5, 0})[0], 4 * 0.5 + 2 * 3 - 20);
  EXPECT_EQ(answer(*b, {30, 10, 0, 0, 0.5, 0})[0], 4 * 0.5);  // closed: the flow does not change
  expect_exact_jacobian(*b, {30, 10, 3, 1, 0.5, 0});
  double g = 0, y[] = {1e-12, 1};
  b->guards(0, std::vector<double>{30, 40, 3e-4, 1, 0, 0}.data(), &g);
  EXPECT_NEAR(g, 3, 1e-12);  // open: by its flow
  b->throw_switch(0, y);
  EXPECT_EQ(y[0], 0);
  EXPECT_EQ(y[1], 0);
  b->guards(0, std::vector<double>{30, 40, 0, 0, 0, 0}.data(), &g);
  EXPECT_LT(g, 0);  // closed: by its pressures
}

TEST(Valve, LeaksWhereToldTo) {
  const auto b = block("{type: valve, from: A, to: B, R: 2 Pa.s/m3, R_closed: 200 Pa.s/m3}");
  EXPECT_EQ(answer(*b, {10, 30, -0.1, 0, 0, 0})[0], 0);
  EXPECT_FALSE(b->unknowns()[0].differential);
}

TEST(SmoothValve, FollowsItsPressureDifference) {
  const auto b =
      block("{type: smooth_valve, from: A, to: B, Rmin: 2 Pa.s/m3, Rmax: 200 Pa.s/m3, k: 0.1 1/Pa}");
  const double s = 0.5 * (1 + std::tanh(0.1 * (10 - 14)));
  EXPECT_NEAR(answer(*b, {14, 10, 3, s, 0, 0})[0], 3 - 4 / (2 + 198 * s), 1e-12);
  EXPECT_NEAR(answer(*b, {14, 10, 3, s, 0, 0})[1], 0, 1e-15);
  expect_exact_jacobian(*b, {14, 10, 3, 0.3, 0.1, 0.1});
}

TEST(OrificeValve, BernoulliInertiaAndRates) {
  const auto b = block(
      "{type: orifice_valve, from: A, to: B, A_open: 4 m2, A_closed: 1 m2, l: 2 m, rho: 10 kg/m3, K_open: 3 "
      "1/(Pa.s), "
      "K_close: 5 1/(Pa.s), R: 7 Pa.s/m3}");
  const double A = 1 + 3 * 0.5, q = -2, drop = 20;
  const double dq = (drop - 7 * q - 10 / (2 * A * A) * std::abs(q) * q) / (10 * 2 / A);
  const auto f = answer(*b, {30, 10, q, 0.5, 1, dq, 3 * 0.5 * drop, 0});
  EXPECT_NEAR(f[0], 0, 1e-12);
  EXPECT_NEAR(f[1], 0, 1e-12);
  EXPECT_NEAR(answer(*b, {10, 30, q, 0.5, 0, dq, -5 * 0.5 * drop, 0})[1], 0, 1e-12);
  expect_exact_jacobian(*b, {30, 10, q, 0.5, 1, dq, 1, 0});
}

}  // namespace
}  // namespace ostium::lumped
