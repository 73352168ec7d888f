/// `ostium sweep CASE`: a network alone, run with many values of its parameters.
///
///   sweep.csv      one row per sample: parameters, results, status
///   sweep.h5       the same, where there are more than 10^5 samples
///   sobol.csv      Sobol indices, where the samples are of a Saltelli design
///   summary.json, case.effective.yaml, log.txt     as those of a run
///
/// Samples are run in blocks; a block is written as soon as it is there, and what is written is not run again by
/// --resume. The bytes of the tables depend neither on threads, processes nor interruptions.
#pragma once
#include <optional>

#include "app/run_options.hpp"
#include "app/sweep/ranks.hpp"
#include "app/sweep/table.hpp"

namespace ostium::app {

struct SweepOptions {
  std::string arguments;  // of the case: file, overrides
  std::string case_name;
  std::filesystem::path folder;
  Earlier earlier = Earlier::refuse;
  bool quiet = false;
  int threads = 1;

  /// The command that goes on with this sweep, run by so many processes.
  std::string resume_command(int processes) const;
};

/// Returns the exit code: 3 where every sample has failed. Throws UserError before anything is written.
int run_sweep(const Case& study, const SweepOptions& options, const Ranks& ranks);

}  // namespace ostium::app
