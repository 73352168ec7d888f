// `ostium calibrate`: a case with targets, or svZeroDSolver's own task, a model with observations (JSON).
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/calibrate_case.hpp"
#include "app/case_arguments.hpp"
#include "app/commands.hpp"
#include "app/import/svzerod_calibration.hpp"
#include "core/error.hpp"

namespace ostium::app {
namespace {

struct Arguments : CaseArguments {
  std::string output;
  bool force = false;
};

bool is_model(const std::string& file) { return std::filesystem::path(file).extension() == ".json"; }

void fit_model(const Arguments& a) {
  const std::filesystem::path file =
      a.output.empty() ? std::filesystem::path(a.file).stem().string() + "_calibrated.json" : a.output;
  if (std::filesystem::exists(file) && (!a.force || std::filesystem::equivalent(file, a.file)))
    user_error("{}: this file exists; choose another one with -o{}", file.string(),
               a.force ? "" : ", or replace it with --force");
  const JsonNode root = JsonNode::load(a.file);
  if (!has_observations(root))
    root.error(
        "holds no observations to fit; add \"y\" and \"dy\" with flow:UP:DOWN and pressure:UP:DOWN of every "
        "connection");
  const SvzerodCalibration found = calibrate_svzerod(root);
  write_text(file, found.model.dump(4) + "\n");
  fmt::print("{:<24} {:>12} {:>12} {:>12} {:>12} {:>10}\n", "fitted", "R", "C", "L", "stenosis", "residual");
  for (const auto& [name, fit] : found.fitted) {
    const auto& p = fit.parameters;
    fmt::print("{:<24} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g} {:>10.2g}{}\n", name, p.R, p.C, p.L, p.S,
               fit.residual, fit.undetermined > 0 ? "  not all told by the data" : "");
  }
  for (const auto& note : found.notes) fmt::print("  {}\n", note);
  fmt::print("{} observations; written: {}; go on with: ostium import svzerod {}\n", found.observations,
             file.string(), file.string());
}

void run(const Arguments& a) {
  if (is_model(a.file)) return fit_model(a);
  const ResultsFolder folder(a.output.empty() ? std::filesystem::path("calibration") / case_name(a.file)
                                              : std::filesystem::path(a.output),
                             a.force ? Earlier::replace : Earlier::refuse);
  calibrate_case(a.read(), folder);
}

}  // namespace

void add_calibrate(CLI::App& program) {
  auto* command = program.add_subcommand(
      "calibrate", "change parameters of a network until its results meet the targets of the case");
  auto a = std::make_shared<Arguments>();
  a->add_to(*command);
  command->add_option(
      "-o,--output", a->output,
      "folder of the results; default: calibration/CASE. Of a model (JSON): the file with fitted values");
  command->add_flag("--force", a->force, "replace what an earlier calibration left");
  command->callback([a] { run(*a); });
}

}  // namespace ostium::app
