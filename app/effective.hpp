/// The effective case: every default filled in, all values in SI, files by absolute names or written out.
#pragma once
#include <string>

#include "app/case.hpp"
#include "network/model.hpp"

namespace ostium::app {

/// YAML that reads back to the same case and the same blocks.
std::string effective_case(const Case& study, const network::Model& model);

}  // namespace ostium::app
