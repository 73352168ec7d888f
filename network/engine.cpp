#include "network/engine.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace ostium::network {

std::vector<double> Flows::at(double t) const {
  std::vector<double> q;
  at(t, q);
  return q;
}

void Flows::at(double t, std::vector<double>& q) const {
  q.resize(q0.size());
  const double w = t1 > t0 ? (t - t0) / (t1 - t0) : 1.0;
  for (size_t k = 0; k < q.size(); ++k) q[k] = (1 - w) * q0[k] + w * q1[k];
}

void refuse_endless_switching(const System& system, double t, int k) {
  numerics_error("the network stopped at t = {:.9g} s: {} opens and closes without end", t,
                 system.switch_name(k));
}

std::string worst_equation(const System& system, double t, const Flows& flows, const double* y,
                           const double* dy) {
  std::vector<double> f(system.size());
  system.residual(t, y, dy, flows.at(t), f.data());
  const auto at =
      std::max_element(f.begin(), f.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  return system.names()[at - f.begin()];
}

void guards_to_cross(const System& system, double t, const double* y, const double* dy, double* g) {
  constexpr double little = 1e-13;  // of the scale of what a guard watches: far below the integrator's error
  system.guards(t, y, dy, g);
  for (int k = 0; k < system.switch_count(); ++k) g[k] += system.on(k, y) ? little : -little;
}

}  // namespace ostium::network
