#include "app/command_line.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "app/case_arguments.hpp"
#include "app/check.hpp"
#include "app/commands.hpp"
#include "app/coupled.hpp"
#include "app/interrupt.hpp"
#include "app/schema.hpp"
#include "app/study.hpp"
#include "app/sweep/ranks.hpp"
#include "app/version.hpp"
#include "core/log.hpp"
#include "core/text.hpp"

namespace ostium::app {
namespace {

void add_run(CLI::App& program, int& code) {
  auto* command = program.add_subcommand("run", "run a case and write its results folder");
  struct Arguments : CaseArguments {
    std::string output, format;
    bool force = false, resume = false, quiet = false;
  };
  auto a = std::make_shared<Arguments>();
  a->add_to(*command);
  command->add_option("-o,--output", a->output, "results folder; default: results/CASE");
  auto* force = command->add_flag("--force", a->force, "replace the results of an earlier run");
  command->add_flag("--resume", a->resume, "go on with an interrupted run from its checkpoint")
      ->excludes(force);
  command->add_flag("-q,--quiet", a->quiet, "no progress line");
  command->add_option("--format", a->format, "svzerod: also write svzerod.csv in the layout of svZeroDSolver")
      ->check(CLI::IsMember({"svzerod"}));
  command->callback([a, &code] {
    const Case study = a->read();
    const std::string name = case_name(a->file);
    const Earlier earlier = a->resume ? Earlier::resume : a->force ? Earlier::replace : Earlier::refuse;
    const RunOptions options{.arguments = a->text(),
                             .case_name = name,
                             .folder = {a->output.empty() ? std::filesystem::path("results") / name
                                                          : std::filesystem::path(a->output),
                                        earlier},
                             .quiet = a->quiet,
                             .threads = a->thread_count(),
                             .svzerod = a->format == "svzerod"};
    if (study.vessel && options.svzerod)
      user_error("--format svzerod: that layout is for networks alone, this case has a vessel; leave it out");
    catch_interrupts();
    code = study.vessel ? run_coupled(study, options) : run_study(study, options);
  });
}

void add_check(CLI::App& program) {
  auto* command = program.add_subcommand("check", "read and check a case, list its openings, run nothing");
  auto a = std::make_shared<CaseArguments>();
  a->add_to(*command);
  command->callback([a] { fmt::print("{}", check(a->read(), a->thread_count())); });
}

void add_schema(CLI::App& program) {
  auto* command = program.add_subcommand("schema", "print the JSON schema of the case file");
  command->callback([] { fmt::print("{}", case_schema()); });
}

void add_reference(CLI::App& program) {
  auto* command =
      program.add_subcommand("reference", "write the reference pages of the case file (Markdown)");
  auto folder = std::make_shared<std::string>("docs/reference");
  command->add_option("-o,--output", *folder, "folder of the pages")->capture_default_str();
  command->callback([folder] {
    for (const auto& file : write_reference(*folder)) fmt::print("{}\n", file.string());
  });
}

int report(int code, const char* kind, const std::string& text) {
  std::fflush(stdout);
  if (is_first_process()) fmt::print(stderr, "{}{}\n", kind, printable(text, true));
  return code;
}

}  // namespace

int run_program(int argc, char** argv) {
  CLI::App program("Blood flow in vessels (3D SPH) coupled to the circulation beyond their openings (0D)",
                   "ostium");
  program.require_subcommand(1);
  program.set_version_flag("--version", std::string("ostium ") + version);
  int code = exit_ok;
  add_run(program, code);
  add_check(program);
  add_preview(program);
  add_geometry(program);
  add_import(program);
  add_calibrate(program);
  add_sweep(program, code);
  add_schema(program);
  add_reference(program);
  try {
    program.parse(argc, argv);
    return code;
  } catch (const CLI::ParseError& e) {
    return program.exit(e) == 0 ? exit_ok : exit_user_error;
  } catch (const UserError& e) {
    return report(exit_user_error, "error: ", e.what());
  } catch (const NumericsError& e) {
    return report(exit_numerics_error, "numerics error: ", e.what());
  } catch (const Interrupted&) {
    return report(exit_interrupted, "", "interrupted before the first step: there is nothing to go on from");
  } catch (const std::exception& e) {
    return report(exit_bug, "bug, please report it: ", e.what());
  }
}

}  // namespace ostium::app
