/// The results of a sweep as they come: sweep.csv, which is also what an interrupted sweep goes on from.
///
///   sample, parameters .., results .., status     one row per sample, in order; SI; nan where there is no result
///
/// What is flushed survives the end of the program, whatever ended it; a row that was cut short is run again.
#pragma once
#include <memory>
#include <optional>

#include "app/results/folder.hpp"
#include "app/sweep/plan.hpp"
#include "core/csv.hpp"
#include "network/sweep.hpp"

namespace ostium::app {

class SweepTable {
 public:
  /// Begins the table, or takes up what is there. Throws UserError where that is not of this plan.
  SweepTable(std::filesystem::path file, const SweepPlan& plan, bool resumes);

  std::int64_t rows() const { return static_cast<std::int64_t>(outcomes_.size()); }
  void add(const network::SampleResult& sample);
  void flush() { csv_->flush(); }

  network::Outcome outcome(std::int64_t row) const { return outcomes_[static_cast<std::size_t>(row)]; }
  double result(std::int64_t row, std::size_t k) const {
    return results_[static_cast<std::size_t>(row) * plan_.results.size() + k];
  }
  std::int64_t count(network::Outcome outcome) const;

 private:
  std::vector<std::string> header() const;
  std::uintmax_t take_up();
  void take_up_row(const std::string& line);

  std::filesystem::path file_;
  const SweepPlan& plan_;
  std::optional<CsvWriter> csv_;
  std::vector<network::Outcome> outcomes_;
  std::vector<double> results_;  // row by row
  std::vector<double> values_;   // of the parameters in one row
};

/// The word of the column `status`.
const std::string& word(network::Outcome outcome);

}  // namespace ostium::app
