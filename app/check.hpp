/// `ostium check`: reads and checks everything a run would, tells what it found, runs and writes nothing.
#pragma once
#include <string>

#include "app/case.hpp"

namespace ostium::app {

/// What the terminal shows; throws UserError where a run would.
std::string check(const Case& study, int threads);

}  // namespace ostium::app
