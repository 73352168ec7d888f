#include "network/periodic.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "network/closure.hpp"
#include "network/march.hpp"
#include "network/state_space.hpp"

namespace ostium::network {

namespace {

/// The network that closes on itself, its states as a vector over their scales, and the map of one period.
class Orbit {
 public:
  Orbit(const Model& model, const std::vector<Port>& ports, double period)
      : closure_(model, ports), period_(period), no_flow_(closure_.system().ports().size(), 0.0) {
    const auto y = system_.start();
    state_ = {0, {y.begin(), y.end()}, std::vector<double>(y.size(), 0.0), no_flow_};
    space_ = linearise(system_, 0, state_.y.data(), state_.dy.data());
    engine_ = make_engine(system_, consistent_, {});
  }

  void find() {
    constexpr int most = 20;
    for (int i = 0; i < most; ++i) {
      const Eigen::VectorXd x = states();
      const Eigen::VectorXd miss = after_period(x) - x;
      if (!miss.allFinite()) break;
      if (miss.size() == 0) return;
      set(x + correction(x, miss));
      if (miss.lpNorm<Eigen::Infinity>() < 1e-7) return;  // that correction was the polish
    }
    numerics_error(
        "no periodic state of period {} s was found after {} periods; check that every source has this "
        "period, or "
        "start from rest",
        period_, most);
  }

  /// Calls visit(i) at t = i period/n for i = 0 .. n-1; ends a period later.
  template <class F>
  void sample(int n, F visit) {
    consistent_.settle(0, no_flow_, state_.y.data(), state_.dy.data());
    state_.time = 0;
    for (int i = 0; i < n; ++i) {
      visit(i);
      march(system_, consistent_, *engine_, {period_ * i / n, period_ * (i + 1) / n, no_flow_, no_flow_},
            state_);
    }
  }

  const System& system() const { return system_; }
  const State& state() const { return state_; }
  double flow(int port) const { return closure_.flow(port, state_.time, state_.y.data(), state_.dy.data()); }
  double pressure() const { return closure_.pressure(state_.y.data()); }

 private:
  Eigen::VectorXd states() const {
    const auto& index = system_.states();
    Eigen::VectorXd x(index.size());
    for (size_t i = 0; i < index.size(); ++i) x[i] = state_.y[index[i]] / system_.scale()[index[i]];
    return x;
  }

  void set(const Eigen::VectorXd& x) {
    const auto& index = system_.states();
    for (size_t i = 0; i < index.size(); ++i) state_.y[index[i]] = x[i] * system_.scale()[index[i]];
  }

  Eigen::VectorXd after_period(const Eigen::VectorXd& x) {
    set(x);
    march(system_, consistent_, *engine_, {0, period_, no_flow_, no_flow_}, state_);
    return states();
  }

  Eigen::VectorXd correction(const Eigen::VectorXd& x, const Eigen::VectorXd& miss) {
    const auto n = x.size();
    Eigen::FullPivLU<Eigen::MatrixXd> lu(Eigen::MatrixXd::Identity(n, n) - monodromy(x, miss));
    lu.setThreshold(1e-12);
    if (!lu.isInvertible()) refuse(lu.kernel().col(0));
    return lu.solve(miss);
  }

  Eigen::MatrixXd monodromy(const Eigen::VectorXd& x, const Eigen::VectorXd& miss) {
    if (system_.linear()) return transition(space_, period_);
    constexpr double step =
        1e-4;  // of the scales: far above the integrator's tolerance, far below nonlinearity
    Eigen::MatrixXd m(x.size(), x.size());
    for (int j = 0; j < x.size(); ++j)
      m.col(j) = (after_period(x + step * Eigen::VectorXd::Unit(x.size(), j)) - x - miss) / step;
    return m;
  }

  [[noreturn]] void refuse(const Eigen::VectorXd& mode) const {
    int at = 0;
    mode.cwiseAbs().maxCoeff(&at);
    user_error(
        "{}: the network has no periodic state of its own: nothing brings {} back to one value; give it a "
        "way out, for "
        "example a resistor to a ground, or start from rest",
        system_.model().where, system_.names()[system_.states()[at]]);
  }

  Closure closure_;
  const System& system_ = closure_.system();
  Consistent consistent_{system_};
  std::unique_ptr<Engine> engine_;
  StateSpace space_;
  double period_;
  std::vector<double> no_flow_;
  State state_;
};

void measure(Orbit& orbit, double period, Start& start) {
  constexpr int n = 1000;
  const int m = static_cast<int>(start.port_flow.size());
  std::vector<double> pressure;
  orbit.sample(n, [&](int) {
    pressure.push_back(orbit.pressure());
    for (int k = 0; k < m; ++k) start.mean_port_flow[k] += orbit.flow(k) / n;
  });
  start.mean_pressure = std::accumulate(pressure.begin(), pressure.end(), 0.0) / n;
  const auto [low, high] = std::minmax_element(pressure.begin(), pressure.end());
  start.min_pressure = *low, start.max_pressure = *high;
  for (int i = 0; i < n; ++i)
    start.max_pressure_rate =
        std::max(start.max_pressure_rate, std::abs(pressure[(i + 1) % n] - pressure[i]) * n / period);
}

/// The states of the closed network, by name, in the network with ports; the rest follows from them.
State opened(const Orbit& orbit, const System& coupled, const std::vector<double>& port_flow) {
  State s{0, std::vector<double>(coupled.size(), 0.0), std::vector<double>(coupled.size(), 0.0), port_flow};
  const auto& names = orbit.system().names();
  for (int i : coupled.differential_unknowns()) {
    const auto at = std::find(names.begin(), names.end(), coupled.names()[i]);
    OSTIUM_ASSERT(at != names.end(), "no {} in the closed network", coupled.names()[i]);
    s.y[i] = orbit.state().y[at - names.begin()];
  }
  Consistent(coupled).settle(0, port_flow, s.y.data(), s.dy.data());
  return s;
}

}  // namespace

Start periodic_start(const Model& model, const std::vector<Port>& ports, double period) {
  if (!(period > 0)) user_error("{}: a periodic start needs a period > 0 s, found {} s", model.where, period);
  const System coupled(model, ports);
  Orbit orbit(coupled.model(), ports, period);
  orbit.find();
  Start start{};
  start.mean_port_flow.resize(ports.size(), 0.0);
  orbit.sample(1, [&](int) {
    for (size_t k = 0; k < ports.size(); ++k) start.port_flow.push_back(orbit.flow(static_cast<int>(k)));
    start.pressure = orbit.pressure();
    start.state = opened(orbit, coupled, start.port_flow);
  });
  measure(orbit, period, start);
  return start;
}

}  // namespace ostium::network
