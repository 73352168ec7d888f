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

/// The output times one after the other, each a product, not a sum: the hundred-thousandth is as exact as the first.
class OutputTimes {
 public:
  OutputTimes(const SimulateOptions& o, double after)
      : every_(o.every),
        end_(o.end),
        next_(static_cast<long>(std::floor(after / o.every * (1 + 1e-9))) + 1) {}
  double next() {
    const double t = static_cast<double>(next_++) * every_;
    return t < end_ * (1 - 1e-9) ? t : end_;
  }

 private:
  double every_, end_;
  long next_;
};

void advance(Network& network, double t, const Sink& sink) {
  try {
    network.advance(t - network.time(), {}, {});
  } catch (const NumericsError&) {
    if (sink.keep) sink.keep(network.save());
    throw;
  }
}

/// The network at the start, or where it goes on.
Network begin(const Model& model, const SimulateOptions& o) {
  Network network(model);
  if (o.from)
    network.load(*o.from);
  else if (o.initial == Initial::periodic)
    network.load(periodic_start(model, {}, o.period).state);
  return network;
}

}  // namespace

void simulate(const Model& model, const SimulateOptions& options, const Sink& sink) {
  check(options);
  Network network = begin(model, options);
  std::vector<double> values(network.series_names().size());
  const auto row = [&](double t) {
    network.series(values);
    const bool on = sink.row(t, values);
    if (!on && sink.keep) sink.keep(network.save());
    return on;
  };
  sink.begin(network.series_names());
  if (!options.from && !row(0.0)) return;
  OutputTimes times(options, network.time());
  for (double t = network.time(); t < options.end * (1 - 1e-12);) {
    t = times.next();
    advance(network, t, sink);
    if (!row(t)) return;
  }
}

}  // namespace ostium::network
