/// A model of svZeroDSolver as a case of ours.
///
///   model.json -> parts, connections -> steady stage (where asked for) -> blocks with start values -> case.yaml
///
/// The case runs as many cycles from the same start and keeps under `output.svzerod` what each unknown of that program
/// is in terms of its own series, so that results map back. Chosen here, because the format leaves it open: units
/// (density and viscosity tell, or parts, else the system in which pressures and flows are nearest to those of a body);
/// `use_cycle_to_cycle_error` becomes a number of cycles (svzerod_cycles.hpp).
/// Not checked: that the parameters make sense.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/import/json_node.hpp"
#include "app/import/svzerod_source.hpp"
#include "app/import/unit_system.hpp"

namespace ostium::app {

struct Imported {
  std::string yaml;       // the case
  std::string units;      // name of the system
  std::string why_units;  // "density 1.06"
  std::size_t blocks = 0, variables = 0;
  std::vector<std::string> notes;  // what is left out or has no meaning here
};

/// Throws UserError with file and JSON path; also where the network cannot be solved as it is joined.
/// `tell` hears how far those stages are in which the network is run: mostly milliseconds, at worst minutes.
Imported import_svzerod(const std::filesystem::path& file, const std::optional<std::string>& units = {},
                        const svzerod::Tell& tell = svzerod::nobody);
/// `file` gives the case its title and errors their place.
Imported import_svzerod(const JsonNode& model, const std::filesystem::path& file,
                        const std::optional<std::string>& units = {},
                        const svzerod::Tell& tell = svzerod::nobody);

}  // namespace ostium::app
