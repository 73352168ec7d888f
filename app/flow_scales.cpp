#include "app/flow_scales.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ostium::app {
namespace {

constexpr double least_speed = 1e-4;  // m/s, for a case without any prescribed flow
constexpr int samples = 500;

struct Inflow {
  double peak = 0, rate = 0;  // m3/s, m3/s2: of all prescribed flows together
  double first = 0;           // m3/s, the same at the start
  double speed = 0;           // m/s, mean velocity at the opening
};

/// Peak velocity over mean velocity of a profile.
template <int D>
double peak_factor(sph3d::Profile profile) {
  return profile == sph3d::Profile::plug ? 1.2 : D == 2 ? 1.5 : 2.0;
}

template <int D>
Inflow inflow_of(const Setup<D>& setup, const network::Network& network, double span) {
  Inflow inflow;
  double before = 0;
  for (int i = 0; i <= samples; ++i) {
    double sum = 0;
    for (int k = 0; k < network.port_count(); ++k) {
      if (network.kind(k) != network::PortKind::flow) continue;
      const double q = std::abs(network.flow_into_vessel(k, span * i / samples));
      sum += q;
      inflow.speed = std::max(inflow.speed, peak_factor<D>(setup.profiles[k]) * q / network.port(k).area);
    }
    inflow.peak = std::max(inflow.peak, sum);
    if (i == 0) inflow.first = sum;
    if (i > 0) inflow.rate = std::max(inflow.rate, std::abs(sum - before) * samples / span);
    before = sum;
  }
  return inflow;
}

/// Share of the inflow that leaves through each opening.
std::vector<double> shares(const network::Network& network, const std::optional<network::Start>& start) {
  std::vector<double> share(network.port_count(), 0.0);
  double sum = 0;
  for (int k = 0; k < network.port_count(); ++k) {
    if (network.kind(k) == network::PortKind::flow) continue;
    share[k] = start ? std::max(start->mean_port_flow[k], 0.0) : network.port(k).area;
    sum += share[k];
  }
  for (double& s : share) s = sum > 0 ? s / sum : 0.0;
  return share;
}

/// How far the pressure gets away from the moving datum, Pa: never farther than it swings at all.
double seen_swing(const std::optional<network::Start>& start, double datum_time) {
  if (!start) return 0.0;
  const double swing = start->max_pressure - start->min_pressure;
  return datum_time > 0 ? std::min(datum_time * start->max_pressure_rate, swing) : swing;
}

/// A fluid faster than its own sound is none; below ten times the velocity its density varies by more than 1 %.
void check_sound_speed(const Case& study, double speed) {
  constexpr double least = 3.0, good = 10.0;
  if (!study.fluid.sound_speed || *study.fluid.sound_speed >= least * speed) return;
  study.fluid.origin.at("sound_speed")
      .error(
          "the sound speed of {:.3g} m/s is too low for blood that may reach {:.3g} m/s here; choose {:.3g} "
          "m/s or more, "
          "or leave it out",
          *study.fluid.sound_speed, speed, good * speed);
}

}  // namespace

/// Two periods of the blood that swings between an inlet of prescribed flow and an outlet of prescribed pressure (a quarter
/// wave), which a half cosine then leaves all but at rest; where the wall moves, three transits of its waves.
double start_ramp(const FlowScales& scales) {
  const bool moves = scales.wall.pulse_speed > 0;
  const double transits = moves ? 3.0 : 8.0,
               c = moves ? scales.wall.effective_speed(scales.sound_speed) : scales.sound_speed;
  return std::max(0.01, transits * scales.length / c);
}

template <int D>
FlowScales flow_scales(const Case& study, const Setup<D>& setup, const std::optional<network::Start>& start) {
  const network::Network network(setup.model, setup.ports);
  const Inflow inflow = inflow_of(setup, network, study.time.period.value_or(study.time.final()));
  const auto share = shares(network, start);
  FlowScales scales;
  double widest = 0;  // 1/m2, mean velocity over the inflow, largest
  scales.speed = std::max(inflow.speed, least_speed);
  for (int k = 0; k < network.port_count(); ++k) {
    const double factor = peak_factor<D>(sph3d::Profile::parabolic) * share[k] / network.port(k).area;
    scales.speed =
        std::max(scales.speed, 0.75 * factor * inflow.peak);  // outlets are short of a full parabola
    widest = std::max(widest, share[k] / network.port(k).area);
  }
  check_sound_speed(study, scales.speed);
  const double rho = study.fluid.density;
  scales.length = sph3d::length_between_openings(setup.lumen);
  scales.wall = wall_scales(study, setup.lumen);
  scales.sound_speed = study.fluid.sound_speed.value_or(
      std::max(10.0 * scales.speed, sound_over_pulse * scales.wall.pulse_speed));
  const double rise = 0.5 * std::numbers::pi * inflow.first / start_ramp(scales);  // m3/s2, a half cosine
  scales.inner_pressure =
      0.5 * rho * scales.speed * scales.speed + rho * scales.length * widest * std::max(inflow.rate, rise);
  scales.datum_time =
      study.coupling.datum_time.value_or(std::clamp(0.125 * scales.length / scales.sound_speed, 2e-3, 5e-3));
  scales.background = scales.inner_pressure + seen_swing(start, scales.datum_time);
  return scales;
}

template FlowScales flow_scales(const Case&, const Setup<2>&, const std::optional<network::Start>&);
template FlowScales flow_scales(const Case&, const Setup<3>&, const std::optional<network::Start>&);

}  // namespace ostium::app
