/// Which units a model without units is in.
#pragma once
#include <string>
#include <utility>

#include "app/import/svzerod_source.hpp"
#include "app/import/unit_system.hpp"

namespace ostium::app::svzerod {

/// Name of the system and why: what the parts are defined in, else density or viscosity, else the magnitude of
/// pressures and flows.
std::pair<std::string, std::string> guess_units(const Source& source);

}  // namespace ostium::app::svzerod
