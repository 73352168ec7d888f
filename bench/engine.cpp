#include <omp.h>

#include "bench/bench.hpp"
#include "sph3d/step/prepare.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::bench {

using namespace sph3d;

namespace {

constexpr double inflow_speed = 0.3;  // m/s, mean over the largest opening

/// Flow into the largest opening; every other one answers with its own acoustic impedance.
std::vector<Drive> drives_of(const Lumen<3>& lumen, const FluidOptions<3>& fluid) {
  std::vector<Drive> drives(lumen.openings.size());
  drives[0].flow_in = inflow_speed * lumen.openings[0].area;
  for (std::size_t k = 1; k < drives.size(); ++k)
    drives[k].law.resistance = fluid.density * fluid.sound_speed / lumen.openings[k].area;
  return drives;
}

/// What an advection step does before its acoustic steps.
void prepare(const Model<3>& model, FluidState<3>& fluid, Workspace<3>& work) {
  freeze(model, fluid, work);
  find_zones(model, fluid, work);
  look_around(model, fluid, work);
  kernel_sums(model, fluid, work);
  correct(model, fluid, work, 1e-4);
  prepare_forces(model, fluid, work);
}

struct Sample {
  double per_particle_step, preparation;
};

Sample sample(Vessel<3>& vessel, const std::vector<Drive>& drives, int steps) {
  double particle_steps = 0;
  const double total = seconds_of([&] {
    for (int k = 0; k < steps; ++k) {
      const auto report = vessel.advance(1.0, drives, 0.01);
      particle_steps += static_cast<double>(report.particles) * report.acoustic_steps;
    }
  });
  FluidState<3> fluid = vessel.state().fluid;
  static Workspace<3> work;  // its memory is kept, as the vessel's own
  const double once = seconds_of([&] { prepare(vessel.model(), fluid, work); });
  return {total / particle_steps, once * steps / total};
}

}  // namespace

EngineResult measure_engine(const Options& options) {
  constexpr int start_steps = 16, steps = 8;
  const FluidOptions<3> fluid{.dp = options.spacing,
                              .density = 1060,
                              .viscosity = 3.8e-6,
                              .sound_speed = 10,
                              .reference_speed = 0.5,
                              .density_relaxation = 0.2};
  EngineResult result;
  const Lumen<3> lumen = engine_vessel(options, result.vessel);
  std::vector<OpeningRole> roles(lumen.openings.size());
  roles[0].flow_driven = true;
  Vessel<3> vessel(lumen, fluid, roles);
  const auto drives = drives_of(lumen, fluid);
  for (int k = 0; k < start_steps; ++k) vessel.advance(1.0, drives, 0.01);

  const int available = omp_get_max_threads();
  std::vector<int> threads{1};
  if (available > 1) threads.push_back(2);
  std::vector<std::vector<double>> times(threads.size()), shares(threads.size());
  for (int round = 0; round <= options.rounds; ++round)
    for (std::size_t k = 0; k < threads.size(); ++k) {
      omp_set_num_threads(threads[k]);
      const Sample s = sample(vessel, drives, steps);
      if (round > 0) times[k].push_back(s.per_particle_step), shares[k].push_back(s.preparation);
    }
  omp_set_num_threads(available);
  for (std::size_t k = 0; k < threads.size(); ++k)
    result.rows.push_back({threads[k], timing_of(times[k]), timing_of(shares[k]).median});
  result.particles = vessel.state().fluid.count();
  result.acoustic_per_advection =
      static_cast<double>(vessel.state().acoustic_steps) / static_cast<double>(vessel.state().steps);
  return result;
}

}  // namespace ostium::bench
