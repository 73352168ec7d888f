/// A case with a vessel: blood in 2D or 3D and the network beyond its openings, together.
#pragma once
#include "app/case.hpp"
#include "app/run_options.hpp"

namespace ostium::app {

/// Returns the exit code. Throws UserError before anything is written.
int run_coupled(const Case& study, const RunOptions& options);

}  // namespace ostium::app
