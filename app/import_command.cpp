// `ostium import svzerod MODEL`: other programs' models as cases.
#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "app/commands.hpp"
#include "app/import/svzerod_import.hpp"
#include "app/results/folder.hpp"
#include "core/error.hpp"

namespace ostium::app {
namespace {

struct Arguments {
  std::string model, output, units;
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

void run(const Arguments& a) {
  const std::filesystem::path file =
      a.output.empty() ? std::filesystem::path(a.model).stem().string() + ".yaml" : a.output;
  if (!a.check) refuse_existing(file, a.force);
  const Imported made = import_svzerod(a.model, a.units.empty() ? std::nullopt : std::optional(a.units));
  if (!a.check) write_text(file, made.yaml);
  report(made, a.check);
  if (!a.check)
    fmt::print("written: {}; run it with: ostium run {} --format svzerod\n", file.string(), file.string());
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
}

}  // namespace ostium::app
