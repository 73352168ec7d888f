#include "app/results/recorder.hpp"

#include <algorithm>
#include <map>
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

void archive(Archive& a, Recorded& r) {
  a("time", r.time);
  a("wall", r.wall);
  a.part("rows", [&] { r.rows.archive(a); });
  a.part("balance_rows", [&] { r.balance_rows.archive(a); });
  a.part("statistics", [&] { r.statistics.archive(a); });
  a.part("derived", [&] { archive(a, r.derived); });
  a("ports_bytes", r.ports_bytes);
  a("network_bytes", r.network_bytes);
  a("balance_bytes", r.balance_bytes);
  a("warnings", r.warnings);
}

Recorder::Recorder(const Case& study, std::string case_name, const ResultsFolder& folder,
                   const std::string& effective, Names names, const std::optional<Recorded>& saved)
    : study_(study),
      case_name_(std::move(case_name)),
      folder_(folder),
      names_(std::move(names)),
      rows_(study.output.every),
      balance_rows_(study.output.every),
      derived_(names_.elements, names_.ports, names_.series, study.time.period.value_or(0)) {
  folder_.create();
  log::open_file(folder_.file("log.txt"), saved.has_value());
  write_text(folder_.file("case.effective.yaml"), effective);
  for (const auto& port : names_.ports) track("pressure " + port, 'p'), track("flow_out " + port, 'q');
  for (const auto& series : names_.series) track(series, series[0]);
  statistics_ = CycleStatistics(study.time.period.value_or(0), tracked_.size());
  open(saved);
  if (saved) recall(*saved);
}

void Recorder::open(const std::optional<Recorded>& saved) {
  const auto keep = [&](std::int64_t Recorded::*bytes) {
    return saved ? Keep(static_cast<std::uintmax_t>((*saved).*bytes)) : Keep();
  };
  network_.emplace(folder_.file("network.csv"), names_.series, keep(&Recorded::network_bytes));
  if (names_.ports.empty()) return;
  ports_.emplace(folder_.file("ports.csv"), names_.ports, keep(&Recorded::ports_bytes));
  balance_.emplace(folder_.file("balance.csv"), keep(&Recorded::balance_bytes));
}

void Recorder::recall(const Recorded& saved) {
  OSTIUM_ASSERT(saved.statistics.series() == tracked_.size(), "statistics of {} series saved, {} series",
                saved.statistics.series(), tracked_.size());
  time_ = saved.time, wall_before_ = saved.wall;
  rows_.go_on(saved.rows), balance_rows_.go_on(saved.balance_rows);
  statistics_ = saved.statistics;
  derived_.recall(saved.derived);
  log::recall_warnings(saved.warnings);
}

Recorded Recorder::save() {
  Recorded r{.time = time_, .wall = wall(), .rows = rows_, .balance_rows = balance_rows_};
  r.derived = derived_.save();
  r.statistics = statistics_;
  r.network_bytes = static_cast<std::int64_t>(network_->bytes());
  if (ports_) r.ports_bytes = static_cast<std::int64_t>(ports_->bytes());
  if (balance_) r.balance_bytes = static_cast<std::int64_t>(balance_->bytes());
  r.warnings = log::warnings();
  return r;
}

double Recorder::wall() const {
  return wall_before_ + std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
}

void Recorder::track(const std::string& name, char kind) {
  const bool pressure = kind == 'p', flow = kind == 'q';
  tracked_.push_back({name,
                      pressure ? "mmHg"
                      : flow   ? "mL/s"
                               : "SI",
                      pressure ? 1 / to_si(1, "mmHg", "Pa")
                      : flow   ? 1e6
                               : 1.0});
}

bool Recorder::row(double time, std::span<const PortRow> ports, std::span<const double> series) {
  time_ = time;
  row_.clear();
  for (const auto& port : ports) row_.insert(row_.end(), {port.pressure, port.flow_out});
  row_.insert(row_.end(), series.begin(), series.end());
  statistics_.add(time, row_);
  derived_.row(time, series);
  if (time < study_.output.from * (1 - 1e-9) || !rows_.due(time)) return false;
  if (ports_) ports_->rows(time, ports);
  network_->row(time, series);
  return true;
}

void Recorder::balance(const BalanceRow& row) {
  if (balance_ && row.time >= study_.output.from * (1 - 1e-9) && balance_rows_.due(row.time))
    balance_->row(row);
}

void Recorder::flush() {
  network_->flush();
  if (ports_) ports_->flush();
  if (balance_) balance_->flush();
}

double Recorder::periodicity() const {
  double change = 0;
  for (std::size_t i = 0; i < tracked_.size(); ++i) change = std::max(change, statistics_.change(i));
  return tracked_.empty() ? 1 : change;
}

json Recorder::series() const {
  json all = json::object();
  for (std::size_t i = 0; i < tracked_.size(); ++i) {
    const auto cycles = statistics_.cycles(i);
    if (cycles.empty()) continue;
    const auto& last = last_complete(cycles);
    all[tracked_[i].name] = {
        {"mean", last.mean}, {"min", last.min}, {"max", last.max}, {"cycle_means", means_of(cycles)}};
  }
  return all;
}

json Recorder::derived() const {
  std::map<std::string, std::size_t> place;
  for (std::size_t i = 0; i < tracked_.size(); ++i) place.emplace(tracked_[i].name, i);
  return derived_.results([&](const std::string& name) -> std::optional<CycleValues> {
    const auto at = place.find(name);
    if (at == place.end()) return {};
    const auto cycles = statistics_.cycles(at->second);
    return cycles.empty() ? std::nullopt : std::optional(last_complete(cycles));
  });
}

void Recorder::finish(Status status, const json& facts) {
  flush();
  json summary = {
      {"program", {{"name", "ostium"}, {"version", version}}},
      {"case", case_name_},
      {"title", study_.title},
      {"status", word(status)},
      {"machine", {{"hardware_threads", std::thread::hardware_concurrency()}}},
      {"time",
       {{"end_s", study_.time.final()}, {"reached_s", time_}, {"period_s", study_.time.period.value_or(0)}}},
      {"wall_s", wall()},
      {"periodicity", {{"change_between_last_cycles", periodicity()}}},
      {"series", series()},
      {"derived", derived()},
      {"warnings", log::warnings()}};
  summary.update(facts, true);
  write_text(folder_.file("summary.json"), summary.dump(2) + "\n");
}

std::string Recorder::table() const {
  std::size_t width = 12;
  for (const auto& t : tracked_) width = std::max(width, t.name.size());
  std::string text =
      fmt::format("{:<{}}  {:>6} {:>11} {:>11} {:>11}\n", "last cycle", width, "unit", "mean", "min", "max");
  for (std::size_t i = 0; i < tracked_.size(); ++i) {
    const auto& t = tracked_[i];
    const auto cycles = statistics_.cycles(i);
    if (cycles.empty()) continue;
    const auto& c = last_complete(cycles);
    text += fmt::format("{:<{}}  {:>6} {:>11.5g} {:>11.5g} {:>11.5g}\n", t.name, width, t.unit,
                        t.scale * c.mean, t.scale * c.min, t.scale * c.max);
  }
  return text;
}

}  // namespace ostium::app
