/// A case without a vessel: the network alone, from its initial state to the end time.
#pragma once
#include "app/case.hpp"
#include "app/run_options.hpp"

namespace ostium::app {

/// Returns the exit code. Throws UserError before anything is written, NumericsError when the integrator gives up.
int run_study(const Case& study, const RunOptions& options);

}  // namespace ostium::app
