/// What the command line says about a run beside its case.
#pragma once
#include <string>

#include "app/results/folder.hpp"

namespace ostium::app {

struct RunOptions {
  std::string arguments;  // of the case: file, overrides
  std::string case_name;
  ResultsFolder folder;
  bool quiet = false;
  int threads = 0;       // 0: as many as the machine has
  bool svzerod = false;  // also writes svzerod.csv

  /// The command that goes on with this run.
  std::string resume_command() const {
    return "ostium run " + arguments + " -o " + folder.path().string() +
           (svzerod ? " --format svzerod" : "") + " --resume";
  }
};

inline constexpr int exit_ok = 0, exit_user_error = 2, exit_numerics_error = 3, exit_bug = 70,
                     exit_interrupted = 130;

}  // namespace ostium::app
