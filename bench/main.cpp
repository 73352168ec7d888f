// ostium-bench: how fast the fluid engine is, as ratios to a plain reference in the same process.

#include <omp.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/measure.hpp"
#include "bench/plain_reference.hpp"
#include "bench/workload.hpp"

namespace ostium::bench {
namespace {

using sph3d::FluidState;
using sph3d::Vessel;
using sph3d::Workspace;
namespace plain = sph3d::plain;

constexpr float dt = 1e-9f;  // s: all the arithmetic, no motion

/// A prepared advection step, to time acoustic steps on.
struct Prepared {
  const sph3d::Model<3>& model;
  FluidState<3> fluid;
  Workspace<3> work;
  sph3d::FluidConstants constants;

  explicit Prepared(const Vessel<3>& vessel)
      : model(vessel.model()), fluid(vessel.state().fluid), constants(constants_of(model)) {
    fluid.reorder();
    freeze(model, fluid, work);
    find_zones(model, fluid, work);
    look_around(model, fluid, work);
    kernel_sums(model, fluid, work);
    correct_gradients(model, fluid, work);
    prepare_forces(model, fluid, work);
  }

  void acoustic_step(const sph3d::FluidKernels<3>& kernels) {
    auto& clusters = fluid.clusters;
    sph3d::for_batches(clusters.size(), [&](std::size_t begin, std::size_t end) {
      kernels.kick(begin, end, clusters.data(), work.rows.data(), work.place.data(), work.velocity.data(),
                   constants, dt);
    });
    sph3d::for_batches(clusters.size(), [&](std::size_t begin, std::size_t end) {
      kernels.density(begin, end, clusters.data(), work.rows.data(), work.place.data(), work.velocity.data(),
                      constants, dt, 1.0f);
    });
  }
};

const sph3d::FluidKernels<3>& kernels_named(const char* isa) {
  setenv("OSTIUM_ISA", isa, 1);
  const auto& kernels = sph3d::fluid_kernels<3>();
  unsetenv("OSTIUM_ISA");
  return kernels;
}

nlohmann::json kernel_table(int particles, int rounds) {
  omp_set_num_threads(1);
  const auto vessel = flowing_tube(particles);
  Prepared engine(vessel);
  plain::Fluid<3> reference(engine.model, engine.fluid);
  const auto& best = kernels_named("");
  const auto& baseline = kernels_named("baseline");
  std::vector<Contender> contenders{
      {"plain reference, double, a list per particle",
       [&] { reference.kick(dt), reference.density(dt, 1.0); }},
      {std::string("engine, ") + best.name, [&] { engine.acoustic_step(best); }},
      {std::string("engine, ") + baseline.name, [&] { engine.acoustic_step(baseline); }},
  };
  interleave(contenders, rounds);
  const double n = static_cast<double>(engine.fluid.count());
  std::printf("Acoustic step, %.0f particles, %.1f rows per cluster, 1 thread\n", n,
              engine.work.rows.mean_length());
  std::printf("  %-46s %10s %10s %10s %8s\n", "", "best ns", "median ns", "Mps/s", "ratio");
  nlohmann::json json = nlohmann::json::array();
  for (const auto& c : contenders) {
    const double ratio = c.ratio(contenders.front());
    std::printf("  %-46s %10.1f %10.1f %10.2f %8.2f\n", c.name.c_str(), 1e9 * c.best() / n,
                1e9 * c.median() / n, 1e-6 * n / c.best(), ratio);
    json.push_back({{"name", c.name},
                    {"particles", n},
                    {"best_ns_per_particle", 1e9 * c.best() / n},
                    {"median_ns_per_particle", 1e9 * c.median() / n},
                    {"ratio_to_plain", ratio}});
  }
  return json;
}

/// Everything a step does: lists, sums, openings, particles made and deleted.
nlohmann::json whole_engine(Vessel<3>& vessel, const std::string& name, int rounds) {
  const auto drives = drives_of(vessel);
  nlohmann::json json = nlohmann::json::array();
  std::printf("\nWhole engine, %s, %zu particles, everything included\n", name.c_str(),
              vessel.state().fluid.count());
  std::printf("  %-10s %14s %14s %24s\n", "threads", "best Mps/s", "median Mps/s", "per core, best / median");
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    std::vector<double> rates;
    double acoustic = 0, steps = 0;
    for (int round = 0; round < rounds; ++round) {
      const double begin = seconds();
      double work = 0;
      for (int k = 0; k < 16; ++k) {  // a whole cycle of re-ordering
        const auto report = vessel.advance(1, drives, 0.01);
        work += static_cast<double>(report.particles) * report.acoustic_steps;
        acoustic += report.acoustic_steps, ++steps;
      }
      rates.push_back(1e-6 * work / (seconds() - begin));
    }
    std::sort(rates.begin(), rates.end());
    const double best = rates.back(), median = rates[rates.size() / 2];
    std::printf("  %-10d %14.2f %14.2f %15.2f / %.2f     (%.1f acoustic steps per advection step)\n", threads,
                best, median, best / threads, median / threads, acoustic / steps);
    json.push_back({{"vessel", name},
                    {"threads", threads},
                    {"best_Mps", best},
                    {"median_Mps", median},
                    {"per_core_best", best / threads},
                    {"per_core_median", median / threads},
                    {"acoustic_per_advection", acoustic / steps}});
  }
  return json;
}

int run(int argc, char** argv) {
  CLI::App program("Particle-steps per second (one particle, one acoustic step) of the fluid engine",
                   "ostium-bench");
  int particles = 60000, rounds = 7;
  std::string surface, json_file;
  program.add_option("--particles", particles, "particles of the tube the kernels are timed on")
      ->capture_default_str();
  program.add_option("--rounds", rounds, "rounds of each measurement")->capture_default_str();
  program.add_option("--surface", surface,
                     "aorta to run the whole engine on (STL, in cm); without it a generated arch");
  program.add_option("--json", json_file, "write the numbers to this file too");
  CLI11_PARSE(program, argc, argv);
  nlohmann::json json;
  json["acoustic_step"] = kernel_table(particles, rounds);
  auto vessel = surface.empty() ? flowing_arch() : flowing_aorta(surface);
  json["whole_engine"] = whole_engine(vessel, surface.empty() ? "generated arch" : surface, rounds);
  if (!json_file.empty()) std::ofstream(json_file) << json.dump(2) << '\n';
  return 0;
}

}  // namespace
}  // namespace ostium::bench

int main(int argc, char** argv) {
  try {
    return ostium::bench::run(argc, argv);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "error: %s\n", e.what());
    return 2;
  }
}
