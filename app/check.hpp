/// `ostium check`: reads and checks everything a run would, tells what it found, runs and writes nothing.
#pragma once
#include <string>
#include <vector>

#include "app/case.hpp"
#include "app/estimate.hpp"

namespace ostium::app {

/// What the terminal shows; throws UserError where a run would.
std::string check(const Case& study, int threads);

/// One line per block: name, type, ends.
std::vector<std::string> network_lines(const network::Model& model);

/// Particles, memory and run time to be expected.
std::vector<std::string> estimate_lines(const Case& study, const Estimate& estimate, int threads);

}  // namespace ostium::app
