#include <omp.h>

#include "bench/workload.hpp"
#include "sph3d/fields/wall_cycle.hpp"
#include "sph3d/fields/wall_loads.hpp"
#include "sph3d/step/prepare.hpp"

namespace ostium::bench {

using namespace sph3d;

namespace {

Timing per(const Timing& t, double n) { return {t.median / n, t.best / n}; }

/// Whole steps of the vessel, one order of memory long; of each round, the wall time of the phases per step.
struct WholeSteps {
  Vessel<3>& vessel;
  std::vector<Drive> drives = drives_of(vessel);
  double advection_steps = 0, acoustic_steps = 0;
  std::vector<double> acoustic = {}, driving = {}, advection = {}, renewal = {}, ratio = {};

  void operator()() {
    PhaseSeconds phases;
    double acoustic_now = 0;
    const int steps = vessel.model().options.reorder_every;
    for (int k = 0; k < steps; ++k) {
      const StepReport report = vessel.advance(1.0, drives, 0.01);
      acoustic_now += report.acoustic_steps;
      phases += report.seconds;
    }
    advection_steps += steps, acoustic_steps += acoustic_now;
    driving.push_back(phases.driving / acoustic_now);
    acoustic.push_back((phases.acoustic + phases.driving) / acoustic_now);
    renewal.push_back(phases.renewal / steps);
    advection.push_back((phases.advection + phases.walls + phases.renewal) / steps);
    ratio.push_back(advection.back() / acoustic.back());
  }
  /// Median per particle of the rounds after the first.
  static Timing of(const std::vector<double>& rounds, double particles) {
    return per(timing_of({rounds.begin() + 1, rounds.end()}), particles);
  }
};

/// What the fields of cycles cost a run in every advection step.
struct WallFields {
  const Vessel<3>& vessel;
  WallSampler<3> sampler{vessel};
  WallCycle<3> cycle = {};

  void operator()() {
    sampler.sample(vessel);
    take(cycle, cycle.time + 1e-4, sampler.loads().shear_stress, sampler.loads().pressure, 0.0, 1e-3);
  }
};

struct Rival {
  std::string name;
  std::function<void()> work;
  double share = 1;
};

std::vector<Rival> parts_of(Prepared& p) {
  const double seldom = 1.0 / p.model.options.reorder_every;
  return {{"reorder", [&] { p.fluid.reorder(p.work.spare); }, seldom},
          {"freeze, rows", [&] { freeze(p.model, p.fluid, p.work); }},
          {"zones", [&] { find_zones(p.model, p.fluid, p.work); }},
          {"look around", [&] { look_around(p.model, p.fluid, p.work); }},
          {"kernel sums", [&] { kernel_sums(p.model, p.fluid, p.work); }},
          {"corrections", [&] { correct(p.model, p.fluid, p.work, 1e-4, still); }},
          {"corrected sums", [&] { prepare_forces(p.model, p.fluid, p.work); }}};
}

}  // namespace

StepResult measure_step(Vessel<3>& tube, const Options& options, double resident_before) {
  StepResult result{.particles = tube.state().fluid.count(),
                    .resident = peak_resident(),
                    .resident_before = resident_before};
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  Prepared p(tube);
  const auto& kernels = fluid_kernels<3>();
  const std::int64_t all = p.clusters();
  WholeSteps whole{tube};
  WallFields fields{tube};
  const auto parts = parts_of(p);
  std::vector<std::function<void()>> rivals;
  for (const auto& part : parts) rivals.push_back(part.work);
  rivals.push_back([&] { p.kick(kernels, 0, all); });
  rivals.push_back([&] { p.density(kernels, 0, all); });
  rivals.push_back([&] { whole(); });
  rivals.push_back([&] { fields(); });
  const auto times = in_turn(rivals, options.rounds);
  const double n = static_cast<double>(result.particles);
  for (std::size_t k = 0; k < parts.size(); ++k)
    result.parts.push_back({parts[k].name, per(times[k], n), parts[k].share});
  result.kick = per(times[parts.size()], n);
  result.density = per(times[parts.size() + 1], n);
  result.wall_fields = per(times[parts.size() + 3], n);
  result.acoustic_per_advection = whole.acoustic_steps / whole.advection_steps;
  result.driving = WholeSteps::of(whole.driving, n);
  result.parts.push_back({"renew ports", WholeSteps::of(whole.renewal, n)});
  result.acoustic_in_run = WholeSteps::of(whole.acoustic, n);
  result.advection_in_run = WholeSteps::of(whole.advection, n);
  result.advection_over_acoustic = WholeSteps::of(whole.ratio, 1).median;
  result.row_length = p.work.rows.mean_length();
  result.walls = measure_walls(tube, result.acoustic_per_advection, options.rounds);
  omp_set_num_threads(threads);
  return result;
}

}  // namespace ostium::bench
