#include "app/sweep/session.hpp"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <nlohmann/json.hpp>

#include "app/checkpoint/checkpoint.hpp"
#include "app/effective.hpp"
#include "app/interrupt.hpp"
#include "app/sweep/hdf5_table.hpp"
#include "app/sweep/report.hpp"
#include "app/version.hpp"
#include "core/log.hpp"
#include "core/progress.hpp"

namespace ostium::app {
namespace {

using network::Outcome;
using network::SampleResult;

/// All that a sample depends on; a sweep goes on only where it is the same.
CheckpointKey key_of(Case study, const network::Model& model, std::int64_t samples) {
  study.title.clear();
  return {"sweep", effective_case(study, model) + fmt::format("samples: {}\n", samples), ""};
}

// Samples between two processes: outcome, results, length of the reason, reason.

void pack(const SampleResult& s, std::string& bytes) {
  const std::size_t length = s.reason.size();
  bytes += static_cast<char>(s.outcome);
  bytes.append(reinterpret_cast<const char*>(s.results.data()), s.results.size() * sizeof(double));
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  bytes += s.reason;
}

SampleResult unpack(const char*& at, std::size_t results) {
  SampleResult s{static_cast<Outcome>(*at++), std::vector<double>(results)};
  const auto take = [&](void* to, std::size_t size) { std::memcpy(to, at, size), at += size; };
  take(s.results.data(), results * sizeof(double));
  std::size_t length = 0;
  take(&length, sizeof length);
  s.reason.assign(at, length), at += length;
  return s;
}

class SweepSession {
 public:
  SweepSession(const Case& study, const SweepOptions& options, const Ranks& ranks)
      : study_(study), options_(options), ranks_(ranks) {
    ranks_.each([&] {
      plan_.emplace(sweep_plan(study));
      sweep_.emplace(plan_->model, plan_->design, plan_->results, plan_->run, options.threads);
    });
    ranks_.each([&] {
      if (ranks_.first()) open();
    });
  }

  int go() {
    const std::int64_t end = plan_->design.rows(), begin = ranks_.from_first(table_ ? table_->rows() : 0);
    Progress progress({.start = static_cast<double>(begin),
                       .end = static_cast<double>(end),
                       .quiet = options_.quiet || !ranks_.first(),
                       .task = "sweep"});
    std::int64_t done = begin, block = least_block();
    while (done < end && !stopped_) {
      const auto started = Clock::now();
      const auto samples = run_block(done, std::min(done + block, end));
      ranks_.each([&] { write(samples); });
      done = ranks_.from_first(table_ ? table_->rows() : 0);
      stopped_ = ranks_.from_first(stopped_) != 0;
      block = ranks_.from_first(next_block(block, seconds_since(started)));
      progress.update(static_cast<double>(done), 0, rate(done - begin, end));
    }
    progress.finish();
    std::int64_t code = exit_ok;
    ranks_.each([&] {
      if (ranks_.first()) code = stopped_ ? stop() : finish(done - begin);
    });
    return static_cast<int>(ranks_.from_first(code));
  }

 private:
  using Clock = std::chrono::steady_clock;
  static double seconds_since(Clock::time_point t) {
    return std::chrono::duration<double>(Clock::now() - t).count();
  }

  // --- blocks of samples ---

  std::int64_t least_block() const { return std::int64_t{4} * options_.threads * ranks_.count(); }

  /// Half a second of work: little is lost by a kill, and an interruption is soon obeyed.
  std::int64_t next_block(std::int64_t block, double seconds) const {
    constexpr double wanted = 0.5;
    const double factor = std::clamp(wanted / std::max(seconds, 1e-6), 0.5, 4.0);
    constexpr std::int64_t most = 1 << 18;
    return std::clamp(static_cast<std::int64_t>(static_cast<double>(block) * factor), least_block(), most);
  }

  /// Of all processes, in order; in the first process only.
  std::vector<SampleResult> run_block(std::int64_t first, std::int64_t end) {
    std::vector<SampleResult> mine;
    ranks_.each([&] { mine = sweep_->run(first + ranks_.rank(), end, ranks_.count(), interrupted); });
    if (ranks_.count() == 1) return mine;
    std::string bytes;
    for (auto& s : mine) s.results.resize(plan_->results.size(), NAN), pack(s, bytes);
    const auto all = ranks_.gather(bytes);
    std::vector<SampleResult> samples;
    if (!ranks_.first()) return samples;
    std::vector<const char*> at;
    for (const auto& part : all) at.push_back(part.data());
    for (std::int64_t i = first; i < end; ++i)
      samples.push_back(
          unpack(at[static_cast<std::size_t>((i - first) % ranks_.count())], plan_->results.size()));
    return samples;
  }

