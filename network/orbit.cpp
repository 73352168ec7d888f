#include "network/orbit.hpp"

namespace ostium::network {

namespace {

/// Shows the invariants the equations at some points of each piece between two stops.
class Witness final : public Watcher {
 public:
  Witness(const System& system, Invariants& invariants) : system_(system), invariants_(invariants) {}
  void step(Interpolant& trajectory, double, double b, bool fresh,
            const std::optional<Eigen::RowVectorXd>&) override {
    if (!fresh && ++steps_ % 16 != 0) return;
    const Eigen::VectorXd y = trajectory.y(b, 0), dy = trajectory.y(b, 1);
    invariants_.see(b, y.data(), dy.data());
  }

 private:
  const System& system_;
  Invariants& invariants_;
  long steps_ = 0;
};

}  // namespace

Orbit::Orbit(const Model& model, const std::vector<Port>& ports, double period, const NetworkOptions& options)
    : closure_(model, ports),
      options_(options),
      period_(period),
      no_flow_(closure_.system().ports().size(), 0.0) {
  restart();
}

void Orbit::replace(std::span<const Replacement> blocks) {
  for (const auto& r : blocks) closure_.replace(r);
  consistent_.forget();
  invariants_.forget();
  cycles_ = 0;
  restart();
}

void Orbit::restart() {
  const auto y = system_.start();
  state_ = {0, {y.begin(), y.end()}, std::vector<double>(y.size(), 0.0), no_flow_};
  space_ = linearise(system_, 0, state_.y.data(), state_.dy.data());
  engine_ = make_engine(system_, consistent_, options_);
}

Eigen::VectorXd Orbit::states() const {
  const auto& index = system_.states();
  Eigen::VectorXd x(index.size());
  for (size_t i = 0; i < index.size(); ++i) x[i] = state_.y[index[i]] / system_.scale()[index[i]];
  return x;
}

void Orbit::set(const Eigen::VectorXd& x) {
  const auto& index = system_.states();
  for (size_t i = 0; i < index.size(); ++i) state_.y[index[i]] = x[i] * system_.scale()[index[i]];
}

Eigen::VectorXd Orbit::after_period(const Eigen::VectorXd& x) {
  set(x);
  ++cycles_;
  march(system_, consistent_, *engine_, {0, period_, no_flow_, no_flow_}, state_);
  return states();
}

Eigen::MatrixXd Orbit::state_rows(const Eigen::MatrixXd& S) const {
  const auto& index = system_.states();
  Eigen::MatrixXd rows(index.size(), S.cols());
  for (size_t i = 0; i < index.size(); ++i) rows.row(i) = S.row(index[i]) / system_.scale()[index[i]];
  return rows;
}

/// A linear network without parameters: e^{AT}.
Orbit::Linearised Orbit::exactly(const Eigen::VectorXd& x) {
  Linearised l{after_period(x), transition(space_, period_), {}};
  invariants_.see(0, state_.y.data(), state_.dy.data());
  return l;
}

Orbit::Linearised Orbit::linearised(const Eigen::VectorXd& x, const std::vector<Nearby>& parameters) {
  if (system_.linear() && parameters.empty()) return exactly(x);
  const auto& index = system_.states();
  const int n = static_cast<int>(index.size());
  Tangent tangent(system_, n, parameters);
  TangentEngine engine(system_, consistent_, tangent);
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(system_.size(), tangent.count());
  for (int i = 0; i < n; ++i) S(index[i], i) = system_.scale()[index[i]];
  set(x);
  state_.time = 0;
  ++cycles_;
  Witness witness(system_, invariants_);
  engine.march(period_, state_, S, &witness);
  const Eigen::MatrixXd rows = state_rows(S);
  return {states(), rows.leftCols(n), rows.rightCols(parameters.size())};
}

void Orbit::begin() {
  consistent_.settle(0, no_flow_, state_.y.data(), state_.dy.data());
  state_.time = 0;
}

void Orbit::sample(int n, const std::function<void(int)>& visit) {
  begin();
  for (int i = 0; i < n; ++i) {
    visit(i);
    march(system_, consistent_, *engine_, {period_ * i / n, period_ * (i + 1) / n, no_flow_, no_flow_},
          state_);
  }
}

}  // namespace ostium::network
