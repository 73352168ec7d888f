/// Takes down a run as it goes: series, statistics of the cycles, and at the end the summary, in one results folder.
///
/// Statistics see every row they are given, the files one row per `output.every`. The folder is made by the constructor;
/// construct it when nothing can be wrong with the input any more.
#pragma once
#include <chrono>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>

#include "app/case.hpp"
#include "app/results/cycles.hpp"
#include "app/results/derived.hpp"
#include "app/results/folder.hpp"
#include "app/results/series.hpp"

namespace ostium::app {

enum class Status { finished, interrupted, failed };

/// What a recorder goes on from: statistics, and how long its files were.
struct Recorded {
  double time = 0, wall = 0;  // s; wall: of the sittings so far
  Thinning rows, balance_rows;
  CycleStatistics statistics{};
  DerivedState derived{};
  std::int64_t ports_bytes = 0, network_bytes = 0, balance_bytes = 0;
  std::vector<std::string> warnings{};
};
void archive(Archive& a, Recorded& recorded);

class Recorder {
 public:
  struct Names {
    std::vector<std::string> ports;   // openings, empty for a standalone network
    std::vector<std::string> series;  // of the network
    std::vector<Element> elements{};  // its blocks
  };
  /// `effective` is the text of case.effective.yaml. With `saved` the files are cut back to what they were and continued.
  Recorder(const Case& study, std::string case_name, const ResultsFolder& folder,
           const std::string& effective, Names names, const std::optional<Recorded>& saved = {});
  Recorded save();

  /// True where the row also goes to the files.
  bool row(double time, std::span<const PortRow> ports, std::span<const double> series);
  void balance(const BalanceRow& row);  // thinned like the others
  void flush();

  /// Writes summary.json; `facts` are added to it (counts, wall times, checks).
  void finish(Status status, const nlohmann::json& facts);
  /// Mean, least and largest value of the last complete cycle, in mmHg and mL/s, for the terminal.
  std::string table() const;
  /// Largest change of a mean between the last two cycles over all series; 1 when there are fewer than two.
  double periodicity() const;
  double reached() const { return time_; }
  const ResultsFolder& folder() const { return folder_; }

 private:
  struct Tracked {
    std::string name, unit;
    double scale;  // from SI to the unit
  };
  void track(const std::string& name, char kind);
  void open(const std::optional<Recorded>& saved);
  void recall(const Recorded& saved);
  double wall() const;
  nlohmann::json series() const;
  nlohmann::json derived() const;

  Case study_;
  std::string case_name_;
  ResultsFolder folder_;
  Names names_;
  std::optional<PortsCsv> ports_;
  std::optional<NetworkCsv> network_;
  std::optional<BalanceCsv> balance_;
  Thinning rows_, balance_rows_;
  Derived derived_;
  std::vector<Tracked> tracked_;
  CycleStatistics statistics_;  // of what is tracked
  std::vector<double> row_;
  double time_ = 0, wall_before_ = 0;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace ostium::app
