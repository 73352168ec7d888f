// Wall shear stress and pressure of flows with exact solutions: developed and swinging flow between plates, flow in a tube.
#include <gtest/gtest.h>

#include <complex>
#include <cstdio>

#include "sph3d/fields/wall_cycle.hpp"
#include "sph3d/fields/wall_gradient.hpp"
#include "sph3d/fields/wall_loads.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

constexpr double d = 1e-3, rho = 1000, eta = 2.5e-4, u_max = 0.0125,
                 c = 20 * u_max;  // Re = 50 between plates

template <int D>
FluidOptions<D> options(int across, double sound_speed) {
  return {.dp = d / across,
          .density = rho,
          .viscosity = eta / rho,
          .sound_speed = sound_speed,
          .reference_speed = u_max,
          .density_relaxation = 0.2};
}

/// The wall points in the middle half of a vessel along the first axis.
template <int D>
struct Middle {
  std::vector<std::size_t> point;
  std::vector<double> x;

  Middle(const std::vector<WallPoint<D>>& wall, double length) {
    for (std::size_t a = 0; a < wall.size(); ++a)
      if (std::abs(wall[a].position[0] - 0.5 * length) < 0.25 * length)
        point.push_back(a), x.push_back(wall[a].position[0]);
  }
  /// Mean of f(a, x).
  template <class F>
  double mean(F&& f) const {
    double sum = 0;
    for (std::size_t k = 0; k < point.size(); ++k) sum += f(point[k], x[k]);
    return sum / double(point.size());
  }
  double stress(const std::vector<Vec<D>>& stress) const {
    return mean([&](std::size_t a, double) { return stress[a][0]; });
  }
  /// Root mean square of the distance from a uniform stress.
  double distance(const std::vector<Vec<D>>& stress, double exact) const {
    return std::sqrt(
        mean([&](std::size_t a, double) { return (stress[a] - exact * Vec<D>::Unit(0)).squaredNorm(); }));
  }
};

/// Stresses over the exact one, pressures over the exact drop.
struct Developed {
  double force = 0, gradient = 0;              // mean stress of both measures
  double rough_force = 0, rough_gradient = 0;  // deviation of values at one point and time
  double osi = 0;                              // largest
  double slope = 0;                            // of the pressure along the wall, averaged over time
  double pressure = 0, worst_pressure = 0;     // distance of that pressure from the exact line: rms, largest
};

template <int D>
void measure_pressure(const Middle<D>& middle, const std::vector<double>& p, double exact_slope,
                      double length, Developed& m) {
  const double mean_x = middle.mean([](std::size_t, double x) { return x; }),
               mean_p = middle.mean([&](std::size_t a, double) { return p[a]; });
  m.slope = -middle.mean([&](std::size_t a, double x) { return (x - mean_x) * p[a]; }) /
            middle.mean([&](std::size_t, double x) { return (x - mean_x) * (x - mean_x); }) / exact_slope;
  m.pressure = std::sqrt(middle.mean([&](std::size_t a, double x) {
    const double off = (p[a] - mean_p + exact_slope * (x - mean_x)) / (exact_slope * length);
    m.worst_pressure = std::max(m.worst_pressure, std::abs(off));
    return off * off;
  }));
}

