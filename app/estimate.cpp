#include "app/estimate.hpp"

#include <cmath>

#include "app/flow_scales.hpp"
#include "core/error.hpp"

namespace ostium::app {
namespace {

constexpr double steps_per_core_second = 2e6, smoothing_ratio = 1.3;
constexpr double bytes_per_particle = 760, bytes_of_program = 5e7;  // with the copy kept for failures

}  // namespace

std::string count_text(double count) {
  if (count < 1e4) return fmt::format("{:.0f}", count);
  return count < 999.5e3 ? fmt::format("{:.3g} thousand", count / 1e3)
                         : fmt::format("{:.3g} million", count / 1e6);
}

std::string duration_text(double seconds) {
  if (seconds < 90) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400) return fmt::format("{:.0f} min", seconds / 60);
  return fmt::format("{:.1f} h", seconds / 3600);
}

template <int D>
Estimate estimate(const Case& study, const Setup<D>& setup, int threads) {
  Estimate e;
  e.particles = particle_count(study, setup.lumen);
  const FlowScales scales = flow_scales(study, setup, start_of(study, setup.model, setup.ports));
  const double step = study.numerics.acoustic_cfl * smoothing_ratio * study.vessel->spacing /
                      (scales.sound_speed + scales.speed);
  e.steps = std::ceil(study.time.final() / step);
  e.wall = e.particles * e.steps / (steps_per_core_second * threads);
  e.memory = bytes_of_program + bytes_per_particle * e.particles;
  return e;
}

template Estimate estimate(const Case&, const Setup<2>&, int);
template Estimate estimate(const Case&, const Setup<3>&, int);

}  // namespace ostium::app
