/// Values of a case whose dimension is not known before the network is read: texts with units.
#pragma once
#include <string>

#include "core/config.hpp"

namespace ostium::app {

/// "93 mmHg" in the SI unit; a plain number where that is "1". Throws UserError at `place`.
double measured(const config::Node& place, const std::string& text, const std::string& unit);

}  // namespace ostium::app
