#include <omp.h>

#include <cstdlib>

#include "bench/plain_reference.hpp"
#include "bench/workload.hpp"

namespace ostium::bench {

using namespace sph3d;

namespace {

std::vector<const FluidKernels<3>*> all_kernels() {
  std::vector<const FluidKernels<3>*> all{&fluid_kernels<3>()};
  for (const char* isa : {"avx2", "baseline"}) {
    setenv("OSTIUM_ISA", isa, 1);
    if (&fluid_kernels<3>() != all.back()) all.push_back(&fluid_kernels<3>());
  }
  unsetenv("OSTIUM_ISA");
  return all;
}

void add_rows(KernelResult& result, const std::string& what,
              const std::vector<const FluidKernels<3>*>& kernels, const std::vector<Timing>& timings) {
  const double n = static_cast<double>(result.particles), plain = timings.back().median;
  for (std::size_t k = 0; k < timings.size(); ++k)
    result.rows.push_back({.what = what,
                           .who = k < kernels.size() ? kernels[k]->name : "plain",
                           .per_particle = {timings[k].median / n, timings[k].best / n},
                           .times_faster = plain / timings[k].median});
}

}  // namespace

KernelResult measure_kernels(const Vessel<3>& tube, const Options& options) {
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  Prepared acoustic(tube), sums(tube);
  plain::Fluid<3> reference(tube.model(), sums.fluid);
  acoustic.show_pressures();
  const auto kernels = all_kernels();
  std::vector<std::function<void()>> acoustic_rivals, sum_rivals;
  for (const auto* k : kernels) {
    acoustic_rivals.push_back([&acoustic, k] {
      acoustic.kick(*k, 0, acoustic.clusters());
      acoustic.density(*k, 0, acoustic.clusters());
    });
    sum_rivals.push_back([&sums, k] {
      sums.sums(*k, 0, sums.clusters());
      sums.corrected_sums(*k, 0, sums.clusters());
    });
  }
  acoustic_rivals.push_back([&] { reference.kick(still), reference.density(still, 1.0); });
  sum_rivals.push_back([&] { reference.sums(), reference.corrected_sums(); });
  KernelResult result{.particles = tube.state().fluid.count()};
  add_rows(result, "acoustic step", kernels, in_turn(acoustic_rivals, options.rounds));
  add_rows(result, "advection sums", kernels, in_turn(sum_rivals, options.rounds));
  omp_set_num_threads(threads);
  return result;
}

}  // namespace ostium::bench