/// Steady flow along the first axis, over the second half of the time; exact stress, and exact pressure gradient, Pa/m.
template <int D>
Developed developed(const Lumen<D>& lumen, int across, double mean_speed, double stress, double slope,
                    double end) {
  const double length = lumen.openings[1].centre[0], p = 0.2;
  Vessel<D> vessel(lumen, options<D>(across, 10 * u_max), {{true, Profile::parabolic}, {}}, p);
  WallSampler<D> sampler(vessel);
  const Middle<D> middle(sampler.points(), length);
  std::vector<Drive> drives(2);
  drives[1].law.p_star = p;
  WallCycle<D> cycle;
  Developed m;
  int samples = 0;
  while (vessel.time() < end) {
    drives[0].since = vessel.time();
    drives[0].flow_in = mean_speed * lumen.openings[0].area * std::min(1.0, vessel.time() / (0.2 * end));
    vessel.advance(1, drives, 0.01);
    if (vessel.time() < 0.5 * end) continue;
    sampler.sample(vessel);
    const auto& force = sampler.loads().shear_stress;
    take(cycle, vessel.time(), force, sampler.loads().pressure, 0.0, 0.5 * end / (40 * pi));
    if (vessel.state().steps % 16 != 0) continue;
    const auto gradient = shear_stress_from_gradient(vessel, sampler.points());
    m.gradient += middle.stress(gradient) / stress;
    m.rough_force += middle.distance(force, stress) / stress;
    m.rough_gradient += middle.distance(gradient, stress) / stress;
    ++samples;
  }
  m.gradient /= samples, m.rough_force /= samples, m.rough_gradient /= samples;
  const auto fields = fields_of(cycle);
  m.force = middle.stress(fields.mean_stress) / stress;
  for (const auto a : middle.point) m.osi = std::max(m.osi, fields.osi(a));
  measure_pressure(middle, fields.mean_pressure, slope, length, m);
  std::printf(
      "%dD, %d across: stress %.4f (forces) %.4f (gradient), single values off by %.3f and %.3f; OSI %.1e; "
      "pressure: slope %.4f, off the line by %.4f, at most %.4f\n",
      D, across, m.force, m.gradient, m.rough_force, m.rough_gradient, m.osi, m.slope, m.pressure,
      m.worst_pressure);
  return m;
}

Developed plates(int across, double end) {
  return developed<2>(channel(3 * d, d), across, u_max * 2 / 3, 4 * eta * u_max / d,
                      8 * eta * u_max / (d * d), end);
}

TEST(WallStress, BetweenPlates16Across) {
  const Developed m = plates(16, 1.6);
  EXPECT_NEAR(m.force, 1, 0.04);
  EXPECT_NEAR(m.gradient, 1, 0.04);
  EXPECT_LT(m.osi, 0.002);
  EXPECT_NEAR(m.slope, 1, 0.03);
}

TEST(FullWallStress, BetweenPlates30Across) {
  const Developed m = plates(30, 2.0);
  EXPECT_NEAR(m.force, 1, 0.03);
  EXPECT_NEAR(m.gradient, 1, 0.03);
  EXPECT_LT(m.osi, 0.001);
  EXPECT_NEAR(m.slope, 1, 0.03);
  EXPECT_LT(m.pressure, 0.02);  // a ten-thousandth of rho c^2
}

TEST(FullWallStress, InATube30Across) {
  const Developed m = developed<3>(tube(0.5 * d, 1.5 * d, 128), 30, 0.5 * u_max, 4 * eta * u_max / d,
                                   16 * eta * u_max / (d * d), 0.6);
  EXPECT_NEAR(m.force, 1, 0.03);
  EXPECT_NEAR(m.gradient, 1, 0.03);
  EXPECT_LT(m.osi, 0.002);
  EXPECT_NEAR(m.slope, 1, 0.03);
  EXPECT_LT(m.pressure, 0.02);  // a ten-thousandth of rho c^2
}

double mean_velocity(const Vessel<2>& vessel, double from, double to) {
  const auto& fluid = vessel.state().fluid;
  double sum = 0;
  int n = 0;
  for (std::size_t i = 0; i < fluid.places(); ++i)
    if (fluid.filled[i] && fluid.position[i][0] > from && fluid.position[i][0] < to)
      sum += fluid.velocity(i)[0], ++n;
  return sum / n;
}

/// First harmonic of the stress of both measures over the exact one; arguments are errors of the phase.
struct Swing {
  std::complex<double> force, gradient;
  double tawss = 0, osi = 1;  // over the exact one; least
};

