#include "coupling/datum.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ostium::coupling {

using network::PortKind;

std::vector<double> datum_weights(const network::Network& network, double omega1) {
  const int m = network.port_count();
  std::vector<double> size(m, 0.0), weight(m, 0.0);
  for (int k = 0; k < m; ++k)
    if (network.kind(k) == PortKind::pressure) size[k] = std::abs(network.impedance(k, omega1));
  // A port of fixed pressure has no impedance at all; it takes all the weight, shared with its like.
  const double largest = m ? *std::max_element(size.begin(), size.end()) : 0.0;
  const double least = largest > 0 ? 1e-6 * largest : 1.0;
  for (int k = 0; k < m; ++k)
    if (network.kind(k) == PortKind::pressure) weight[k] = 1 / std::max(size[k], least);
  const double sum = std::accumulate(weight.begin(), weight.end(), 0.0);
  if (sum > 0)
    for (double& w : weight) w /= sum;
  return weight;
}

double background_pressure(const Background& b) {
  return b.density * b.max_speed * b.max_speed + b.pressure_drop + b.tau * b.max_pressure_rate;
}

}  // namespace ostium::coupling
