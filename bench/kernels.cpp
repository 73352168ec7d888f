#include <omp.h>

#include <cmath>
#include <cstdlib>
#include <memory>

#include "bench/bench.hpp"
#include "bench/plain_reference.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::bench {

using namespace sph3d;

namespace {

constexpr float dt = 1e-9f;  // s: repeated steps leave the fluid as it is

/// A fluid in motion with its advection step prepared.
struct Prepared {
  const Model<3>& model;
  FluidState<3> fluid;
  Workspace<3> work;

  explicit Prepared(const Vessel<3>& vessel) : model(vessel.model()), fluid(vessel.state().fluid) {
    for (std::size_t i = 0; i < fluid.places(); ++i) {
      if (!fluid.filled[i]) continue;
      const Vec3& x = fluid.position[i];
      fluid.velocity(i, Vec3(std::sin(900 * x[0]), std::sin(700 * x[1]), std::cos(800 * x[2])));
      fluid.psi(i) += static_cast<float>(2e-3 * std::cos(1200 * x.sum()));
    }
    freeze(model, fluid, work);
    find_zones(model, fluid, work);
    look_around(model, fluid, work);
    kernel_sums(model, fluid, work);
    correct(model, fluid, work, 1e-4);
    prepare_forces(model, fluid, work);
  }

  void sums(const FluidKernels<3>& kernels) {
    const auto n = static_cast<std::int64_t>(fluid.clusters.size());
    kernels.sums(0, n, fluid.clusters.data(), work.sums.data(), work.rows.data(), work.place.data(),
                 constants_of(model));
    kernels.corrected_sums(0, n, fluid.clusters.data(), work.sums.data(), work.rows.data(), work.place.data(),
                           work.velocity.data(), work.matrix.data(), constants_of(model));
  }

  void show_pressures() {
    const float c2 = constants_of(model).c2;
    for (std::size_t i = 0; i < fluid.places(); ++i)
      work.place[i].w = work.velocity[i].kV * fluid.psi(i) * c2;
  }

  void acoustic(const FluidKernels<3>& kernels) {
    const auto n = static_cast<std::int64_t>(fluid.clusters.size());
    kernels.kick(0, n, fluid.clusters.data(), work.rows.data(), work.place.data(), work.velocity.data(),
                 constants_of(model), dt);
    kernels.density(0, n, fluid.clusters.data(), work.rows.data(), work.place.data(), work.velocity.data(),
                    constants_of(model), dt, 1.0f);
  }
};

std::vector<const FluidKernels<3>*> all_kernels() {
  std::vector<const FluidKernels<3>*> all{&fluid_kernels<3>()};
  setenv("OSTIUM_ISA", "baseline", 1);
  if (&fluid_kernels<3>() != all[0]) all.push_back(&fluid_kernels<3>());
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

KernelResult measure_kernels(const Options& options) {
  const FluidOptions<3> fluid{
      .dp = 1e-3, .density = 1060, .viscosity = 3.8e-6, .sound_speed = 10, .reference_speed = 1};
  const Lumen<3> tube = tube_of(options.particles, fluid.dp);
  const Vessel<3> vessel(tube, fluid, std::vector<OpeningRole>(tube.openings.size()), 500.0);
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  Prepared acoustic(vessel), sums(vessel);
  plain::Fluid<3> reference(vessel.model(), sums.fluid);
  acoustic.show_pressures();
  const auto kernels = all_kernels();
  std::vector<std::function<void()>> acoustic_rivals, sum_rivals;
  for (const auto* k : kernels) {
    acoustic_rivals.push_back([&acoustic, k] { acoustic.acoustic(*k); });
    sum_rivals.push_back([&sums, k] { sums.sums(*k); });
  }
  acoustic_rivals.push_back([&] { reference.kick(dt), reference.density(dt, 1.0); });
  sum_rivals.push_back([&] { reference.sums(), reference.corrected_sums(); });
  KernelResult result{.particles = vessel.state().fluid.count()};
  add_rows(result, "acoustic step", kernels, in_turn(acoustic_rivals, options.rounds));
  add_rows(result, "advection sums", kernels, in_turn(sum_rivals, options.rounds));
  omp_set_num_threads(threads);
  return result;
}

}  // namespace ostium::bench
