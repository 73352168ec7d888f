// Equilibria of strips in the plane against closed formulas.
#include <gtest/gtest.h>

#include "shell_clouds.hpp"
#include "sph3d/shell/equilibrium.hpp"
#include "sph3d/shell/recover.hpp"
#include "sph3d/shell/stable_step.hpp"

namespace ostium::sph3d {
namespace {

constexpr double kappa_s = 5.0 / 6.0;

struct Strip {
  double L = 1.0, t = 0.02, E = 1e6, nu = 0.3;

  double D() const { return E * t * t * t / (12.0 * (1.0 - nu * nu)); }
  double shear() const { return kappa_s * E / (2 * (1 + nu)) * t; }
  /// Deflection in the middle of a span under pressure; ends clamped (1) or hinged (5).
  double middle(double p, double span, int ends) const {
    return p * std::pow(span, 4) / (384 * D()) * ends + p * span * span / (8 * shear());
  }
  double pressure() const { return 0.002 * t * 384 * D() / std::pow(L, 4); }
  ShellOptions options(double dp, double hourglass = 1.0) const {
    auto o = static_options(dp, E, nu);
    o.hourglass = hourglass;
    return o;
  }
};

ShellState<2> pressed(const ShellModel<2>& model, double p) {
  auto state = rest(model);
  auto load = no_load(model);
  for (auto& block : load)
    for (double& x : block.pressure) x = p;
  find_equilibrium(model, state, load, {.tolerance = 1e-4});
  return state;
}

/// Middle of a strip between bands of four clamped particles, over that of a strip of the given span.
double clamped_strip(const Strip& s, int n, double hourglass, double span) {
  const ShellModel<2> model(strip(n, s.L / n, s.t, 4, 4), s.options(s.L / n, hourglass));
  const auto state = pressed(model, s.pressure());
  const double w = 0.5 * (state.displacement(4 + n / 2)[1] + state.displacement(3 + n / 2)[1]);
  return w / s.middle(s.pressure(), span, 1);
}

// A weak hourglass control leaves odd and even particles to themselves, each with a clamp of its own; together they see
// it one spacing inside the band.
TEST(ShellStatics, ClampedStripWithItsEffectiveSpan) {
  for (const double t : {0.02, 0.05})
    for (const double nu : {0.3, 0.49}) {
      const Strip s{.t = t, .nu = nu};
      EXPECT_NEAR(clamped_strip(s, 40, 0.001, s.L + 2 * s.L / 40), 1.0, 0.005) << t << " " << nu;
    }
}

// With the default the clamp lies a little nearer to the band, until the spacing is less than the thickness.
TEST(ShellStatics, ClampedStripConverges) {
  const Strip s;
  double error[3];
  for (int k = 0; k < 3; ++k) error[k] = 1.0 - clamped_strip(s, 40 << k, 1.0, s.L + 2 * s.L / (40 << k));
  EXPECT_LT(std::abs(error[2]), 0.006);
  EXPECT_GT(error[0] / error[1], 2.0);
  EXPECT_GT(error[1] / error[2], 2.0);
}

double hinged_strip(const Strip& s, int n) {
  const double dp = s.L / n;
  ShellCloud<2> cloud;
  for (int i = 0; i <= n; ++i)
    add<2>(cloud, {i * dp, 0.0}, {0.0, 1.0}, i % n ? dp : 0.5 * dp, s.t,
           i % n ? Support::free : Support::hinged);
  const ShellModel<2> model(cloud, s.options(dp));
  const auto state = pressed(model, s.pressure() / 5);
  const double w = 0.5 * state.displacement(n / 2)[1] +
                   0.25 * (state.displacement(n / 2 - 1)[1] + state.displacement(n / 2 + 1)[1]);
  return w / s.middle(s.pressure() / 5, s.L, 5);
}

TEST(ShellStatics, HingedStripIsOfSecondOrder) {
  for (const double t : {0.02, 0.05}) {
    const Strip s{.t = t};
    const double coarse = hinged_strip(s, 20) - 1, middle = hinged_strip(s, 40) - 1;
    EXPECT_NEAR(middle, 0.0, 0.003);
    EXPECT_GT(coarse / middle, 3.5);
  }
}

/// A cantilever between a band and a free edge, loaded on its last particle; the state, and the arm of the load.
struct Cantilever {
  ShellModel<2> model;
  ShellState<2> state;
  double arm;
  std::size_t last;

