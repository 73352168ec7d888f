#include "network/periodic.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "network/shooting.hpp"

namespace ostium::network {

namespace {

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
  Start start{};
  start.report = find_periodic(orbit);
  start.mean_port_flow.resize(ports.size(), 0.0);
  orbit.begin();
  for (size_t k = 0; k < ports.size(); ++k) start.port_flow.push_back(orbit.flow(static_cast<int>(k)));
  start.pressure = orbit.pressure();
  start.state = opened(orbit, coupled, start.port_flow);
  if (!ports.empty()) measure(orbit, period, start);
  return start;
}

}  // namespace ostium::network
