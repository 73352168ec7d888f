#include "network/march.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::network {

std::vector<double> stops(const System& system, double t0, double t1, std::span<const double> rows) {
  std::vector<double> all = system.kinks(t0, t1), times;
  all.insert(all.end(), rows.begin(), rows.end());
  std::sort(all.begin(), all.end());
  const double least = time_tolerance(t0, t1);  // closer together they are one time, up to round-off
  for (double t : all)
    if (t - (times.empty() ? t0 : times.back()) > least && t1 - t > least) times.push_back(t);
  times.push_back(t1);
  return times;
}

void march(const System& system, Consistent& consistent, Engine& engine, const Flows& flows, State& s,
           Rows* rows) {
  consistent.begin();
  consistent.settle(flows.t0, flows.at(flows.t0), s.y.data(), s.dy.data());
  s.time = flows.t0;
  engine.begin(s.step);
  const bool all_stop = rows && !engine.dense();
  for (double t : stops(system, flows.t0, flows.t1, all_stop ? rows->times : std::span<const double>{})) {
    engine.advance(s.time, t, flows, s.y.data(), s.dy.data(), rows);
    s.time = t;
  }
  consistent.settle(flows.t1, flows.at(flows.t1), s.y.data(), s.dy.data());
  s.step = engine.step();
}

std::unique_ptr<Engine> make_engine(const System& system, Consistent& consistent,
                                    const NetworkOptions& options) {
  constexpr size_t few = 24;  // above it a matrix exponential costs more than steps
  const bool small = system.differential_unknowns().size() <= few;
  const bool exact = options.method == Method::exact || (options.method == Method::automatic && small);
  constexpr double finer = 3e-5;  // than steps need: it costs little, and errors of steps add up
  if (exact && system.linear())
    return make_exact_engine(system, consistent, finer * options.relative_tolerance);
  if (options.method == Method::ida) return make_ida_engine(system, consistent, options.relative_tolerance);
  return make_runge_kutta_engine(system, consistent, options.relative_tolerance, options.most_steps);
}

}  // namespace ostium::network
