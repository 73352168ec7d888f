/// The series of a run in the layout of svZeroDSolver: svzerod.csv with `name,time,y`, grouped by name.
///
///   name   of an unknown, as `output.svzerod.variables` of the case says, else of a series
///   time   s; of the last cycle from 0, or of all cycles; empty with mean_only
///   y      in the unit the case gives; in the first row the given start, where the case has one
///
/// Kept until the run is over; a run that is resumed takes the rows before from network.csv.
#pragma once
#include <span>
#include <unordered_map>
#include <vector>

#include "app/case.hpp"
#include "app/results/folder.hpp"

namespace ostium::app {

class SvzerodCsv {
 public:
  /// Throws UserError with position where the case names a series the network does not have.
  SvzerodCsv(const Case& study, const std::vector<std::string>& series);
  /// The rows of network.csv as it is now come first.
  void recall(const ResultsFolder& folder);
  /// One that also goes to network.csv.
  void row(double time, std::span<const double> series);
  void write(const ResultsFolder& folder) const;

 private:
  struct Term {
    double factor;
    std::size_t series;  // its place in a row
  };
  struct Variable {
    std::string name;
    double unit = 1;  // SI
    std::vector<Term> terms;
    double constant = 0;
    std::optional<double> start = {};  // in the unit
    double value(const double* series) const;
  };
  Variable read(const std::string& name, const config::Node& node) const;

  std::vector<std::string> series_;
  std::unordered_map<std::string, std::size_t> place_;  // of a series in a row
  std::vector<Variable> variables_;
  std::vector<double> times_, values_;  // values: all series of the first row, of the next one, ..
  double begin_ = 0, shift_ = 0;        // s: first row, time written as 0
  bool mean_only_;
};

}  // namespace ostium::app
