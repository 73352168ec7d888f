/// What chambers and the heart share in their translation.
#pragma once
#include "app/import/svzerod_circuit.hpp"

namespace ostium::app::svzerod {

/// The beginning of an activation, {type: ..}.
config::Tree activation_of(const char* type);
/// Start of the volume `state`, that program's `unknown`.
config::Tree start_volume(const Circuit& circuit, const std::string& state, const std::string& unknown);

}  // namespace ostium::app::svzerod
