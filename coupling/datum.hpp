/// Chooses the moving pressure datum of a coupled run: its weights from the network, its background from the flow.
///
///   w_k = (1/|Z_k(w1)|) / sum_l 1/|Z_l(w1)|         p_b = rho U^2 + dp + tau_D max|dP/dt|
///
///   Z_k   Pa.s/m3  impedance of the network at port k;  w1  rad/s  heart frequency
///   U     m/s      largest mean velocity expected;  dp  Pa  largest pressure difference inside the vessel
///
/// Of all weights these keep several outlets most surely passive (equal ones let some parameter sets grow, all
/// weight on one outlet many). Every port whose pressure answers its flow counts, an inlet driven by a heart included; ports of
/// prescribed flow have weight 0. Weights may be renewed at any time: the datum stays continuous.
/// Source: docs/theory/coupling.md. Not checked: that the vessel is rigid; a compliant wall must be given the datum
/// back as a load.
#pragma once
#include <vector>

#include "network/network.hpp"
#include "sph3d/openings/pressure_datum.hpp"

namespace ostium::coupling {

/// One per port, sum 1 (all 0 where every port has a prescribed flow). omega1 = 0: by the static resistances.
std::vector<double> datum_weights(const network::Network& network, double omega1);

struct Background {
  double density = 1060;         // kg/m3
  double max_speed = 0;          // m/s
  double pressure_drop = 0;      // Pa
  double tau = 0;                // s
  double max_pressure_rate = 0;  // Pa/s
};

double background_pressure(const Background& b);

}  // namespace ostium::coupling
