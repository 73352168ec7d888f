// `ostium import svzerod MODEL`, `ostium import openbf MODEL`: other programs' models as cases.
#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/import/openbf_import.hpp"
#include "app/import/svzerod_import.hpp"
#include "app/results/folder.hpp"
#include "core/error.hpp"
#include "core/progress.hpp"

namespace ostium::app {
namespace {

struct Arguments {
  std::string model, output, units;
  int segments = 1;
  bool check = false, force = false;
};

void report(const Imported& made, bool check) {
  fmt::print("{} blocks, {} unknowns of the model; units {} ({})\n", made.blocks, made.variables, made.units,
             made.why_units);
  for (const auto& note : made.notes) fmt::print("  not carried over: {}\n", note);
  if (check)
    fmt::print("{}\n",
               made.notes.empty() ? "everything can be carried over" : "the rest can be carried over");
}

void refuse_existing(const std::filesystem::path& file, bool force) {
  if (!force && std::filesystem::exists(file))
    user_error("{}: this file exists; choose another one with -o, or replace it with --force", file.string());
}

std::filesystem::path case_file(const Arguments& a) {
  return a.output.empty() ? std::filesystem::path(a.model).stem().string() + ".yaml" : a.output;
}

/// One line per stage that lasts.
class Stages {
 public:
  void tell(const std::string& stage, double share) {
    if (stage != name_) line_.emplace(Progress::Options{.end = 1, .task = stage});
    name_ = stage;
    line_->update(share, 0);
  }

 private:
  std::string name_;
  std::optional<Progress> line_;
};

void run(const Arguments& a) {
  const std::filesystem::path file = case_file(a);
  if (!a.check) refuse_existing(file, a.force);
  Stages stages;
  const Imported made =
      import_svzerod(a.model, a.units.empty() ? std::nullopt : std::optional(a.units),
                     [&](const std::string& stage, double share) { stages.tell(stage, share); });
  if (!a.check) write_text(file, made.yaml);
  report(made, a.check);
  if (!a.check)
    fmt::print("written: {}; run it with: ostium run {} --format svzerod\n", file.string(), file.string());
}

void run_openbf(const Arguments& a) {
  const std::filesystem::path file = case_file(a);
  refuse_existing(file, a.force);
  if (std::filesystem::exists(file) && std::filesystem::equivalent(file, a.model))
    user_error("{}: this is the model itself; name another file with -o", file.string());
  const ImportedOpenbf made = import_openbf(a.model, a.segments);
  write_text(file, made.yaml);
  fmt::print("{} vessels as {} blocks, linear about mean pressures of {:.4g} to {:.4g} kPa\n", made.vessels,
             made.blocks, 1e-3 * made.lowest, 1e-3 * made.highest);
  for (const auto& note : made.notes) fmt::print("  not carried over: {}\n", note);
  fmt::print("written: {}; run it with: ostium run {}\n", file.string(), file.string());
}

void add_openbf(CLI::App& import) {
  auto* command =
      import.add_subcommand("openbf", "a network of 1D vessels of openBF (YAML) as lumped chains");
  auto a = std::make_shared<Arguments>();
  command->add_option("model", a->model, "file of the network (YAML)")->required();
  command->add_option("-o,--output", a->output, "case file to write; default: MODEL.yaml here");
  command->add_option("--segments", a->segments, "pieces of each vessel")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command->add_flag("--force", a->force, "replace an existing case file");
  command->callback([a] { run_openbf(*a); });
}

}  // namespace

void add_import(CLI::App& program) {
  auto* import = program.add_subcommand("import", "make a case of another program's model");
  import->require_subcommand(1);
  auto* command = import->add_subcommand("svzerod", "a 0D model of svZeroDSolver (JSON)");
  auto a = std::make_shared<Arguments>();
  command->add_option("model", a->model, "file of the model (JSON)")->required();
  command->add_option("-o,--output", a->output, "case file to write; default: MODEL.yaml here");
  command->add_option("--units", a->units, "units of the model, which carries none: cgs, mmHg or SI");
  command->add_flag("--check", a->check, "say what can and cannot be carried over, write nothing");
  command->add_flag("--force", a->force, "replace an existing case file");
  command->callback([a] { run(*a); });
  add_openbf(*import);
}

}  // namespace ostium::app
