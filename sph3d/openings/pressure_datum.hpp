/// The moving pressure datum: the common part of the port pressures that the compressible fluid never sees.
///
///   dP_ref/dt = (sum_k w_k P_k - p_b - P_ref) / tau_D,    p' = p - P_ref
///
///   P_ref   Pa   datum; the solver works with p', every output with p = p' + P_ref
///   P_k     Pa   pressure of port k
///   w_k     -    weights, sum 1, in proportion to 1/|Z_k| (best for several outlets)
///   p_b     Pa   background: what p' is about at rest, large enough that p' stays positive
///   tau_D   s    2 to 5 ms: the storage of the fluid is reduced by omega tau_D
///
/// An incompressible flow in a rigid vessel does not notice a uniform pressure; an artificially compressible
/// one stores V/(rho c^2) of volume per unit of it, which this removes. Source: docs/theory/coupling.md.
/// Not checked: that tau_D is short against the period and long against the acoustic step.
#pragma once
#include <cmath>
#include <span>
#include <vector>

#include "sph3d/openings/port_law.hpp"

namespace ostium::sph3d {

struct PressureDatum {
  double reference = 0;         // P_ref, Pa; with p_b and the weights all there is to save
  double background = 0;        // p_b, Pa
  double tau = 0;               // tau_D, s; 0: a datum that stays where it is
  std::vector<double> weights;  // one per port, 0 for ports of prescribed flow

  double target(std::span<const double> port_pressure) const {
    double sum = -background;
    for (size_t k = 0; k < weights.size(); ++k) sum += weights[k] * port_pressure[k];
    return sum;
  }

  /// Starts where it would stay for these pressures (Pa, physical).
  void start(std::span<const double> port_pressure) { reference = target(port_pressure); }

  /// After the port solve, with the physical port pressures of this step. Exact for pressures held over dt.
  void step(double dt, std::span<const double> port_pressure) {
    if (tau > 0) reference += (target(port_pressure) - reference) * -std::expm1(-dt / tau);
  }

  /// The law as the fluid solver sees it.
  PortLaw relative(PortLaw law) const {
    law.p_star -= reference;
    return law;
  }
};

}  // namespace ostium::sph3d
