/// The periodic state of a network, found directly instead of by dozens of cycles.
///
///   x(T) = M x(0) + g,   x* = (I - M)^-1 g,   M = dx(T)/dx(0)  (monodromy)
///
///   x  differential unknowns
///   T  period, s
///   M  e^{AT} of a linear network, else from the sensitivities along the period: Newton's shooting (network/shooting)
///
/// With a vessel, all openings are merged into one node for this (an ideal junction: a rigid vessel without
/// losses), so the resistances decide the split of the flow. Source: Guckenheimer & Holmes 1983, sec. 1.5
/// (Poincare maps). Not checked: that the sources have this period.
#pragma once
#include <vector>

#include "network/network.hpp"
#include "network/periodic_report.hpp"

namespace ostium::network {

/// Where a coupled run starts.
struct Start {
  State state;                                // for Network(model, ports)
  std::vector<double> port_flow;              // m3/s at t = 0, positive when leaving the vessel, one per port
  double pressure = 0;                        // Pa, common pressure of the openings at t = 0
  double mean_pressure = 0;                   // Pa, over the period
  double min_pressure = 0, max_pressure = 0;  // Pa
  double max_pressure_rate = 0;               // Pa/s, largest |dP/dt|
  std::vector<double> mean_port_flow;         // m3/s over the period, one per port
  PeriodicReport report{};
};

/// Throws UserError where no periodic state exists (a source of non-zero mean into closed compliances).
Start periodic_start(const Model& model, const std::vector<Port>& ports, double period);

}  // namespace ostium::network
