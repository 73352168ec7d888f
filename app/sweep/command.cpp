// `ostium sweep`: the arguments, and who of the processes talks.
#include <CLI/CLI.hpp>

#include "app/case_arguments.hpp"
#include "app/commands.hpp"
#include "app/interrupt.hpp"
#include "app/sweep/session.hpp"
#include "core/log.hpp"

namespace ostium::app {
namespace {

struct Arguments : CaseArguments {
  std::string output;
  bool force = false, resume = false, quiet = false;
};

int run(const Arguments& a) {
  const Ranks ranks;
  log::show_on_terminal(ranks.first());
  Case study;
  ranks.each([&] { study = a.read(); });
  const std::string name = case_name(a.file);
  const SweepOptions options{
      .arguments = a.text(),
      .case_name = name,
      .folder = a.output.empty() ? std::filesystem::path("sweep") / name : std::filesystem::path(a.output),
      .earlier = a.resume  ? Earlier::resume
                 : a.force ? Earlier::replace
                           : Earlier::refuse,
      .quiet = a.quiet,
      .threads = a.threads > 0 ? a.threads : share_of_cores()};
  catch_interrupts();
  return run_sweep(study, options, ranks);
}

}  // namespace

void add_sweep(CLI::App& program, int& code) {
  auto* command = program.add_subcommand(
      "sweep", "run a network with many values of its parameters; also under mpirun on several machines");
  auto a = std::make_shared<Arguments>();
  a->add_to(*command);
  command->add_option("-o,--output", a->output, "folder of the results; default: sweep/CASE");
  auto* force = command->add_flag("--force", a->force, "replace the results of an earlier sweep");
  command->add_flag("--resume", a->resume, "go on with a sweep that was interrupted or killed")
      ->excludes(force);
  command->add_flag("-q,--quiet", a->quiet, "no progress line");
  command->callback([a, &code] { code = run(*a); });
}

}  // namespace ostium::app
