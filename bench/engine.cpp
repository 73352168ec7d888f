#include <omp.h>

#include "bench/workload.hpp"
#include "sph3d/step/prepare.hpp"

namespace ostium::bench {

using namespace sph3d;

namespace {

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
  PhaseSeconds seconds;
  const double once = seconds_of([&] { prepare_step(vessel.model(), fluid, work, 1e-4, still, seconds); });
  return {total / particle_steps, once * steps / total};
}

}  // namespace

EngineResult measure_engine(const Options& options) {
  constexpr int steps = 16;  // from one ordering of memory to the next
  EngineResult result;
  const Lumen<3> lumen = engine_vessel(options, result.vessel);
  Vessel<3> vessel = flowing(lumen, options.spacing);
  const auto drives = drives_of(vessel);

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
