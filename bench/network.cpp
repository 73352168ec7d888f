// ostium-bench-network: what a 0D study costs on one core, as a table and as JSON.
//
//   tree     a binary tree of linear vessels with Windkessels, per cycle of 50 tabulated samples
//   rcr      studies of one Windkessel over one cycle of 100 samples and rows, model building included, per second
//   sweep    the same by `network::Sweep` on all cores, wall time
//
// Else CPU times of this process: other work on the machine costs it its caches, not its turn.
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/measure.hpp"
#include "core/waveform.hpp"
#include "lumped/flow_source.hpp"
#include "lumped/vessel.hpp"
#include "lumped/windkessel.hpp"
#include "network/simulate.hpp"
#include "network/sweep.hpp"

namespace ostium::bench {
namespace {

using network::Model;

template <class B>
void add(Model& m, const std::string& name, B block) {
  m.entries.push_back({name, name, std::make_shared<lumped::BlockOf<B>>(std::move(block))});
}

lumped::FlowSource inflow(int samples) {
  Waveform::Table table{.times = {}, .values = {}, .period = 1};
  for (int i = 0; i < samples; ++i) {
    const double t = static_cast<double>(i) / samples;
    table.times.push_back(t);
    table.values.push_back(1e-4 * std::pow(std::sin(M_PI * t), 4));
  }
  lumped::FlowSource source;
  source.to = "n0", source.flow = Waveform::table(table);
  return source;
}

/// Every vessel ends in two others, the last ones in Windkessels.
Model tree(int generations) {
  Model m;
  add(m, "in", inflow(50));
  const int inner = (1 << generations) - 1;
  for (int i = 0; i < 2 * inner + 1; ++i) {
    const double g = std::floor(std::log2(i + 1));
    lumped::Vessel v;
    v.from = fmt::format("n{}", i == 0 ? 0 : (i - 1) / 2 + 1), v.to = fmt::format("n{}", i + 1);
    v.R = 1e6 * std::pow(1.8, g), v.C = 1e-9 * std::pow(0.5, g), v.L = 1e5 * std::pow(1.3, g);
    add(m, fmt::format("v{}", i), v);
    if (i < inner) continue;
    lumped::Windkessel w;
    w.from = v.to, w.Rp = 2 * v.R, w.Rd = 20 * v.R, w.C = 2e-8 * std::pow(0.5, g);
    add(m, fmt::format("w{}", i), w);
  }
  return m;
}

Model rcr(double R) {
  Model m;
  add(m, "in", inflow(100));
  lumped::Windkessel w;
  w.from = "n0", w.Rp = 0.1 * R, w.Rd = R, w.C = 1e-8;
  add(m, "out", w);
  return m;
}

/// CPU seconds; the rows go to `row`.
double simulated(const Model& m, double end, double every, int& unknowns) {
  const double begin = thread_seconds();
  double sum = 0;
  network::simulate(m, {.end = end, .every = every},
                    {.begin = [&](const auto& names) { unknowns = static_cast<int>(names.size()); },
                     .row =
                         [&](double, std::span<const double> y) {
                           sum += y[0];
                           return std::isfinite(sum);
                         }});
  return thread_seconds() - begin;
}

nlohmann::json measure_tree(int generations, int cycles) {
  const Model m = tree(generations);
  int unknowns = 0;
  const double one = simulated(m, 1, 0.01, unknowns), all = simulated(m, 1 + cycles, 0.01, unknowns);
  const double cycle = (all - one) / cycles;
  fmt::print("tree of {} unknowns: {:.1f} ms per cycle of 50 samples and 100 rows ({:.1f} ms the first)\n",
             unknowns, 1e3 * cycle, 1e3 * one);
  return {{"unknowns", unknowns}, {"ms_per_cycle", 1e3 * cycle}, {"ms_first", 1e3 * one}};
}

nlohmann::json measure_rcr(int studies) {
  int unknowns = 0;
  const double begin = thread_seconds();
  for (int i = 0; i < studies; ++i) simulated(rcr(1e8 * (1 + 1e-4 * i)), 1, 0.01, unknowns);
  const double rate = studies / (thread_seconds() - begin);
  fmt::print("RCR, one cycle of 100 samples and 100 rows: {:.0f} studies per second on one core\n", rate);
  return {{"studies_per_second", rate}};
}

/// As `ostium sweep` runs them, without its table: joined once per thread.
nlohmann::json measure_sweep(int studies, int threads) {
  const Model m = rcr(1e8);
  const std::vector<network::Variation> Rd{
      {.parameter = network::parameter(m, "out.Rd", "bench"), .low = 1e8, .high = 2e8}};
  const auto mean = network::read_index("mean p:n0", network::Network(m).series_names(), "bench");
  network::Sweep sweep(m, network::Design({.count = studies, .parameters = Rd}), {mean},
                       {.end = 1, .every = 0.01}, threads);
  const auto begin = std::chrono::steady_clock::now();
  sweep.run(0, studies, 1, [] { return false; });
  const double rate =
      studies / std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  fmt::print("sweep of the same: {:.0f} studies per second on {} threads (wall time)\n", rate, threads);
  return {{"studies_per_second", rate}, {"threads", threads}};
}

}  // namespace
}  // namespace ostium::bench

int main(int argc, char** argv) {
  CLI::App app{"Cost of 0D studies on one core"};
  std::string json;
  int generations = 9, cycles = 5, studies = 2000, threads = omp_get_max_threads();
  app.add_option("--json", json, "write the numbers to this file");
  app.add_option("--generations", generations, "of the tree (9)")->check(CLI::Range(1, 14));
  app.add_option("--cycles", cycles, "of the tree (5)")->check(CLI::Range(1, 1000));
  app.add_option("--studies", studies, "of the Windkessel (2000)")->check(CLI::PositiveNumber);
  app.add_option("--threads", threads, "of the sweep (all)")->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);
  const nlohmann::json all{{"tree", ostium::bench::measure_tree(generations, cycles)},
                           {"rcr", ostium::bench::measure_rcr(studies)},
                           {"sweep", ostium::bench::measure_sweep(5 * studies, threads)}};
  if (!json.empty()) std::ofstream(json) << all.dump(2) << "\n";
}
