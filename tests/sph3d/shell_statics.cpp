// Equilibria of strips in the plane against closed formulas.
#include <gtest/gtest.h>

#include "shell_clouds.hpp"
#include "sph3d/shell/equilibrium.hpp"
#include "sph3d/shell/recover.hpp"

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
  ShellOptions options(double dp, double hourglass = 0.1) const {
    return {.spacing = dp,
            .material = SaintVenantKirchhoff(elastic(E, nu)),
            .hourglass = hourglass,
            .rotary_scaling = true};
  }
};

ShellState<2> pressed(const ShellModel<2>& model, double p) {
  auto state = rest(model);
  auto load = no_load(model);
  for (auto& block : load)
    for (double& x : block.pressure) x = p;
  find_equilibrium(model, state, load, {.tolerance = 1e-7});
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

// With the default the clamp lies nearer to the band. Whatever its place, it goes with the spacing: extrapolated twice the
// deflection is that of the ideal clamp.
TEST(ShellStatics, ClampedStripConverges) {
  const Strip s;
  const double coarse = clamped_strip(s, 20, 0.1, s.L), middle = clamped_strip(s, 40, 0.1, s.L),
               fine = clamped_strip(s, 80, 0.1, s.L);
  const double first = 2 * middle - coarse, second = 2 * fine - middle;
  EXPECT_NEAR((4 * second - first) / 3, 1.0, 0.006);
  EXPECT_NEAR((middle - 1) / (fine - 1), 2.0, 0.2);
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

  Cantilever(const Strip& s, int n, double load, double hourglass)
      : model(strip(n, s.L / n, s.t, 4, 0), s.options(s.L / n, hourglass)),
        state(rest(model)),
        arm((n + 0.5) * s.L / n),
        last(3 + std::size_t(n)) {
    auto loads = no_load(model);
    set_force<2>(loads, last, Vec2(0.0, load));
    find_equilibrium(model, state, loads, {.tolerance = 1e-7});
  }
};

TEST(ShellStatics, CantileverWithSmallDeflection) {
  const Strip s{.nu = 0.0};
  const double P = 1e-3 * 3 * s.D();
  const Cantilever beam(s, 40, P, 0.001);
  const double exact = P * std::pow(beam.arm, 3) / (3 * s.D()) + P * beam.arm / s.shear();
  EXPECT_NEAR(beam.state.displacement(beam.last)[1] / exact, 1.0, 0.01);
}

TEST(ShellStatics, CantileverWithLargeDeflection) {
  const Strip s{.L = 10.0, .t = 0.1, .E = 1.2e6, .nu = 0.0};
  for (int n : {40, 80}) {
    // the load parameter P L^2 / D of the benchmark for the effective length
    const double arm = (n + 0.5) * s.L / n, P = 4.0 * std::pow(s.L / arm, 2);
    const Cantilever beam(s, n, P, 0.001);
    const Vec2 u = beam.state.displacement(beam.last) * s.L / arm;
    EXPECT_NEAR(u[1] / 6.698, 1.0, 0.02);
    EXPECT_NEAR(-u[0] / 3.286, 1.0, 0.02);
  }
}

}  // namespace
}  // namespace ostium::sph3d
