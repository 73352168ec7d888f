/// `ostium calibrate CASE`: values of parameters with which a network alone meets the targets of its case.
///
///   calibrated.yaml        the case with the values found: run it with `ostium run`
///   summary.json           targets before and after, values with uncertainty, what the targets tell of the parameters
///   network_before.csv     series of both runs, from their starts to the end time
///   network_after.csv
///
/// The method is that of network/calibrate.hpp. Throws UserError before anything is written.
#pragma once
#include "app/case.hpp"
#include "app/results/folder.hpp"

namespace ostium::app {

/// What a calibration of the case would refuse before it begins; nothing where none is asked for.
void check_calibration(const Case& study, const network::Model& model);

void calibrate_case(const Case& study, const ResultsFolder& folder);

}  // namespace ostium::app
