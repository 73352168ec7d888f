/// The circulation beyond the openings: a 0D network that answers port flows with port pressures.
///
///   F(t, y, dy/dt; Q_1(t) .. Q_m(t)) = 0,   y = node pressures, block flows, block states
///
///   Q_k   m3/s     flow through port k, positive when leaving the vessel, i.e. entering the network
///   P_k   Pa       pressure of port k
///   R_kl  Pa.s/m3  dP_k/dQ_l
///
/// Integrated by SUNDIALS IDA with a sparse direct solver and the exact Jacobian of the blocks; kinks of the
/// sources are exact stop times. Source: Hindmarsh et al., ACM TOMS 31 (2005) 363; port linearisation:
/// docs/theory, coupling. Not checked: that the caller's time steps resolve its own flow; a network leaves
/// the value at its port flows' linear interpolation.
#pragma once
#include <Eigen/Core>
#include <complex>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "network/model.hpp"

namespace ostium::network {

/// An opening of the vessel; the network's node of the same name is coupled to it.
struct Port {
  std::string opening;
  double area = 0;  // m2
};

/// `flow`: a single flow source stands at the node, the network prescribes the flow. `pressure`: anything
/// else.
enum class PortKind { pressure, flow };

/// State of a network, plain data: a copy is a copy, a restart is exact.
struct State {
  double time = 0;  // s
  std::vector<double> y,
      dy;  // unknowns and their time derivatives, SI, in the order of the network's unknowns
  std::vector<double> port_flow;  // last flow of each port, m3/s
};

class System;
class Integrator;

class Network {
 public:
  /// Joins the blocks and checks the graph (UserError). No ports: a standalone study. Starts at rest: see
  /// `load`.
  explicit Network(Model model, std::vector<Port> ports = {});
  Network(Network&&) noexcept;
  Network& operator=(Network&&) noexcept;
  ~Network();

  int port_count() const;
  const Port& port(int k) const;
  PortKind kind(int port) const;

  /// One exchange: from time() to time() + dt while the port flows go linearly from q0 to q1 (m3/s, one per
  /// port; those of flow ports are ignored). Throws NumericsError where the integrator gives up.
  void advance(double dt, std::span<const double> q0, std::span<const double> q1);

  double time() const;
  /// Pa, at time(), for the last flow. 0 for a flow port, whose pressure is the vessel's affair.
  double pressure(int port) const;
  /// Pa/s, drift of that pressure for held port flows.
  double pressure_slope(int port) const;
  /// m3/s, what a flow port sends into the vessel at time t.
  double flow_into_vessel(int port, double t) const;
  /// s, the next kink of a source after t (infinity if none): a good time to end an exchange at.
  double next_kink(double t) const;

  /// R_kl = dP_k(t + dt)/dQ_l for a flow held over dt, exact for the network linearised about its present
  /// state (RCR: Rp + Rd (1 - exp(-dt/(Rd C)))). Rows and columns of flow ports are zero. Cached per dt for
  /// linear networks.
  Eigen::MatrixXd port_resistance(double dt) const;
  /// The same at dt -> 0: what answers at once (RCR: Rp).
  Eigen::MatrixXd instant_resistance() const;
  /// Pa.s/m3, dP_k/dQ_k of a small oscillation at `omega` (rad/s) about the present state.
  std::complex<double> impedance(int port, double omega) const;
  /// m3/Pa, sum of the compliances of all blocks.
  double total_compliance() const;
  bool linear() const;

  /// Names and present values of every series of network.csv: `p:NODE_Pa`, `q:BLOCK_m3_s`,
  /// `p:BLOCK.STATE_Pa`.
  const std::vector<std::string>& series_names() const;
  void series(std::span<double> values) const;

  State save() const;
  void load(const State& state);

 private:
  std::unique_ptr<System> system_;
  std::unique_ptr<Integrator> integrator_;
  struct Cache;
  std::unique_ptr<Cache> cache_;
};

}  // namespace ostium::network
