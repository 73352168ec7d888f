#include "app/results/recorder.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/version.hpp"
#include "core/log.hpp"
#include "core/units.hpp"

namespace ostium::app {
namespace {

using nlohmann::json;

const char* word(Status status) {
  return status == Status::finished ? "finished" : status == Status::interrupted ? "interrupted" : "failed";
}

/// The last cycle that was not cut short; the last one if there is only a piece.
const CycleValues& last_complete(const std::vector<CycleValues>& cycles) {
  const bool cut =
      cycles.size() > 1 && cycles.back().duration < cycles[cycles.size() - 2].duration * (1 - 1e-6);
  return cut ? cycles[cycles.size() - 2] : cycles.back();
}

json means_of(const std::vector<CycleValues>& cycles) {
  json means = json::array();
  for (const auto& c : cycles) means.push_back(c.mean);
  return means;
}

}  // namespace

Recorder::Recorder(const Case& study, std::string case_name, const ResultsFolder& folder,
                   const std::string& effective, Names names)
    : study_(study),
      case_name_(std::move(case_name)),
      folder_(folder),
      names_(std::move(names)),
      rows_(study.output.every),
      balance_rows_(study.output.every) {
  folder_.create();
  log::open_file(folder_.file("log.txt"));
  write_text(folder_.file("case.effective.yaml"), effective);
  network_.emplace(folder_.file("network.csv"), names_.series);
  if (!names_.ports.empty()) ports_.emplace(folder_.file("ports.csv"), names_.ports);
  if (!names_.ports.empty()) balance_.emplace(folder_.file("balance.csv"));
  for (const auto& port : names_.ports) track("pressure " + port, 'p'), track("flow_out " + port, 'q');
  for (const auto& series : names_.series) track(series, series[0]);
}

void Recorder::track(const std::string& name, char kind) {
  const bool pressure = kind == 'p', flow = kind == 'q';
  tracked_.push_back({name,
                      pressure ? "mmHg"
                      : flow   ? "mL/s"
                               : "SI",
                      pressure ? 1 / to_si(1, "mmHg", "Pa")
                      : flow   ? 1e6
                               : 1.0,
                      CycleStatistics(study_.time.period.value_or(0))});
}

void Recorder::row(double time, std::span<const PortRow> ports, std::span<const double> series) {
  time_ = time;
  std::size_t i = 0;
  for (const auto& port : ports) {
    tracked_[i++].statistics.add(time, port.pressure);
    tracked_[i++].statistics.add(time, port.flow_out);
  }
  for (double value : series) tracked_[i++].statistics.add(time, value);
  if (!rows_.due(time)) return;
  if (ports_) ports_->rows(time, ports);
  network_->row(time, series);
}

void Recorder::balance(const BalanceRow& row) {
  if (balance_ && balance_rows_.due(row.time)) balance_->row(row);
}

void Recorder::flush() {
  network_->flush();
  if (ports_) ports_->flush();
  if (balance_) balance_->flush();
}

double Recorder::periodicity() const {
  double change = 0;
  for (const auto& t : tracked_) change = std::max(change, t.statistics.change());
  return tracked_.empty() ? 1 : change;
}

json Recorder::statistics() const {
  json all = json::object();
  for (const auto& t : tracked_) {
    const auto cycles = t.statistics.cycles();
    if (cycles.empty()) continue;
    const auto& last = last_complete(cycles);
    all[t.name] = {
        {"mean", last.mean}, {"min", last.min}, {"max", last.max}, {"cycle_means", means_of(cycles)}};
  }
  return all;
}

void Recorder::finish(Status status, const json& facts) {
  flush();
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  json summary = {
      {"program", {{"name", "ostium"}, {"version", version}}},
      {"case", case_name_},
      {"title", study_.title},
      {"status", word(status)},
      {"machine", {{"hardware_threads", std::thread::hardware_concurrency()}}},
      {"time",
       {{"end_s", study_.time.final()}, {"reached_s", time_}, {"period_s", study_.time.period.value_or(0)}}},
      {"wall_s", wall},
      {"periodicity", {{"change_between_last_cycles", periodicity()}}},
      {"series", statistics()},
      {"warnings", log::warnings()}};
  summary.update(facts, true);
  write_text(folder_.file("summary.json"), summary.dump(2) + "\n");
}

std::string Recorder::table() const {
  std::size_t width = 12;
  for (const auto& t : tracked_) width = std::max(width, t.name.size());
  std::string text =
      fmt::format("{:<{}}  {:>6} {:>11} {:>11} {:>11}\n", "last cycle", width, "unit", "mean", "min", "max");
  for (const auto& t : tracked_) {
    const auto cycles = t.statistics.cycles();
    if (cycles.empty()) continue;
    const auto& c = last_complete(cycles);
    text += fmt::format("{:<{}}  {:>6} {:>11.5g} {:>11.5g} {:>11.5g}\n", t.name, width, t.unit,
                        t.scale * c.mean, t.scale * c.min, t.scale * c.max);
  }
  return text;
}

}  // namespace ostium::app
