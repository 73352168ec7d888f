#include "network/march.hpp"

#include <cmath>

namespace ostium::network {

namespace {

/// Times at which the integrator must stop: the kinks inside and the end.
std::vector<double> stops(const System& system, double t0, double t1) {
  std::vector<double> times;
  const double least =
      1e-12 * (std::abs(t1) + (t1 - t0));  // closer together they are one time, up to round-off
  for (double t : system.kinks(t0, t1))
    if (t - (times.empty() ? t0 : times.back()) > least && t1 - t > least) times.push_back(t);
  times.push_back(t1);
  return times;
}

}  // namespace

void march(const System& system, Consistent& consistent, Engine& engine, const Flows& flows, State& s) {
  consistent.settle(flows.t0, flows.at(flows.t0), s.y.data(), s.dy.data());
  s.time = flows.t0;
  for (double t : stops(system, flows.t0, flows.t1)) {
    engine.advance(s.time, t, flows, s.y.data(), s.dy.data());
    consistent.settle(t, flows.at(t), s.y.data(), s.dy.data());
    s.time = t;
  }
}

std::unique_ptr<Engine> make_engine(const System& system, Consistent& consistent,
                                    const NetworkOptions& options) {
  constexpr size_t few = 24;  // above it a matrix exponential per exchange costs more than IDA's steps
  const bool wanted = options.method == Method::exact ||
                      (options.method == Method::automatic && system.differential_unknowns().size() <= few);
  if (wanted && system.linear()) return make_exact_engine(system, consistent);
  return make_ida_engine(system, consistent, options.relative_tolerance);
}

}  // namespace ostium::network
