/// The sensitivities a case asks for: read and checked before the run, written behind it.
///
///   sensitivities.csv   index, unit, value, parameter, parameter_unit, parameter_value, derivative, relative
///   summary.json        "sensitivities": the same, per index
///
///   derivative   dI/dp in SI;   relative   (dI/dp) |p|/|I|: per cent of the index per per cent of the parameter
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "app/case.hpp"
#include "app/results/folder.hpp"
#include "network/sensitivities.hpp"

namespace ostium::app {

struct Sought {
  std::vector<network::Index> of;
  std::vector<network::Parameter> to;
};

/// Throws UserError with the position of `sensitivities`. Nothing is sought where the case has none.
Sought sought(const Case& study, const network::Model& model, const std::vector<std::string>& series);

/// Computes, writes the table, and returns what belongs into the summary.
nlohmann::json write_sensitivities(const Case& study, const network::Model& model, const Sought& sought,
                                   const ResultsFolder& folder);

/// "periodic_state" of the summary: method, cycle integrations, change per cycle of every state.
nlohmann::json periodic_json(const network::PeriodicReport& report);
/// The same in a line for the terminal.
std::string periodic_line(const network::PeriodicReport& report);

}  // namespace ostium::app
