/// How vessel and network talk: after a window the network is given the mean flow of each port and gives back
/// the law by which that port answers until the next exchange.
///
///   P(t) = p_star + slope (t - t0) + R (Q(t) - q_star)          (sph3d/openings/port_law)
///
///   held            R = 0, slope = 0                    stable only for R_p < Z_c or long windows
///   extrapolated    R = 0, slope from the last two      better phase, smaller range of stability
///   linearised      R = sum_l |dP_k/dQ_l|, slope = drift of the network for held flow; with the implicit port
///                   unconditionally stable: the default
///   modified_euler  R = 0; the equation dP/dt = -P/(C Rd) + (Rp + Rd)/(C Rd) Q + Rp dQ/dt of a single Windkessel
///                   per port by Heun's method on the counted flow; for comparison with published results
///
///   Q   m3/s     flow out of the vessel;  window mean = counted volume / window
///   R   Pa.s/m3  taken over one window (`Network::port_resistance`). Rows are summed because the ports answer one by
///                one: the flow of its neighbours reaches a port a window late, and this keeps that stable.
///
/// Flow ports get an empty law. Source: docs/theory/coupling.md; Zhao, Wu, Kong, Haidn & Hu for the modified
/// Euler scheme.
/// Not checked: stability (coupling/stability does).
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "network/network.hpp"
#include "sph3d/openings/port_law.hpp"

namespace ostium::coupling {

using Laws = std::vector<sph3d::PortLaw>;

enum class SchemeKind { held, extrapolated, linearised, modified_euler };

const char* name(SchemeKind kind);

/// What a scheme remembers, plain data: last pressures (Pa) and mean flows (m3/s), one per port.
struct SchemeState {
  std::vector<double> pressure, flow;
};

class Scheme {
 public:
  virtual ~Scheme() = default;

  /// Laws before the first exchange, from the network's state and last port flows; window: s, as expected.
  Laws start(const network::Network& network, double window);

  /// Advances the network by the window (s) with the mean flows (m3/s) and returns the laws for the next one.
  Laws exchange(network::Network& network, double window, std::span<const double> mean_flow);

  SchemeState save() const { return last_; }
  void load(const SchemeState& state) { last_ = state; }

 protected:
  /// The laws at network.time() after a window with these flows.
  virtual Laws laws(const network::Network& network, double window, std::span<const double> mean_flow) = 0;
  /// The laws at the start; pressures held unless the scheme knows better.
  virtual Laws first(const network::Network& network, double window);

  SchemeState last_;
};

/// Throws UserError where the scheme does not fit the network (modified_euler needs a Windkessel per port).
std::unique_ptr<Scheme> make_scheme(SchemeKind kind, const network::Network& network);

}  // namespace ostium::coupling
