#include "app/study.hpp"

#include <nlohmann/json.hpp>

#include "app/effective.hpp"
#include "app/interrupt.hpp"
#include "app/results/recorder.hpp"
#include "core/log.hpp"
#include "core/progress.hpp"
#include "network/network.hpp"

namespace ostium::app {
namespace {

int report(Recorder& recorder, bool stopped, long rows, double end) {
  recorder.finish(stopped ? Status::interrupted : Status::finished, {{"rows", rows}});
  log::info("{}", recorder.table());
  if (stopped)
    log::info("interrupted at {:.4g} of {:.4g} s; the series up to there are in {}", recorder.reached(), end,
              recorder.folder().path().string());
  else
    log::info("results in {}", recorder.folder().path().string());
  return stopped ? exit_interrupted : exit_ok;
}

}  // namespace

int run_study(const Case& study, const RunOptions& options) {
  const network::Model model = network::read_model(study.network.blocks);
  const double end = study.time.final();
  std::optional<Recorder> recorder;
  Progress progress({.end = end, .period = study.time.period.value_or(0), .quiet = options.quiet});
  long rows = 0;
  bool stopped = false;

  network::Sink sink;
  sink.begin = [&](const std::vector<std::string>& names) {  // nothing can be wrong with the input any more
    recorder.emplace(study, options.case_name, options.folder, effective_case(study, model),
                     Recorder::Names{{}, names});
    log::info("{}: {} blocks, {} series, to {:.4g} s", options.case_name, model.entries.size(), names.size(),
              end);
  };
  sink.row = [&](double t, std::span<const double> values) {
    recorder->row(t, {}, values);
    progress.update(t, ++rows);
    stopped = interrupted() && t < end;
    return !stopped;
  };
  try {
    network::simulate(model,
                      {.end = end,
                       .every = study.output.every,
                       .initial = study.initial(),
                       .period = study.time.period.value_or(0)},
                      sink);
  } catch (const NumericsError&) {
    if (recorder) recorder->finish(Status::failed, {{"rows", rows}});
    throw;
  }
  progress.finish();
  return report(*recorder, stopped, rows, end);
}

}  // namespace ostium::app
