/// One network run again and again with other values of its parameters: joined once, its results over the last period.
///
///   from rest        from t = 0 to the end, results over the last period (without a period over the whole run)
///   periodic         the periodic state, results over one period
///
/// Results do not depend on what was run before. One thread at a time may use a study.
/// Not checked: that the rows resolve the series (network/row_indices).
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "network/orbit.hpp"
#include "network/row_indices.hpp"
#include "network/simulate.hpp"

namespace ostium::network {

struct StudyRun {
  double end = 1.0;     // s
  double every = 0.01;  // s between the rows from which the results are taken
  double period = 0.0;  // s, 0: none
  Initial initial = Initial::rest;
};

class Study {
 public:
  /// Throws UserError: the network, or a parameter that changes the period of a periodic run.
  Study(const Model& model, std::vector<Parameter> parameters, const std::vector<Index>& indices,
        const StudyRun& run);

  /// values: one per parameter, results: one per index, SI. Throws UserError where the values are refused, NumericsError
  /// where the run fails or a result is not finite.
  void run(std::span<const double> values, std::span<double> results);

 private:
  void run_periodic();
  void from_periodic(double enough);
  void window();
  double change() const;

  StudyRun run_;
  std::vector<Parameter> parameters_;
  std::vector<Index> indices_;
  Changes changes_;
  Network network_;
  std::optional<Orbit> orbit_;
  RowIndices rows_;
  double begins_ = 0;          // s, of the results
  std::vector<double> times_;  // s, of the rows after that
  std::vector<double> y_;      // where the results begin
};

}  // namespace ostium::network