/// Flow between plates under a swinging pressure gradient K (Womersley 1955, for plates), lambda = alpha sqrt(i): mean velocity
/// U = K (1 - tanh(lambda) / lambda) / (i omega rho), stress of the wall K H tanh(lambda) / lambda. The exact stress is that of
/// the measured U. Over the last of some cycles.
Swing swinging(int across, double alpha, int cycles) {
  using Complex = std::complex<double>;
  const double H = 0.5 * d, omega = alpha * alpha * eta / rho / (H * H), T = 2 * pi / omega, length = 2 * d;
  const Complex lambda = alpha * std::sqrt(Complex(0, 1)),
                over_U = Complex(0, omega * rho) * H / (lambda / std::tanh(lambda) - 1.0);
  const double K = rho * omega * u_max / std::abs(1.0 - 1.0 / std::cosh(lambda)), base = K * length;
  Vessel<2> vessel(channel(length, d), options<2>(across, 20 * u_max), {{}, {}}, base);
  WallSampler<2> sampler(vessel);
  const Middle<2> middle(sampler.points(), length);
  std::vector<Drive> drives(2);
  WallCycle<2> cycle;
  Swing swing;
  Complex U = 0;
  while (vessel.time() < cycles * T * (1 - 1e-9)) {
    const double t = vessel.time();
    for (int k = 0; k < 2; ++k) {
      const double swings = (k == 0 ? 0.5 : -0.5) * K * length;
      drives[k].since = t;
      drives[k].law = {.p_star = base + swings * std::cos(omega * t),
                       .slope = -swings * omega * std::sin(omega * t)};
    }
    const double dt = vessel.advance(cycles * T - t, drives, 0.01).dt, now = vessel.time();
    if (now < (cycles - 1) * T) continue;
    sampler.sample(vessel);
    const auto& force = sampler.loads().shear_stress;
    take(cycle, now, force, sampler.loads().pressure, 0.0, T / (40 * pi));
    const Complex wave = 2 / T * dt * std::exp(Complex(0, -omega * now));
    swing.force += middle.stress(force) * wave;
    swing.gradient += middle.stress(shear_stress_from_gradient(vessel, sampler.points())) * wave;
    U += mean_velocity(vessel, 0.25 * length, 0.75 * length) * wave;
  }
  const Complex exact = U * over_U;
  swing.force /= exact, swing.gradient /= exact;
  const auto fields = fields_of(cycle);
  swing.tawss =
      middle.mean([&](std::size_t a, double) { return fields.tawss[a]; }) * pi / 2 / std::abs(exact);
  for (const auto a : middle.point) swing.osi = std::min(swing.osi, fields.osi(a));
  std::printf(
      "%d across, alpha %.1f: amplitude %.4f phase %+.2f deg (forces), %.4f %+.2f deg (gradient); TAWSS "
      "%.4f, "
      "OSI at least %.4f\n",
      across, alpha, std::abs(swing.force), std::arg(swing.force) * 180 / pi, std::abs(swing.gradient),
      std::arg(swing.gradient) * 180 / pi, swing.tawss, swing.osi);
  return swing;
}

TEST(WallStress, SwingingBetweenPlates16Across) {
  const Swing swing = swinging(16, 2.5, 3);
  EXPECT_LT(std::abs(swing.force - 1.0), 0.12);
  EXPECT_LT(std::abs(swing.gradient - 1.0), 0.12);
  EXPECT_NEAR(swing.tawss, 1, 0.05);
  EXPECT_GT(swing.osi, 0.48);
}

/// Stress and velocity near the wall lag behind by 4 degrees at 16 across: an error of first order of the flow, not of its
/// measures, which agree.
TEST(FullWallStress, SwingingBetweenPlatesConverges) {
  const Swing at16 = swinging(16, 2.5, 3), at32 = swinging(32, 2.5, 3);
  EXPECT_GT(std::log2(std::abs(at16.gradient - 1.0) / std::abs(at32.gradient - 1.0)), 0.7);
  EXPECT_LT(std::abs(at32.force - 1.0), 0.06);
  EXPECT_LT(std::abs(at32.gradient - 1.0), 0.06);
  EXPECT_NEAR(at32.tawss, 1, 0.03);
  EXPECT_GT(at32.osi, 0.48);
}

}  // namespace
}  // namespace ostium::sph3d
