// ostium-bench-svzerod: the heaviest reference cases of svZeroDSolver, from the imported case file to the results folder.
//
//   ms      CPU milliseconds of reading the case, running it and writing every file, median of rounds taken in turn
//   error   against that program's refined results, l2 of the worst series (bench/svzerod_reference)
//   bar     a fifth of the CPU milliseconds svZeroDSolver needs for the same
//
// In one process: starting the program is not in it, the import neither.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "app/case.hpp"
#include "app/import/svzerod_import.hpp"
#include "app/study.hpp"
#include "bench/measure.hpp"
#include "bench/svzerod_reference.hpp"
#include "core/log.hpp"

namespace ostium::bench {
namespace {

namespace fs = std::filesystem;

struct Heavy {
  std::string name;
  double peer;  // CPU ms of svZeroDSolver, whole program
};

const std::vector<Heavy> heaviest{{"coupledBlock_closedLoopHeart_withCoronaries", 3655},
                                  {"closedLoopHeart_singleVessel", 180},
                                  {"0104_0001_optimal_from_0d", 435},
                                  {"tree_127_vessels", 440},
                                  {"piecewise_Chamber_and_Valve", 340},
                                  {"pulsatileFlow_CStenosis_steadyPressure_definedPeriod", 47}};
constexpr double times_faster = 5, allowed_error = 1e-3;

/// Gone with everything in it when the bench is over.
struct TemporaryFolder {
  fs::path path = fs::temp_directory_path() / fmt::format("ostium-bench-svzerod-{}", getpid());
  TemporaryFolder() { fs::create_directories(path); }
  ~TemporaryFolder() {
    log::close_file();
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
};

/// What `ostium run CASE -o RESULTS --force --format svzerod` does.
void run(const fs::path& case_file, const fs::path& results) {
  const app::Case study = app::read_case(case_file);
  app::run_study(study, {.arguments = case_file.string(),
                         .case_name = app::case_name(case_file),
                         .folder = {results, app::Earlier::replace},
                         .quiet = true,
                         .svzerod = true});
}

nlohmann::json measure(const fs::path& data, const std::vector<Heavy>& cases, int rounds) {
  const TemporaryFolder folder;
  std::vector<std::function<void()>> runs;
  for (const auto& c : cases) {
    const fs::path file = folder.path / (c.name + ".yaml"), results = folder.path / c.name;
    app::write_text(file, app::import_svzerod(data / "cases" / (c.name + ".json")).yaml);
    runs.push_back([=] { run(file, results); });
  }
  const auto timings = in_turn(runs, rounds);
  fmt::print("{:<52} {:>8} {:>8} {:>8}  {:>7}  worst series\n", "case", "ms", "best", "bar", "error");
  nlohmann::json all;
  for (std::size_t k = 0; k < cases.size(); ++k) {
    const auto& [name, peer] = cases[k];
    const auto [error, series] = distance_to_reference(folder.path / name, data, name);
    const double ms = 1e3 * timings[k].median, best = 1e3 * timings[k].best, bar = peer / times_faster;
    const bool holds = ms <= bar && error <= allowed_error;
    fmt::print("{:<52} {:>8.1f} {:>8.1f} {:>8.1f}  {:.1e}  {}{}\n", name, ms, best, bar, error, series,
               holds ? "" : "  MISSED");
    all[name] = {{"ms", ms}, {"best_ms", best}, {"bar_ms", bar}, {"error", error}, {"holds", holds}};
  }
  return all;
}

/// Those whose name holds `part`.
std::vector<Heavy> chosen(const std::string& part) {
  std::vector<Heavy> all;
  for (const auto& c : heaviest)
    if (c.name.find(part) != std::string::npos) all.push_back(c);
  return all;
}

}  // namespace
}  // namespace ostium::bench

int main(int argc, char** argv) {
  CLI::App app{"Cost of the heaviest reference cases of svZeroDSolver, output included"};
  std::string json, data = OSTIUM_BENCH_SVZEROD, part;
  int rounds = 9;
  app.add_option("--data", data, "folder of the reference cases")->capture_default_str();
  app.add_option("--case", part, "only those whose name holds this");
  app.add_option("--rounds", rounds, "of which the median is taken")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--json", json, "write the numbers to this file");
  CLI11_PARSE(app, argc, argv);
  if (!std::filesystem::exists(data)) {
    fmt::print("nothing measured: the reference cases are not at {}; name their folder with --data\n", data);
    return 0;
  }
  ostium::log::show_on_terminal(false);
  const auto all = ostium::bench::measure(data, ostium::bench::chosen(part), rounds);
  if (!json.empty()) std::ofstream(json) << all.dump(2) << "\n";
}