  Cantilever(const Strip& s, int n, double load, double hourglass = 1.0)
      : model(strip(n, s.L / n, s.t, 4, 0), s.options(s.L / n, hourglass)),
        state(rest(model)),
        arm((n + 0.5) * s.L / n),
        last(3 + std::size_t(n)) {
    auto loads = no_load(model);
    set_force<2>(loads, last, Vec2(0.0, load));
    find_equilibrium(model, state, loads, {.tolerance = 1e-4});
  }
};

/// Shortfall of the deflection of the loaded end against the closed formula.
double cantilever_error(int n, double hourglass) {
  const Strip s{.nu = 0.0};
  const double P = 1e-3 * 3 * s.D();
  const Cantilever beam(s, n, P, hourglass);
  const double exact = P * std::pow(beam.arm, 3) / (3 * s.D()) + P * beam.arm / s.shear();
  return 1.0 - beam.state.displacement(beam.last)[1] / exact;
}

TEST(ShellStatics, CantileverWithSmallDeflection) {
  EXPECT_NEAR(cantilever_error(40, 0.001), 0.0, 0.01);
  const double coarse = cantilever_error(40, 1.0), fine = cantilever_error(80, 1.0);
  EXPECT_NEAR(fine, 0.0, 0.01);
  EXPECT_GT(coarse / fine, 1.8);
}

// The load parameter P L^2 / D of the benchmark for the effective length.
TEST(ShellStatics, CantileverWithLargeDeflection) {
  const Strip s{.L = 10.0, .t = 0.1, .E = 1.2e6, .nu = 0.0};
  const int n = 40;
  const double arm = (n + 0.5) * s.L / n, P = 4.0 * std::pow(s.L / arm, 2);
  const Cantilever beam(s, n, P);
  const Vec2 u = beam.state.displacement(beam.last) * s.L / arm;
  EXPECT_NEAR(u[1] / 6.698, 1.0, 0.02);
  EXPECT_NEAR(-u[0] / 3.286, 1.0, 0.02);
}

/// The last two particles are pulled apart across their connection, which follows the strip: a moment M at its end. Returns
/// where the end has come, over the length, when the moment is that of a full circle.
double rolled_up(int n) {
  const Strip s{.L = 10.0, .t = 0.1, .E = 1.2e6, .nu = 0.0};
  const double dp = s.L / n, M = 2 * pi * s.D() / (s.L + dp);
  const ShellModel<2> model(strip(n, dp, s.t, 4, 0), s.options(dp));
  auto state = rest(model);
  ShellWorkspace<2> work(model);
  auto load = no_load(model);
  const std::size_t tip = model.count() - 1;
  const double dt = stable_step(model), omega = 3.5 / (s.L * s.L) * std::sqrt(s.D() / (1000 * s.t));
  const int rounds = int(40 / (omega * dt) / 10);
  for (int k = 0; k < rounds; ++k) {
    const Vec2 along = model.cloud.position[tip] + state.displacement(tip) - model.cloud.position[tip - 1] -
                       state.displacement(tip - 1);
    const Vec2 across =
        Vec2(-along[1], along[0]) * (std::min(1.0, 2.0 * k / rounds) * M / along.squaredNorm());
    set_force<2>(load, tip, across);
    set_force<2>(load, tip - 1, -across);
    advance(model, state, load, work, {dt, 10, 4 * omega});
  }
  const Vec2 end = model.cloud.position[tip] + state.displacement(tip), start = model.cloud.position[4];
  return (end - start).norm() / s.L;
}

TEST(FullShellStatics, RollUp) {
  const double coarse = rolled_up(40), fine = rolled_up(80);
  EXPECT_LT(fine, 0.025);
  EXPECT_GT(coarse / fine, 1.3);
}

}  // namespace
}  // namespace ostium::sph3d
