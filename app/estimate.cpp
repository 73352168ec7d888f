#include "app/estimate.hpp"

#include <algorithm>
#include <cmath>

#include "app/coupled_options.hpp"
#include "app/wall_setup.hpp"
#include "core/error.hpp"

namespace ostium::app {
namespace {

constexpr double smoothing_ratio = 1.3;
/// Of a run of 317 000 particles at its peak, with the copies kept for ordering and for failures.
constexpr double bytes_per_particle = 1260, bytes_of_program = 5e7;

/// In an acoustic step a particle of a moving wall, with its share of the exchange, takes as long as so many of the blood
/// (an aorta and a pipe).
constexpr double like_blood = 14;

/// A solid's particle takes in one of its own steps as long as this share of one of the blood in an acoustic step (T-pipe).
constexpr double solid_like_blood = 0.6;

/// Of the wall in one acoustic step of dt, in particles of the blood.
template <int D>
double wall_work(const Case& study, const WallPlan<D>& plan, double dt) {
  const auto particles = static_cast<double>(particles_of(plan));
  if (!is_solid(plan)) return like_blood * particles;
  const WallCase& w = study.vessel->wall;
  const double spacing = 2.0 * std::get<sph3d::WallCloud<D>>(plan).inner.depth,
               c = sph3d::wave_speed(sph3d::elastic(w.material->E, w.material->nu).p_wave(),
                                     w.density.value_or(usual_wall_density)),
               step = 0.6 * spacing / c;
  return solid_like_blood * particles * std::max(1.0, dt / step);
}

/// Particles of the vessel and of its ducts.
template <int D>
double all_particles(const Case& study, const sph3d::Lumen<D>& lumen) {
  double ducts = 0;
  for (const auto& opening : lumen.openings) ducts += opening.area * sph3d::Duct<D>::layers;
  return particle_count(study, lumen) + ducts / std::pow(study.vessel->spacing, D - 1);
}

template <int D>
void count_steps(const sph3d::FluidOptions<D>& o, double speed, double end, Estimate& e) {
  const double h = smoothing_ratio * o.dp;
  const double acoustic = o.acoustic_cfl * h / (o.sound_speed + speed);
  const double mean = std::max(0.5 * (o.reference_speed + speed), o.viscosity / h);
  const double advection = std::clamp(o.advection_cfl * h / mean, acoustic, o.most_acoustic_steps * acoustic);
  e.steps = std::ceil(end / std::min(acoustic, end));
  e.advection_steps = std::ceil(end / std::min(advection, end));
}

}  // namespace

std::string count_text(double count) {
  if (count < 1e4) return fmt::format("{:.0f}", count);
  return count < 999.5e3 ? fmt::format("{:.3g} thousand", count / 1e3)
                         : fmt::format("{:.3g} million", count / 1e6);
}

std::string duration_text(double seconds) {
  if (seconds < 9.5) return fmt::format("{:.1g} s", std::max(seconds, 0.1));
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

template <int D>
Estimate estimate(const Case& study, const Setup<D>& setup, const Calibration& speed) {
  Estimate e;
  e.particles = particle_count(study, setup.lumen);
  const FlowScales scales = flow_scales(study, setup, start_of(study, setup.model, setup.ports));
  count_steps(fluid_options<D>(study, scales), scales.speed, study.time.final(), e);
  e.wall = speed.modelling * setup.lumen.wall_area / std::pow(study.vessel->spacing, D - 1) +
           all_particles(study, setup.lumen) *
               (speed.filling + e.steps * speed.acoustic + e.advection_steps * speed.advection);
  if (setup.wall)
    e.wall += e.steps * wall_work(study, *setup.wall, study.time.final() / e.steps) * speed.acoustic;
  e.memory = bytes_of_program + bytes_per_particle * e.particles;
  return e;
}

template Estimate estimate(const Case&, const Setup<2>&, const Calibration&);
template Estimate estimate(const Case&, const Setup<3>&, const Calibration&);

}  // namespace ostium::app
