/// svZeroDSolver's calibration task: vessels and junctions fitted to pressures and flows given at every connection.
///
///   y, dy                    {"flow:UP:DOWN": [..], "pressure:UP:DOWN": [..]}: values and rates, one per observation
///   calibration_parameters   calibrate_stenosis_coefficient (true), set_capacitance_to_zero (false); what steers that
///                            program's iteration (tolerances, damping) is of no use here
///   fitted                   R, C, L, S of every BloodVessel and BloodVesselCRL; R, L, S of each outlet of every junction
///                            with one inlet and several outlets, which becomes a BloodVesselJunction
///
/// No simulation is run: each block is a least squares problem of its own (network/vessel_fit.hpp), its equations counted in
/// the units of the file as that program counts them. Boundary conditions,
/// valves and other blocks stay as they are. Not checked: that dy are the rates of y.
#pragma once
#include <nlohmann/json.hpp>

#include "app/import/json_node.hpp"
#include "network/vessel_fit.hpp"

namespace ostium::app {

struct SvzerodFitted {
  std::string name;  // of a vessel, or JUNCTION:OUTLET
  network::VesselFit fit;
};

struct SvzerodCalibration {
  JsonNode::Json model;  // the same file with the fitted values, without the observations
  std::vector<SvzerodFitted> fitted;
  std::size_t observations = 0;
  std::vector<std::string> notes;  // what is not fitted, and why
};

/// True where the file holds observations.
bool has_observations(const JsonNode& root);

/// Throws UserError with file and JSON path.
SvzerodCalibration calibrate_svzerod(const JsonNode& root);

}  // namespace ostium::app
