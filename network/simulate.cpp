#include "network/simulate.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "network/network.hpp"
#include "network/periodic.hpp"

namespace ostium::network {

namespace {

void check(const SimulateOptions& o) {
  if (!(o.end > 0)) user_error("the end time must be > 0 s, found {} s", o.end);
  if (!(o.every > 0)) user_error("the time between two outputs must be > 0 s, found {} s", o.every);
}

/// Each a product, not a sum: the hundred-thousandth time is as exact as the first.
std::vector<double> output_times(const SimulateOptions& o) {
  std::vector<double> times;
  for (long i = 1; i * o.every < o.end * (1 - 1e-9); ++i) times.push_back(i * o.every);
  times.push_back(o.end);
  return times;
}

}  // namespace

void simulate(const Model& model, const SimulateOptions& options, const Sink& sink) {
  check(options);
  Network network(model);
  if (options.initial == Initial::periodic) network.load(periodic_start(model, {}, options.period).state);
  std::vector<double> values(network.series_names().size());
  const auto row = [&](double t) {
    network.series(values);
    return sink.row(t, values);
  };
  sink.begin(network.series_names());
  bool on = row(0.0);
  for (double t : output_times(options)) {
    if (!on) return;
    network.advance(t - network.time(), {}, {});
    on = row(t);
  }
}

}  // namespace ostium::network
