// Pulses in an elastic tube: how fast they run, and what a matched opening sends back.
//
// Poisson's ratio is 0: pressure then pulls at the wall around the tube only. Otherwise a second wave, of the wall along itself,
// would run ahead of the pulse.
#include <gtest/gtest.h>

#include <cstdio>

#include "tube_walls.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

constexpr double dp = 1e-3, radius = 9e-3, length = 0.24, thickness = 1e-3, rho = 1000, E = 0.4e6,
                 pulse_time = 0.016, peak_speed = 0.05, middle = radius + 0.5 * thickness;

struct Section {
  double at;
  std::vector<double> pressure = {}, speed = {};  // means over a slab, each step
};

/// A pulse of flow enters at x = 0; the other end answers with the impedance of the waves and, beside it, the compliance that
/// its clamp takes from the tube.
struct PulseTube {
  const double sound;
  TubeWall wall{radius, length, dp, thickness};
  Vessel<3> vessel;
  std::vector<Drive> drives{2};
  std::vector<double> time;
  std::vector<Section> sections{{0.06}, {0.12}, {0.18}};

  /// With the radius of the middle, since pressure acts on the inner face.
  static double moens_korteweg() { return std::sqrt(E * thickness / (2 * rho * middle)); }
  double wave_speed() const {
    return 1 / std::sqrt(1 / (sound * sound) + 1 / (moens_korteweg() * moens_korteweg()));
  }
  double impedance() const { return rho * wave_speed() / area(); }
  /// Of the length that does not widen: four spacings that are clamped, and 1/beta of the bending beside them,
  /// w = 1 - exp(-beta x) (cos beta x + sin beta x).
  double compliance_of_the_end() const {
    const double beta = std::pow(3, 0.25) / std::sqrt(middle * thickness);
    return area() * (4 * dp + 1 / beta) / (rho * moens_korteweg() * moens_korteweg());
  }
  double area() const { return vessel.model().ducts[1].opening().area; }

  explicit PulseTube(double c)
      : sound(c),
        vessel(tube(radius, length, 64, 96),
               {.dp = dp,
                .density = rho,
                .viscosity = 1e-8,
                .sound_speed = c,
                .reference_speed = 0.2,
                .density_relaxation = 0.2},
               {{.flow_driven = true, .profile = Profile::plug}, {}}) {
    const ShellOptions options{
        .spacing = dp, .density = rho, .material = SaintVenantKirchhoff({.E = E, .nu = 0})};
    vessel.set_wall(std::make_unique<DeformableWall<3>>(ShellModel<3>(wall.cloud, options), wall.contact,
                                                        vessel.model().reach(), SurroundingsOfWall{}));
  }

  void answer(double flow, double dt) {
    PortLaw& law = drives[1].law;
    drives[1].since = vessel.time();
    law.p_star += law.slope * dt;
    law.slope = (flow - law.p_star / impedance()) / compliance_of_the_end();
  }

  /// Means of the fluid around each section.
  void measure() {
    std::vector<double> psi(sections.size()), v(sections.size()), n(sections.size());
    const auto& fluid = vessel.state().fluid;
    for (std::size_t i = 0; i < fluid.places(); ++i)
      for (std::size_t k = 0; k < sections.size(); ++k)
        if (fluid.filled[i] && std::abs(fluid.position[i][0] - sections[k].at) < 3 * dp)
          psi[k] += fluid.psi(i), v[k] += fluid.velocity(i)[0], n[k] += 1;
    time.push_back(vessel.time());
    for (std::size_t k = 0; k < sections.size(); ++k) {
      sections[k].pressure.push_back(rho * sound * sound * psi[k] / n[k]);
      sections[k].speed.push_back(v[k] / n[k]);
    }
  }

  void run(double end) {
    while (vessel.time() < end) {
      const double t = vessel.time(), x = (t - 2.5 * pulse_time) / pulse_time,
                   flow = peak_speed * area() * std::exp(-x * x);
      drives[0].since = t;
      drives[0].flow_in = flow;
      drives[0].flow_slope = -2 * x / pulse_time * flow;
      const double before = vessel.volume_out(1), filter_time = 0.01;
      vessel.advance(end - t, drives, filter_time);
      const double dt = vessel.time() - t;
      answer((vessel.volume_out(1) - before) / dt, dt);
      vessel.port(1).filter.step_counted((vessel.volume_out(1) - before) / dt, dt, filter_time);
      measure();
    }
  }

  /// When the pulse passes: the middle of it, where it is more than a tenth of its peak.
  double arrival(const Section& s) const {
    const double peak = *std::max_element(s.pressure.begin(), s.pressure.end());
    double sum = 0, moment = 0;
    for (std::size_t n = 1; n < time.size(); ++n) {
      const double p = std::max(s.pressure[n] - 0.1 * peak, 0.0) * (time[n] - time[n - 1]);
      sum += p, moment += p * time[n];
    }
    return moment / sum;
  }
};

void runs_at_the_right_speed(double sound) {
  PulseTube tube(sound);
  const double expected = tube.wave_speed();
  tube.run(5 * pulse_time + length / expected + 0.01);
  const auto& s = tube.sections;
  const double first = (s[1].at - s[0].at) / (tube.arrival(s[1]) - tube.arrival(s[0])),
               both = (s[2].at - s[0].at) / (tube.arrival(s[2]) - tube.arrival(s[0]));
  double forward = 0, backward = 0;
  const double passed = tube.arrival(s[1]);  // before, the fluid still comes to rest: 10 Pa
  for (std::size_t n = 0; n < tube.time.size(); ++n) {
    const double ru = rho * expected * s[1].speed[n];
    forward = std::max(forward, std::abs(s[1].pressure[n] + ru) / 2);
    if (tube.time[n] > passed) backward = std::max(backward, std::abs(s[1].pressure[n] - ru) / 2);
  }
  std::printf(
      "c %.0f, c_MK %.3f, both %.3f m/s: measured %.3f (first half %.3f), %.4f of it; backward %.4f of %.1f "
      "Pa\n",
      sound, PulseTube::moens_korteweg(), expected, both, first, both / expected, backward / forward,
      forward);
  EXPECT_NEAR(both, expected, 0.02 * expected);
  EXPECT_LT(backward, 0.03 * forward + 1e-5 * rho * sound * sound);  // the restlessness of the fluid
  EXPECT_EQ(tube.vessel.state().escaped, 0);
}
TEST(FullPulseWaves, MoensKortewegAtThreeTimesItsSpeed) { runs_at_the_right_speed(15); }
TEST(FullPulseWaves, MoensKortewegAtFiveTimesItsSpeed) { runs_at_the_right_speed(25); }

}  // namespace
}  // namespace ostium::sph3d
