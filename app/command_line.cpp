#include "app/command_line.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <thread>

#include "app/check.hpp"
#include "app/coupled.hpp"
#include "app/interrupt.hpp"
#include "app/schema.hpp"
#include "app/study.hpp"
#include "app/version.hpp"
#include "core/log.hpp"

namespace ostium::app {
namespace {

struct CaseArguments {
  std::string file, surface;
  std::vector<std::string> set;
  int threads = 0;

  Case read() const {
    Overrides overrides;
    if (!surface.empty()) overrides.surface = std::filesystem::absolute(surface);
    for (const auto& text : set) {
      const auto equals = text.find('=');
      if (equals == std::string::npos)
        user_error("--set {}: expected KEY=VALUE, for example --set time.cycles=1", text);
      overrides.values.emplace_back(text.substr(0, equals), text.substr(equals + 1));
    }
    return read_case(file, overrides);
  }
  int thread_count() const {
    return threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  }
};

void add_case_arguments(CLI::App& command, CaseArguments& a) {
  command.add_option("case", a.file, "case file (YAML)")->required();
  command.add_option("--surface", a.surface, "read the vessel's surface from this file instead");
  command.add_option("--set", a.set, "change a value of the case: KEY=VALUE, such as time.cycles=1")
      ->allow_extra_args(false);
  command.add_option("--threads", a.threads, "number of threads; default: all")
      ->check(CLI::NonNegativeNumber);
}

void add_run(CLI::App& program, int& code) {
  auto* command = program.add_subcommand("run", "run a case and write its results folder");
  struct Arguments : CaseArguments {
    std::string output;
    bool force = false, quiet = false;
  };
  auto a = std::make_shared<Arguments>();
  add_case_arguments(*command, *a);
  command->add_option("-o,--output", a->output, "results folder; default: results/CASE");
  command->add_flag("--force", a->force, "replace the results of a finished run");
  command->add_flag("-q,--quiet", a->quiet, "no progress line");
  command->callback([a, &code] {
    const Case study = a->read();
    const std::string name = case_name(a->file);
    const RunOptions options{.case_name = name,
                             .folder = {a->output.empty() ? std::filesystem::path("results") / name
                                                          : std::filesystem::path(a->output),
                                        a->force},
                             .quiet = a->quiet,
                             .threads = a->thread_count()};
    catch_interrupts();
    code = study.vessel ? run_coupled(study, options) : run_study(study, options);
  });
}

void add_check(CLI::App& program) {
  auto* command = program.add_subcommand("check", "read and check a case, list its openings, run nothing");
  auto a = std::make_shared<CaseArguments>();
  add_case_arguments(*command, *a);
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
  fmt::print(stderr, "{}{}\n", kind, text);
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
  } catch (const std::exception& e) {
    return report(exit_bug, "bug, please report it: ", e.what());
  }
}

}  // namespace ostium::app
