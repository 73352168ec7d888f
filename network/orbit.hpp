/// A network closed on itself, its states as a vector over their scales, and the map of one period.
///
///   Phi(x) = x(T) for x(0) = x,     M = dPhi/dx  (monodromy)
///
///   x   the states (differential unknowns without the valves' positions) over their scales
///   T   period, s
///
/// The positions of the valves go on from one period to the next. Not checked: that the sources have this period.
#pragma once
#include <functional>

#include "network/closure.hpp"
#include "network/invariants.hpp"
#include "network/march.hpp"
#include "network/state_space.hpp"
#include "network/tangent_engine.hpp"

namespace ostium::network {

class Orbit {
 public:
  Orbit(const Model& model, const std::vector<Port>& ports, double period,
        const NetworkOptions& options = {});
  /// Blocks with other parameters in the places of others, and back to the start values.
  void replace(std::span<const Replacement> blocks);
  void remember_sources() { closure_.remember_sources(); }

  Eigen::VectorXd states() const;
  void set(const Eigen::VectorXd& x);

  /// Phi(x).
  Eigen::VectorXd after_period(const Eigen::VectorXd& x);
  /// Phi(x), its derivatives with respect to the states and to the parameters (columns, over the scales of the states
  /// and the sizes of the parameters), and what is conserved.
  struct Linearised {
    Eigen::VectorXd end;
    Eigen::MatrixXd M, P;
  };
  Linearised linearised(const Eigen::VectorXd& x, const std::vector<Nearby>& parameters = {});
  Invariants& invariants() { return invariants_; }

  int cycle_integrations() const { return cycles_; }

  /// To t = 0, everything consistent with the states.
  void begin();
  /// Calls visit(i) at t = i period/n for i = 0 .. n-1; ends a period later. Not counted.
  void sample(int n, const std::function<void(int)>& visit);

  const System& system() const { return system_; }
  Consistent& consistent() { return consistent_; }
  double period() const { return period_; }
  const State& state() const { return state_; }
  double flow(int port) const { return closure_.flow(port, state_.time, state_.y.data(), state_.dy.data()); }
  double pressure() const { return closure_.pressure(state_.y.data()); }

 private:
  void restart();
  Eigen::MatrixXd state_rows(const Eigen::MatrixXd& S) const;
  Linearised exactly(const Eigen::VectorXd& x);

  Closure closure_;
  const System& system_ = closure_.system();
  Consistent consistent_{system_};
  NetworkOptions options_;
  std::unique_ptr<Engine> engine_;
  Invariants invariants_{system_};
  StateSpace space_;
  double period_;
  std::vector<double> no_flow_;
  State state_;
  int cycles_ = 0;
};

}  // namespace ostium::network
