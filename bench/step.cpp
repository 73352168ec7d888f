#include <omp.h>

#include "bench/workload.hpp"
#include "sph3d/step/prepare.hpp"

namespace ostium::bench {

using namespace sph3d;

namespace {

/// Whole steps of the vessel, one order of memory long, and which share of their wall time each phase had.
struct WholeSteps {
  Vessel<3>& vessel;
  std::vector<Drive> drives = drives_of(vessel);
  double advection_steps = 0, acoustic_steps = 0, total = 0;
  PhaseSeconds phases = {};

  void operator()() {
    total += seconds_of([&] {
      for (int k = 0; k < vessel.model().options.reorder_every; ++k, ++advection_steps) {
        const StepReport report = vessel.advance(1.0, drives, 0.01);
        acoustic_steps += report.acoustic_steps;
        phases += report.seconds;
      }
    });
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
          {"corrections", [&] { correct(p.model, p.fluid, p.work, 1e-4); }},
          {"corrected sums", [&] { prepare_forces(p.model, p.fluid, p.work); }}};
}

Timing per(const Timing& t, double n) { return {t.median / n, t.best / n}; }

/// What a whole step (s per particle) takes beyond the parts measured on their own, by the phases' shares of it.
void add_others(const WholeSteps& whole, double step, StepResult& result) {
  const auto share = [&](double phase) { return step * phase / whole.total; };
  const auto add = [&](const char* name, double s) { result.parts.push_back({name, {s, s}}); };
  const double advection = share(whole.phases.advection) - result.advection();
  const auto& p = whole.phases;
  add("move, first pressures", advection);
  add("ports", share(p.openings));
  add("report", share(whole.total - p.advection - p.acoustic - p.openings));
}

}  // namespace

double StepResult::advection() const {
  double sum = 0;
  for (const auto& part : parts) sum += part.mean();
  return sum;
}

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
  const auto parts = parts_of(p);
  std::vector<std::function<void()>> rivals;
  for (const auto& part : parts) rivals.push_back(part.work);
  rivals.push_back([&] { p.kick(kernels, 0, all); });
  rivals.push_back([&] { p.density(kernels, 0, all); });
  rivals.push_back([&] { whole(); });
  const auto times = in_turn(rivals, options.rounds);
  const double n = static_cast<double>(result.particles);
  for (std::size_t k = 0; k < parts.size(); ++k)
    result.parts.push_back({parts[k].name, per(times[k], n), parts[k].share});
  result.kick = per(times[parts.size()], n);
  result.density = per(times[parts.size() + 1], n);
  result.acoustic_per_advection = whole.acoustic_steps / whole.advection_steps;
  add_others(whole, times.back().median / n / tube.model().options.reorder_every, result);
  result.row_length = p.work.rows.mean_length();
  result.walls = measure_walls(tube, result.acoustic_per_advection, options.rounds);
  omp_set_num_threads(threads);
  return result;
}

}  // namespace ostium::bench
