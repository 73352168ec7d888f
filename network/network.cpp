#include "network/network.hpp"

#include <algorithm>
#include <optional>

#include "core/archive.hpp"
#include "core/error.hpp"
#include "network/march.hpp"
#include "network/state_space.hpp"
#include "network/system.hpp"

namespace ostium::network {

/// Equations, their consistent solver and the integrator, in the order in which they need each other.
struct Network::Parts {
  System system;
  Consistent consistent{system};
  std::unique_ptr<Engine> engine;
  std::optional<StateSpace> linear;                        // the last one asked for
  std::optional<std::pair<double, Eigen::MatrixXd>> held;  // last dt and its response
  NetworkOptions options;
  std::optional<Changes> changes;

  Parts(Model model, std::vector<Port> ports, const NetworkOptions& how)
      : system(std::move(model), std::move(ports)), options(how) {
    prepare();
  }
  void set(const Parameter& parameter, double value) {
    if (!changes) changes.emplace(system.model());
    system.replace(parameter.entry, changes->block(parameter, value));
    changes->keep(parameter, value);
    renew();
  }
  void replace(std::span<const Replacement> blocks) {
    for (const auto& r : blocks) system.replace(r.entry, r.block);
    changes.reset();  // they are part of the model now
    renew();
  }
  void renew() {
    consistent.forget();
    linear.reset(), held.reset();
    prepare();
  }
  void prepare() {
    check_index(system);
    engine = make_engine(system, consistent, options);
  }
  const StateSpace& state_space(const State& s) {
    if (!linear || !system.linear()) linear = linearise(system, s.time, s.y.data(), s.dy.data());
    return *linear;
  }
};

Network::Network(Model model, std::vector<Port> ports, NetworkOptions options)
    : parts_(std::make_unique<Parts>(std::move(model), std::move(ports), options)) {
  restart();
}

void Network::set(const Parameter& parameter, double value) { parts_->set(parameter, value); }
void Network::replace(std::span<const Replacement> blocks) { parts_->replace(blocks); }
void Network::remember_sources() { parts_->system.remember_sources(); }
const Model& Network::model() const { return parts_->system.model(); }

void Network::restart() {
  const auto start = parts_->system.start();
  State s{.time = 0,
          .y = {start.begin(), start.end()},
          .dy = std::vector<double>(start.size(), 0.0),
          .port_flow = {}};
  s.port_flow.resize(port_count());
  parts_->consistent.begin();
  parts_->consistent.settle(s.time, s.port_flow, s.y.data(), s.dy.data());
  state_ = std::move(s);
}

Network::Network(Network&&) noexcept = default;
Network& Network::operator=(Network&&) noexcept = default;
Network::~Network() = default;

int Network::port_count() const { return static_cast<int>(parts_->system.ports().size()); }
const Port& Network::port(int k) const { return parts_->system.ports()[k]; }
PortKind Network::kind(int port) const { return parts_->system.graph().port_kind[port]; }
const std::string& Network::where() const { return parts_->system.model().where; }

std::shared_ptr<const lumped::Block> Network::only_block(int port) const {
  std::shared_ptr<const lumped::Block> found;
  const auto& at = parts_->system.graph().port_of;
  for (size_t i = 0; i < at.size(); ++i) {
    if (std::count(at[i].begin(), at[i].end(), port) == 0) continue;
    if (found) return nullptr;
    found = parts_->system.model().entries[i].block;
  }
  return found;
}

double Network::time() const { return state_.time; }
bool Network::linear() const { return parts_->system.linear(); }
double Network::total_compliance() const { return parts_->system.compliance(); }
std::vector<double> Network::kinks(double t0, double t1) const { return parts_->system.kinks(t0, t1); }

void Network::advance(double dt, std::span<const double> q0, std::span<const double> q1) {
  OSTIUM_ASSERT(dt > 0, "exchange of {} s", dt);
  OSTIUM_ASSERT(static_cast<int>(q0.size()) == port_count() && q1.size() == q0.size(),
                "{} and {} flows for {} ports", q0.size(), q1.size(), port_count());
  State s = state_;  // kept as it was where the integrator gives up
  march(parts_->system, parts_->consistent, *parts_->engine, {s.time, s.time + dt, q0, q1}, s);
  s.port_flow.assign(q1.begin(), q1.end());
  state_ = std::move(s);
}

void Network::advance_to(double end, std::span<const double> times,
                         const std::function<void(double, std::span<const double>)>& take) {
  OSTIUM_ASSERT(port_count() == 0, "{} ports without flows", port_count());
  State s = state_;
  const auto n = s.y.size();
  Rows rows{times, [&](double t, const double* y) { take(t, {y, n}); }};
  march(parts_->system, parts_->consistent, *parts_->engine, {s.time, end, {}, {}}, s, &rows);
  state_ = std::move(s);
}

double Network::pressure(int port) const {
  const int node = parts_->system.graph().port_node[port];
  return node == outside ? 0.0 : state_.y[node];
}

double Network::pressure_slope(int port) const {
  const int node = parts_->system.graph().port_node[port];
  if (node == outside) return 0.0;
  return parts_->consistent.rates(state_.time, state_.port_flow, state_.y.data(), state_.dy.data())[node];
}

double Network::flow_into_vessel(int port, double t) const {
  const auto& g = parts_->system.graph();
  const int source = g.port_source[port];
  if (source == outside) return 0.0;
  const auto& block = *parts_->system.model().entries[source].block;
  const double sign =
      block.terminals()[1].node == g.port_name[port] ? 1.0 : -1.0;  // `to` the opening: into the vessel
  return sign * block.prescribed_flow(t);
}

Eigen::MatrixXd Network::port_resistance(double dt) const {
  if (!linear()) return held_flow_response(parts_->state_space(state_), dt);
  auto& held = parts_->held;
  if (!held || held->first != dt) held = {dt, held_flow_response(parts_->state_space(state_), dt)};
  return held->second;
}

Eigen::MatrixXd Network::instant_resistance() const { return parts_->state_space(state_).D; }

std::complex<double> Network::impedance(int port, double omega) const {
  return frequency_response(parts_->state_space(state_), omega)(port, port);
}

const std::vector<std::string>& Network::series_names() const { return parts_->system.names(); }

void Network::series(std::span<double> values) const {
  OSTIUM_ASSERT(values.size() == state_.y.size(), "{} values for {} series", values.size(), state_.y.size());
  std::copy(state_.y.begin(), state_.y.end(), values.begin());
}

void archive(Archive& a, State& state) {
  a("time", state.time);
  a("y", state.y);
  a("dy", state.dy);
  a("port_flow", state.port_flow);
  a("step", state.step);
}

State Network::save() const { return state_; }

void Network::load(const State& state) {
  const int n = parts_->system.size();
  if (static_cast<int>(state.y.size()) != n || static_cast<int>(state.dy.size()) != n ||
      static_cast<int>(state.port_flow.size()) != port_count())
    user_error(
        "the saved state has {} unknowns and {} ports, this network {} and {}: it belongs to another case",
        state.y.size(), state.port_flow.size(), n, port_count());
  state_ = state;  // as it is, so that a restart has the same bits
}

}  // namespace ostium::network
