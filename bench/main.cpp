// ostium-bench: how fast the fluid is, as a table and as JSON.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "bench/baseline.hpp"
#include "bench/workload.hpp"

namespace ostium::bench {
namespace {

/// The engine runs on the patient's aorta where that is at hand.
Options defaults() {
  const std::filesystem::path aorta = OSTIUM_BENCH_SURFACE;
  return {.surface = std::filesystem::exists(aorta) ? aorta : std::filesystem::path{},
          .baseline = OSTIUM_BENCH_BASELINE};
}

/// Memory first: the largest resident size never shrinks again, and the plain reference is large.
Results measure(const Options& o) {
  Results r;
  const double before = peak_resident();
  auto tube = flowing(tube_of(o.particles, 1e-3), 1e-3);
  r.step = measure_step(tube, o, before);
  print(r.machine = measure_machine());
  print(r.step, r.machine);
  print(r.engine = measure_engine(o));
  print(r.kernels = measure_kernels(tube, o));
  print(measure_shell(o));
  return r;
}

void add_options(CLI::App& app, Options& o) {
  app.add_option("--particles", o.particles, "of the tube (60000)")->check(CLI::PositiveNumber);
  app.add_option("--surface", o.surface, "vessel for the engine, an STL or VTP file")
      ->check(CLI::ExistingFile);
  app.add_option("--length-unit", o.length_unit, "m per unit of that file (0.01)")
      ->check(CLI::PositiveNumber);
  app.add_option("--spacing", o.spacing, "particle spacing for the engine, m (0.001)")
      ->check(CLI::PositiveNumber);
  app.add_option("--rounds", o.rounds, "how often each rival is timed (7)")->check(CLI::Range(1, 1000));
  app.add_flag("--shell", o.shell_only, "the shell only");
  app.add_option("--json", o.json, "write the numbers to this file");
  app.add_option("--baseline", o.baseline, "ratios to compare with (bench/baseline.json)")
      ->check(CLI::ExistingFile);
  app.add_option("--write-baseline", o.write_baseline, "write this run's ratios to this file");
}

int run(int argc, char** argv) {
  CLI::App app{
      "Speed of the fluid: the parts of a step, kernels against a plain reference, the whole engine"};
  Options o = defaults();
  add_options(app, o);
  CLI11_PARSE(app, argc, argv);
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // each table as soon as it is known
  if (o.shell_only) {
    print(measure_shell(o));
    return 0;
  }
  const Results results = measure(o);
  if (!o.json.empty()) write_json(results, o.json);
  if (!o.write_baseline.empty()) write_baseline(ratios_of(results), o.write_baseline);
  for (const auto& sentence : worse_than(o.baseline, ratios_of(results))) fmt::print("{}\n", sentence);
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
