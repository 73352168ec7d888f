// The volume solid against exact solutions: bending, thick cylinders, vibration, damping, energy.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "solid_bodies.hpp"

namespace ostium::sph3d {
namespace {

using namespace bodies;

constexpr double density = 1000.0, E = 1e6;

/// A beam along x of height one in y (and width one in z), the middle of its left end face at the origin.
template <int D>
SolidCloud<D> beam(double length, double dp, double beyond = 0.0) {
  Vec<D> lower = Vec<D>::Constant(-0.5), upper = Vec<D>::Constant(0.5);
  lower[0] = -beyond, upper[0] = length;
  return box<D>(lower, upper, dp);
}

/// Modulus of a fibre of the beam: in 2D the strain across the plane is zero.
template <int D>
double beam_modulus(const Moduli& m) {
  return D == 2 ? m.plate() : m.E;
}

/// Tractions t(y) along direction d on the end face at x, per area.
template <int D>
TractionPatch<D> on_end(const SolidModel<D>& m, double x, int d, const std::function<double(double)>& t) {
  const double dp = m.options.spacing;
  TractionPatch<D> patch;
  for (std::size_t a = 0; a < m.count(); ++a) {
    const Vec<D>& X = m.cloud.position[a];
    if (std::abs(X[0] - x) > 0.6 * dp) continue;
    patch.particle.push_back(static_cast<int>(a));
    patch.force.push_back(t(X[1]) * std::pow(dp, D - 1) * Vec<D>::Unit(d));
    patch.to_surface.push_back((x - X[0]) * Vec<D>::Unit(0));
  }
  return patch;
}

/// Curvature of the axis over the middle half, from a fit of a parabola, over that of the end moments.
template <int D>
double bent(double nu, int layers, double slenderness = 8.0) {
  const double dp = 1.0 / layers, L = slenderness, kappa = 1e-5;
  const Moduli moduli = elastic(E, nu);
  const auto m = make_solid<D>(beam<D>(L, dp),
                               {.material = SaintVenantKirchhoff(moduli), .density = density, .spacing = dp});
  // Midpoint sums of y^2 over the layers fall short of the integral by this factor: the moment is to be exact.
  const double stress = beam_modulus<D>(moduli) * kappa / (1.0 - dp * dp);
  const auto state = settled<D>(m,
                                {.tractions = {on_end<D>(m, L, 0, [&](double y) { return stress * y; }),
                                               on_end<D>(m, 0, 0, [&](double y) { return -stress * y; })}},
                                22.37 / (L * L) * std::sqrt(beam_modulus<D>(moduli) / 12.0 / density), 2.5);
  double n = 0, x2 = 0, x4 = 0, v = 0, vx2 = 0;
  for (std::size_t a = 0; a < m.count(); ++a) {
    const double x = m.cloud.position[a][0] - 0.5 * L, u = state.displacement[a][1];
    if (std::abs(x) > 0.25 * L || std::abs(m.cloud.position[a][1]) > 0.6 * dp) continue;
    n += 1, x2 += x * x, x4 += x * x * x * x, v += u, vx2 += u * x * x;
  }
  return -2.0 * (vx2 * n - v * x2) / (x4 * n - x2 * x2) / kappa;
}

TEST(SolidBeam, BendsUnderEndMomentsWithSecondOrder) {
  const double coarse = bent<2>(0.3, 6) - 1.0, fine = bent<2>(0.3, 12) - 1.0;
  EXPECT_LT(std::abs(coarse), 0.12);
  EXPECT_LT(std::abs(fine), 0.03);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
}

/// Stays near what it is at nu = 0.3 (1.03): locked, it would fall to the inverse ratio of bulk and shear modulus.
TEST(SolidBeam, DoesNotLock) { EXPECT_NEAR(bent<2>(0.49, 8), 1.02, 0.02); }

/// Sag of the end of a cantilever under a shear force on its end face, over that of Timoshenko's beam. Held rows stand beyond the
/// clamped face; the clamp acts where their motion would vanish.
template <int D>
double sagged(double nu, int layers, double L = 8.0) {
  const double dp = 1.0 / layers;
  const Moduli moduli = elastic(E, nu);
  const double EI = beam_modulus<D>(moduli) / 12.0, P = 1e-6 * EI;
  auto cloud = beam<D>(L, dp, 3 * dp);
  hold<D>(cloud, [](const Vec<D>& X) { return X[0] < 0.0; });
  const auto m =
      make_solid<D>(cloud, {.material = SaintVenantKirchhoff(moduli), .density = density, .spacing = dp});
  // The shear stress of a beam is a parabola over its height.
  const auto load = on_end<D>(m, L, 1, [&](double y) { return -1.5 * P * (1.0 - 4.0 * y * y); });
  const auto state = settled<D>(m, {.tractions = {load}}, 3.516 / (L * L) * std::sqrt(EI / density), 2.5);
  const double sag = -mean_displacement<D>(m, state, [&](const Vec<D>& X) { return X[0] > L - dp; })[1];
  const double x = L - 0.5 * dp;  // where the last particles are
  return sag / (P * x * x * (3.0 * L - x) / (6.0 * EI) + P * x / (5.0 / 6.0 * moduli.mu()));
}

TEST(SolidBeam, CantileverSagsAsTimoshenkos) {
  const double coarse = sagged<2>(0.3, 6) - 1.0, fine = sagged<2>(0.3, 12) - 1.0;
  EXPECT_LT(std::abs(coarse), 0.18);
  EXPECT_LT(std::abs(fine), 0.06);
  EXPECT_GT(std::log2(coarse / fine), 1.5);
}

TEST(FullSolidBeam, InThreeDimensions) {
  const double bent_coarse = bent<3>(0.3, 4) - 1.0, bent_fine = bent<3>(0.3, 8) - 1.0;
  EXPECT_LT(std::abs(bent_fine), 0.06);
  EXPECT_GT(std::log2(bent_coarse / bent_fine), 1.7);
  const double coarse = sagged<3>(0.3, 4, 5.0) - 1.0, fine = sagged<3>(0.3, 8, 5.0) - 1.0;
  EXPECT_LT(std::abs(fine), 0.12);
  EXPECT_GT(std::log2(coarse / fine), 1.5);
}

/// Not a test: prints the tables of docs/theory/solid.md (--gtest_also_run_disabled_tests).
TEST(SolidBeam, DISABLED_Table) {
  for (const double nu : {0.0, 0.3, 0.45, 0.49, 0.499})
    for (const int layers : {4, 6, 8, 12, 16})
      fmt::print("nu {} layers {}: bent {:.4f} sagged {:.4f}\n", nu, layers, bent<2>(nu, layers),
                 sagged<2>(nu, layers));
  for (const int layers : {4, 6, 8})
    fmt::print("3D layers {}: bent {:.4f} sagged {:.4f}\n", layers, bent<3>(0.3, layers),
               sagged<3>(0.3, layers, 5.0));
}

/// A bar along x that may not move across: waves of pressure alone.
struct Bar {
  SolidModel<2> model;
  double length = 1.0, c = 0;
};

Bar bar(double dp, double damping) {
  const Moduli tissue = elastic(E, 0.3);
  auto cloud = box<2>(Vec2::Zero(), Vec2(1.0, 8 * dp), dp);
  cloud.held.assign(cloud.count(), 2);
  return {
      .model = make_solid<2>(
          cloud,
          {.material = SaintVenantKirchhoff(tissue), .density = density, .spacing = dp, .damping = damping}),
      .c = std::sqrt(tissue.p_wave() / density)};
}

struct Vibration {
  double omega = 0, decay = 0;
};

/// First mode of the free bar: instants at which the velocity of its ends changes sign, and what is left at the last of them.
Vibration vibration(const Bar& bar, int half_periods) {
  const auto& m = bar.model;
  auto state = at_rest(m);
  const auto mode = [&](std::size_t a) { return std::cos(pi * m.cloud.position[a][0] / bar.length); };
  for (std::size_t a = 0; a < m.count(); ++a) state.velocity[a][0] = 1e-6 * mode(a);
  const auto part = [&] {
    double v = 0, n = 0;
    for (std::size_t a = 0; a < m.count(); ++a) v += state.velocity[a][0] * mode(a), n += mode(a) * mode(a);
    return v / n / 1e-6;
  };
  SolidWorkspace<2> work;
  double before = 1.0, last = 0.0, largest = 1.0;
  for (int changes = 0; changes < half_periods;) {
    advance(m, state, {}, stable_step(m, state, work, 0.3), work);
    const double now = part();
    if (now * before < 0) {
      last = state.time - state.last_step * now / (now - before), ++changes;
      if (changes < half_periods) largest = 0;
    }
    largest = std::max(largest, std::abs(now)), before = now;
  }
  const double omega =
      (half_periods - 0.5) * pi / last;  // the first change is a quarter of a period after the start
  return {omega, -std::log(largest) / (last - pi / (2 * omega))};
}

TEST(SolidWaves, FreeBarRingsAtItsFrequency) {
  const auto coarse = bar(1.0 / 20, 0.0), fine = bar(1.0 / 40, 0.0);
  const double exact = pi * fine.c;
  const double error_coarse = vibration(coarse, 8).omega / exact - 1,
               error_fine = vibration(fine, 8).omega / exact - 1;
  RecordProperty("coarse", std::to_string(error_coarse));
  RecordProperty("fine", std::to_string(error_fine));
  EXPECT_LT(std::abs(error_fine), 0.003);
  EXPECT_GT(std::log2(std::abs(error_coarse / error_fine)), 1.7);
}

/// Kelvin-Voigt: S = M E + eta dE/dt damps a mode at the rate eta omega^2 / (2 M).
TEST(SolidWaves, DampingIsThatOfTheMaterial) {
  const auto damped = bar(1.0 / 40, 0.5);
  const auto found = vibration(damped, 6);
  const double M = density * damped.c * damped.c,
               rate = damped.model.viscosity * std::pow(pi * damped.c, 2) / (2 * M);
  EXPECT_NEAR(found.decay, rate, 0.05 * rate);
}

/// Ten periods of large motion with the damping off.
TEST(SolidWaves, CantileverSwingsFarWithoutLosingEnergy) {
  const double L = 6.0, dp = 1.0 / 6.0;
  auto cloud = beam<2>(L, dp, 3 * dp);
  hold<2>(cloud, [](const Vec2& X) { return X[0] < 0.0; });
  const auto m = make_solid<2>(
      cloud, {.material = NeoHookean(elastic(E, 0.45)), .density = density, .spacing = dp, .damping = 0.0});
  auto state = at_rest(m);
  const double period = 2 * pi * L * L / (3.516 * std::sqrt(elastic(E, 0.45).plate() / 12 / density));
  for (std::size_t a = 0; a < m.count(); ++a)
    if (!m.cloud.held[a]) state.velocity[a][1] = 4.0 * std::pow(m.cloud.position[a][0] / L, 2);
  const double start = energy(m, state).total();
  SolidWorkspace<2> work;
  double farthest = 0, drift = 0;
  for (int step = 0; state.time < 10 * period; ++step) {
    advance(m, state, {}, stable_step(m, state, work), work);
    if (step % 50) continue;
    drift = std::max(drift, std::abs(energy(m, state).total() / start - 1));
    farthest =
        std::max(farthest, mean_displacement<2>(m, state, [&](const Vec2& X) { return X[0] > L - dp; })[1]);
  }
  RecordProperty("drift", fmt::format("{:.2e}", drift));
  RecordProperty("farthest", fmt::format("{:.2f}", farthest));
  EXPECT_GT(farthest, 0.15 * L);
  EXPECT_LT(drift, 0.01);
}

}  // namespace
}  // namespace ostium::sph3d