  void write(const std::vector<SampleResult>& samples) {
    if (!ranks_.first()) return;
    for (const auto& s : samples) {
      if (s.outcome == Outcome::open) {
        stopped_ = true;
        break;
      }
      if (s.outcome != Outcome::ok) tell(s);
      table_->add(s);
    }
    table_->flush();
  }

  void tell(const SampleResult& s) {
    constexpr int most = 10;
    if (told_++ < most) log::warn("sample {}: {}: {}", table_->rows(), word(s.outcome), s.reason);
    if (told_ == most + 1)
      log::warn("more samples without results follow, see the column status of sweep.csv");
  }

  std::string rate(std::int64_t done, std::int64_t end) const {
    return fmt::format("{} of {} samples  {:.3g} per second", table_ ? table_->rows() : 0, end,
                       static_cast<double>(done) / seconds_since(started_));
  }

  // --- the folder ---

  void open() {
    folder_.emplace(options_.folder, options_.earlier);
    const auto key = key_of(study_, plan_->model, plan_->design.rows());
    const ArchiveBody nothing = [](Archive&) {};
    if (folder_->resumes()) read_checkpoint(folder_->checkpoint(), key, nothing);
    folder_->create();
    log::open_file(folder_->file("log.txt"), folder_->resumes());
    table_.emplace(folder_->file("sweep.csv"), *plan_, folder_->resumes());
    if (!folder_->resumes()) {
      write_text(folder_->file("case.effective.yaml"), effective_case(study_, plan_->model));
      write_checkpoint(folder_->checkpoint(), key, nothing);
    }
    log::info("{}: {} samples of {} parameters, {} results; {} thread{}{}", options_.case_name,
              plan_->design.rows(), plan_->design.columns(), plan_->results.size(), options_.threads,
              options_.threads == 1 ? "" : "s",
              ranks_.count() > 1 ? fmt::format(" in each of {} processes", ranks_.count()) : "");
    if (folder_->resumes()) log::info("the sweep goes on from sample {}", table_->rows());
  }

  nlohmann::json summary(const char* status, std::int64_t done, const std::vector<network::Sobol>& sobol) {
    const double wall = seconds_since(started_);
    nlohmann::json all = {{"program", {{"name", "ostium"}, {"version", version}}},
                          {"case", options_.case_name},
                          {"title", study_.title},
                          {"status", status},
                          {"machine", {{"processes", ranks_.count()}, {"threads", options_.threads}}},
                          {"wall_s", wall},
                          {"samples_per_second", static_cast<double>(done) / wall}};
    all.update(sweep_json(*plan_, *table_, sobol));
    all["warnings"] = log::warnings();
    return all;
  }

  int stop() {
    write_text(folder_->file("summary.json"), summary("interrupted", table_->rows(), {}).dump(2) + "\n");
    log::info("interrupted at {} of {} samples; go on with: {}", table_->rows(), plan_->design.rows(),
              options_.resume_command(ranks_.count()));
    return exit_interrupted;
  }

  int finish(std::int64_t done) {
    if (table_->rows() > rows_for_hdf5) write_hdf5(folder_->file("sweep.h5"), *plan_, *table_);
    const auto sobol = sobol_of(*plan_, *table_);
    if (!sobol.empty()) write_sobol(folder_->file("sobol.csv"), *plan_, sobol);
    const std::int64_t missing = table_->count(Outcome::failed) + table_->count(Outcome::refused);
    if (missing > 0)
      log::warn("{} of {} samples have no result ({} failed, {} refused)", missing, table_->rows(),
                table_->count(Outcome::failed), table_->count(Outcome::refused));
    write_text(folder_->file("summary.json"), summary("finished", done, sobol).dump(2) + "\n");
    std::error_code ignored;
    std::filesystem::remove(folder_->checkpoint(), ignored);  // nothing to go on with
    for (const auto& line : sweep_lines(*plan_, *table_, sobol)) log::info("{}", line);
    const double wall = seconds_since(started_);
    log::info("{} samples in {:.3g} s ({:.0f} per second); results in {}", done, wall,
              static_cast<double>(done) / wall, folder_->path().string());
    return missing == table_->rows() ? exit_numerics_error : exit_ok;
  }

  const Case& study_;
  const SweepOptions& options_;
  const Ranks& ranks_;
  Clock::time_point started_ = Clock::now();
  std::optional<SweepPlan> plan_;
  std::optional<network::Sweep> sweep_;
  std::optional<ResultsFolder> folder_;  // of the first process, as the table
  std::optional<SweepTable> table_;
  bool stopped_ = false;
  int told_ = 0;
};

}  // namespace

std::string SweepOptions::resume_command(int processes) const {
  return (processes > 1 ? fmt::format("mpirun -n {} ", processes) : "") + "ostium sweep " + arguments +
         " -o " + folder.string() + " --resume";
}

int run_sweep(const Case& study, const SweepOptions& options, const Ranks& ranks) {
  return SweepSession(study, options, ranks).go();
}

}  // namespace ostium::app
