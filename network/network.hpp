/// The circulation beyond the openings: a 0D network that answers port flows with port pressures.
///
///   F(t, y, dy/dt; Q_1(t) .. Q_m(t)) = 0,   y = node pressures, block flows, block states
///
///   Q_k   m3/s     flow through port k, positive when leaving the vessel, i.e. entering the network
///   P_k   Pa       pressure of port k
///   R_kl  Pa.s/m3  dP_k/dQ_l
///
/// Integrated by implicit Runge-Kutta steps with a sparse direct solver and the exact Jacobian of the blocks, small
/// linear networks by the matrix exponential; kinks of the sources are exact stop times.
/// Source: network/engine; port linearisation: docs/theory/coupling.md.
/// Not checked: that the exchanges resolve the port flows, which go linearly from one to the next.
#pragma once
#include <Eigen/Core>
#include <complex>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "network/model.hpp"
#include "network/parameters.hpp"
#include "network/port.hpp"

namespace ostium {
class Archive;
}

namespace ostium::network {

/// State of a network, plain data: a copy is a copy, a restart is exact.
struct State {
  double time = 0;                // s
  std::vector<double> y, dy;      // unknowns and their rates, SI, in the order of the series
  std::vector<double> port_flow;  // last flow of each port, m3/s
  double step = 0;                // s, length of the integrator's next step; 0: of its own choice
};

/// The state as named arrays, see core/archive.
void archive(Archive& a, State& state);

/// `exact`: matrix exponential, for linear networks; `runge_kutta`: implicit steps of order 3 or 4, each factored once,
/// constant matrices once per length of step; `ida`: BDF of variable order; `automatic`: exact where the network is linear
/// and has at most two dozen states, else runge_kutta.
enum class Method { automatic, exact, runge_kutta, ida };

struct NetworkOptions {
  Method method = Method::automatic;
  /// Of each step, with absolute ones of the same fraction of 100 mmHg, 100 mL/s. Exact needs none.
  double relative_tolerance = 1e-8;
  /// Of Runge-Kutta steps, altogether: the one after it is a NumericsError. 0: any number.
  long most_steps = 0;
};

class Network {
 public:
  /// Joins the blocks and checks the graph (UserError). No ports: a standalone study. Starts at rest: see
  /// `load`.
  explicit Network(Model model, std::vector<Port> ports = {}, NetworkOptions options = {});
  Network(Network&&) noexcept;
  Network& operator=(Network&&) noexcept;
  ~Network();

  int port_count() const;
  const Port& port(int k) const;
  PortKind kind(int port) const;
  /// The block that alone stands at the port's node; nothing where there are several.
  std::shared_ptr<const lumped::Block> only_block(int port) const;
  /// "case.yaml:12:5: network.blocks", for messages about the network as a whole.
  const std::string& where() const;

  /// One exchange: from time() to time() + dt while the port flows go linearly from q0 to q1 (m3/s, one per
  /// port; those of flow ports are ignored). Throws NumericsError where the integrator gives up.
  void advance(double dt, std::span<const double> q0, std::span<const double> q1);

  /// Alone, without ports, to `end`; `take` is given the series at `times`, increasing, from behind time() to `end`.
  /// The integrator's steps do not depend on them. Throws NumericsError; the state is then the one before.
  void advance_to(double end, std::span<const double> times,
                  const std::function<void(double time, std::span<const double> values)>& take);

  double time() const;
  /// Pa, at time(), for the last flow. 0 for a flow port, whose pressure is the vessel's affair.
  double pressure(int port) const;
  /// Pa/s, drift of that pressure for held port flows.
  double pressure_slope(int port) const;
  /// m3/s, what a flow port sends into the vessel at time t.
  double flow_into_vessel(int port, double t) const;
  /// s, kinks of the sources in (t0, t1), increasing: good times to end an exchange at.
  std::vector<double> kinks(double t0, double t1) const;

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

  /// Gives a parameter (network/parameters.hpp) another value; what is joined stays joined, and so do the values set
  /// before and the state. Throws UserError: range, what the block refuses, a value that leaves an element out or adds one.
  void set(const Parameter& parameter, double value);
  /// The same for whole blocks with other parameters, all at once.
  void replace(std::span<const Replacement> blocks);
  /// Keeps what sources that are not replaced gave at each time: for many runs over the same times.
  void remember_sources();
  /// The blocks as they are now.
  const Model& model() const;
  /// Back to t = 0 and the start values.
  void restart();

  void series(std::span<double> values) const;

  State save() const;
  void load(const State& state);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
  State state_;
};

}  // namespace ostium::network
