/// A network of openBF as a case of ours: each vessel a chain of R-C-L pieces.
///
///   from o---[ vessel LABEL.1 ]---o LABEL.1 ---[ vessel LABEL.2 ]---o .. ---o to      (LABEL alone with one piece)
///
/// The run starts from the steady state at the mean inflow and goes on for ten cycles, as openBF's own models do.
///
/// Linear about the steady state at the mean inflow (openbf_walls). Not carried over: the wall's nonlinearity, convective
/// acceleration, the wall's viscosity; `notes` names what a file has of the latter.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/config/node.hpp"

namespace ostium::app {

struct ImportedOpenbf {
  std::string yaml;  // the case
  std::size_t vessels = 0, blocks = 0;
  double lowest = 0, highest = 0;  // Pa, mean pressures of the steady state
  std::vector<std::string> notes;
};

/// pieces: of each vessel, >= 1. Throws UserError with position.
ImportedOpenbf import_openbf(const std::filesystem::path& file, int pieces);
ImportedOpenbf import_openbf(const config::Node& model, int pieces);

}  // namespace ostium::app
