/// The section `sweep` of a case, checked and in SI: what to run and what to take from it.
#pragma once
#include "app/case.hpp"
#include "network/design.hpp"
#include "network/indices.hpp"
#include "network/study.hpp"

namespace ostium::app {

struct SweepPlan {
  network::Model model;
  network::Design design;
  std::vector<network::Index> results;
  network::StudyRun run;

  /// `body.Rd [Pa.s/m3]`, one per parameter; `mean p:Ao [Pa]`, one per result. Without dimension: the name alone.
  std::vector<std::string> parameter_columns() const, result_columns() const;
};

/// Throws UserError with position.
SweepPlan sweep_plan(const Case& study);

/// The samples of a CSV file, one listed variation per column: those of the names, or without names all.
/// Throws UserError with file and line.
std::vector<network::Variation> read_samples(const std::filesystem::path& file, const network::Model& model,
                                             const std::vector<std::string>& names);

}  // namespace ostium::app
