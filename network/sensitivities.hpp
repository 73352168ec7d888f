/// Derivatives of the indices of a run with respect to parameters of its blocks.
///
///   dI/dp along the trajectory, s(0) = dy(0)/dp                           a run from rest
///   (I - M) s(0) = dPhi/dp,  c^T s(0) = d(c^T x_start)/dp - dc/dp^T x(0)   a run from the periodic state
///
/// Indices are taken over the last period of the run, over the whole run where there is no period. From the periodic
/// state the derivatives are those of that state: of what the circulation settles to after the change, at the blood volume
/// that the start values hold. Source: network/tangent, network/shooting. Not checked: that sources keep the period.
#pragma once
#include "network/indices.hpp"
#include "network/parameters.hpp"
#include "network/simulate.hpp"

namespace ostium::network {

struct SensitivityRun {
  double end = 1.0;     // s
  double period = 0.0;  // s, 0: none
  Initial initial = Initial::rest;
};

struct Sensitivities {
  std::vector<double> values;  // one per index, SI
  Eigen::MatrixXd gradients;   // indices x parameters, SI over SI
};

/// Throws UserError: a parameter that leaves an element out or changes the period of a periodic run.
Sensitivities sensitivities(const Model& model, const std::vector<Index>& indices,
                            const std::vector<Parameter>& parameters, const SensitivityRun& run);

}  // namespace ostium::network
