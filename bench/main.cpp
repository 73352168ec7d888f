// ostium-bench: how fast the fluid is, as a table and as JSON.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/bench.hpp"

namespace ostium::bench {
namespace {

void print(const KernelResult& r) {
  fmt::print("Kernels, {} particles, one thread\n", r.particles);
  fmt::print("{:<15} {:<14} {:>11} {:>11} {:>10} {:>8}\n", "", "", "median ns", "best ns", "Mps/s",
             "x plain");
  for (const auto& row : r.rows)
    fmt::print("{:<15} {:<14} {:11.1f} {:11.1f} {:10.2f} {:8.2f}\n", row.what, row.who,
               1e9 * row.per_particle.median, 1e9 * row.per_particle.best, 1e-6 / row.per_particle.median,
               row.times_faster);
}

void print(const EngineResult& r) {
  fmt::print("\nEngine, {}, {} particles, {:.1f} acoustic steps per advection step, everything included\n",
             r.vessel, r.particles, r.acoustic_per_advection);
  fmt::print("{:<8} {:>16} {:>14} {:>12}\n", "threads", "Mps/s per core", "best", "preparation");
  for (const auto& row : r.rows)
    fmt::print("{:<8} {:16.2f} {:14.2f} {:10.0f} %\n", row.threads,
               1e-6 / row.per_particle_step.median / row.threads,
               1e-6 / row.per_particle_step.best / row.threads, 100 * row.preparation);
}

nlohmann::json json_of(const KernelResult& r) {
  nlohmann::json rows;
  for (const auto& row : r.rows)
    rows.push_back({{"what", row.what},
                    {"kernels", row.who},
                    {"median_ns_per_particle", 1e9 * row.per_particle.median},
                    {"best_ns_per_particle", 1e9 * row.per_particle.best},
                    {"times_faster_than_plain", row.times_faster}});
  return {{"particles", r.particles}, {"rows", rows}};
}

nlohmann::json json_of(const EngineResult& r) {
  nlohmann::json rows;
  for (const auto& row : r.rows)
    rows.push_back(
        {{"threads", row.threads},
         {"median_particle_steps_per_second_per_core", 1 / row.per_particle_step.median / row.threads},
         {"best_particle_steps_per_second_per_core", 1 / row.per_particle_step.best / row.threads},
         {"preparation_share", row.preparation}});
  return {{"vessel", r.vessel},
          {"particles", r.particles},
          {"acoustic_steps_per_advection_step", r.acoustic_per_advection},
          {"rows", rows}};
}

/// The engine runs on the patient's aorta where that is at hand.
Options defaults() {
  const std::filesystem::path aorta = OSTIUM_BENCH_SURFACE;
  return {.surface = std::filesystem::exists(aorta) ? aorta : std::filesystem::path{}};
}

int run(int argc, char** argv) {
  CLI::App app{"Speed of the fluid: kernels against a plain reference, and the whole engine"};
  Options o = defaults();
  app.add_option("--particles", o.particles, "of the tube for the kernels (60000)")
      ->check(CLI::PositiveNumber);
  app.add_option("--surface", o.surface, "vessel for the engine, an STL or VTP file")
      ->check(CLI::ExistingFile);
  app.add_option("--length-unit", o.length_unit, "m per unit of that file (0.01)")
      ->check(CLI::PositiveNumber);
  app.add_option("--spacing", o.spacing, "particle spacing for the engine, m (0.001)")
      ->check(CLI::PositiveNumber);
  app.add_option("--rounds", o.rounds, "how often each rival is timed (7)")->check(CLI::Range(1, 1000));
  app.add_option("--json", o.json, "write the numbers to this file");
  CLI11_PARSE(app, argc, argv);
  const KernelResult kernels = measure_kernels(o);
  print(kernels);
  const EngineResult engine = measure_engine(o);
  print(engine);
  if (!o.json.empty())
    std::ofstream(o.json) << nlohmann::json{{"kernels", json_of(kernels)}, {"engine", json_of(engine)}}.dump(
                                 2)
                          << "\n";
  return 0;
}

}  // namespace
}  // namespace ostium::bench

int main(int argc, char** argv) {
  try {
    return ostium::bench::run(argc, argv);
  } catch (const std::exception& e) {
    fmt::print(stderr, "{}\n", e.what());
    return 1;
  }
}
