#include "app/study.hpp"

#include <nlohmann/json.hpp>

#include "app/checkpoint/checkpoint.hpp"
#include "app/effective.hpp"
#include "app/interrupt.hpp"
#include "app/results/recorder.hpp"
#include "app/results/sensitivity_output.hpp"
#include "app/results/svzerod_csv.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "core/progress.hpp"
#include "network/network.hpp"

namespace ostium::app {
namespace {

struct SavedStudy {
  network::State state;
  Recorded recorded;
  std::int64_t rows = 0;
};

void archive(Archive& a, SavedStudy& saved) {
  a.part("network", [&] { network::archive(a, saved.state); });
  a.part("recorded", [&] { archive(a, saved.recorded); });
  a("rows", saved.rows);
}

/// A network alone: rows as they come, a checkpoint where the run ends before its time.
class StudySession {
 public:
  StudySession(const Case& study, const RunOptions& options)
      : study_(study),
        options_(options),
        model_(network::read_model(study.network.blocks)),
        end_(study.time.final()) {
    if (options.folder.resumes())
      read_checkpoint(options.folder.checkpoint(), key(), [&](Archive& a) { archive(a, saved_.emplace()); });
    rows_ = saved_ ? saved_->rows : 0;
  }

  int go() {
    const double start = start_time();
    Progress progress(
        {.start = start, .end = end_, .period = study_.time.period.value_or(0), .quiet = options_.quiet});
    try {
      network::simulate(model_, simulation(), sink(progress));
    } catch (const NumericsError& e) {
      if (!recorder_) throw;
      recorder_->finish(Status::failed, {{"rows", rows_}});
      numerics_error("{}\nthe last sound state is saved; go on from there with: {}", e.what(),
                     options_.resume_command());
    }
    progress.finish();
    return stopped_ ? stop() : finish();
  }

 private:
  CheckpointKey key() const { return checkpoint_key(study_, model_); }

  double start_time() const { return saved_ ? saved_->recorded.time : 0.0; }

  network::SimulateOptions simulation() const {
    return {.end = end_,
            .every = study_.output.every,
            .initial = study_.initial(),
            .period = study_.time.period.value_or(0),
            .from = saved_ ? std::optional(saved_->state) : std::nullopt,
            .handed_out = start_time()};
  }

  network::Sink sink(Progress& progress) {
    return {.begin = [this](const auto& names) { begin(names); },
            .row =
                [&](double t, std::span<const double> values) {
                  const bool written = recorder_->row(t, {}, values);
                  if (svzerod_ && written) svzerod_->row(t, values);
                  progress.update(t, ++rows_);
                  stopped_ = interrupted() && t < end_;
                  return !stopped_;
                },
            .keep = [this](const network::State& state) { keep(state); },
            .periodic = [this](const network::PeriodicReport& report) { periodic_ = report; }};
  }

  /// Nothing can be wrong with the input any more.
  void begin(const std::vector<std::string>& names) {
    sought_ = sought(study_, model_, names);
    if (options_.svzerod) svzerod_.emplace(study_, names);
    recorder_.emplace(study_, options_.case_name, options_.folder, effective_case(study_, model_),
                      Recorder::Names{{}, names, elements_of(model_)},
                      saved_ ? std::optional(saved_->recorded) : std::nullopt);
    if (svzerod_ && saved_) svzerod_->recall(options_.folder);
    log::info("{}: {} blocks, {} series, to {:.4g} s", options_.case_name, model_.entries.size(),
              names.size(), end_);
    if (periodic_) log::info("{}", periodic_line(*periodic_));
    if (saved_) log::info("the run goes on from {:.6g} s", start_time());
  }

  void keep(const network::State& state) {
    SavedStudy saved{state, recorder_->save(), rows_};
    write_checkpoint(options_.folder.checkpoint(), key(), [&](Archive& a) { archive(a, saved); });
  }

  int finish() {
    recorder_->finish(Status::finished, facts());
    if (svzerod_) svzerod_->write(options_.folder);
    std::error_code ignored;
    std::filesystem::remove(options_.folder.checkpoint(), ignored);  // nothing to go on with
    log::info("{}", recorder_->table());
    log::info("results in {}", options_.folder.path().string());
    return exit_ok;
  }

  nlohmann::json facts() {
    nlohmann::json all = {{"rows", rows_}};
    if (periodic_) all["periodic_state"] = periodic_json(*periodic_);
    if (sought_.of.empty() || sought_.to.empty()) return all;
    all["sensitivities"] = write_sensitivities(study_, model_, sought_, options_.folder);
    log::info("{} sensitivities in {}", sought_.of.size() * sought_.to.size(),
              options_.folder.file("sensitivities.csv").string());
    return all;
  }

  int stop() {
    recorder_->finish(Status::interrupted, {{"rows", rows_}});
    log::info("{}", recorder_->table());
    log::info("interrupted at {:.4g} of {:.4g} s; go on with: {}", recorder_->reached(), end_,
              options_.resume_command());
    return exit_interrupted;
  }

  const Case& study_;
  const RunOptions& options_;
  network::Model model_;
  double end_;
  std::optional<SavedStudy> saved_;
  std::optional<Recorder> recorder_;
  std::optional<SvzerodCsv> svzerod_;
  std::optional<network::PeriodicReport> periodic_;
  Sought sought_;
  std::int64_t rows_ = 0;
  bool stopped_ = false;
};

}  // namespace

int run_study(const Case& study, const RunOptions& options) { return StudySession(study, options).go(); }

}  // namespace ostium::app
