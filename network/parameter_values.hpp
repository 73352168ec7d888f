/// The parameters of one use of a subnetwork, and the values of its definition in which they stand.
///
///   "$R"              the parameter's value as it was given: a quantity, or anything else the block reads there
///   "0.1 * $R + $Z"   sum of products of parameters and plain numbers, evaluated in SI; the unit follows
///
/// Throws UserError at the value that cannot be evaluated. Not checked: that a block expects this dimension (the block
/// does).
#pragma once
#include <map>
#include <string>

#include "core/config.hpp"

namespace ostium::network {

struct ParameterValue {
  config::Node node;  // where it is given: at the use, or the default of the definition
  std::string unit;   // SI
};
/// In the SI unit; a plain number where that is 1. Throws UserError with position.
double read(const ParameterValue& value);

using ParameterValues = std::map<std::string, ParameterValue>;

/// `value` with every "$name" in it evaluated.
config::TreePtr evaluated(const config::Node& value, const ParameterValues& parameters);

}  // namespace ostium::network
