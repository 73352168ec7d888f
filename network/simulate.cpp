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

/// Output times, each a product, not a sum: the hundred-thousandth is as exact as the first.
class OutputTimes {
 public:
  OutputTimes(const SimulateOptions& o, double after)
      : every_(o.every),
        end_(o.end),
        next_(static_cast<long>(std::floor(after / o.every * (1 + 1e-9))) + 1) {}
  /// The next ones, up to the end of a stretch whose length does not depend on where the run began.
  std::vector<double> stretch() {
    constexpr long rows = 512;
    std::vector<double> times;
    do {
      const double t = static_cast<double>(next_++) * every_;
      times.push_back(t < end_ * (1 - 1e-9) ? t : end_);
    } while (times.back() < end_ && (next_ - 1) % rows != 0);
    return times;
  }

 private:
  double every_, end_;
  long next_;
};

/// The network at the start, or where it goes on.
Network begin(const Model& model, const SimulateOptions& o, const Sink& sink) {
  constexpr double keeps_periodic =
      1e-6;  // steps less fine would move a periodic state by more than it is known to
  const double finest = o.initial == Initial::periodic ? keeps_periodic : o.relative_tolerance;
  Network network(model, {}, {.relative_tolerance = std::min(o.relative_tolerance, finest)});
  if (o.from) {
    network.load(*o.from);
  } else if (o.initial == Initial::periodic) {
    const Start start = periodic_start(model, {}, o.period);
    network.load(start.state);
    if (sink.periodic) sink.periodic(start.report);
  }
  return network;
}

/// Hands out rows until the sink wants no more; from then on, and up to what it has already, nothing.
class Handing {
 public:
  Handing(const SimulateOptions& o, const Sink& sink)
      : after_(o.from ? std::max(o.handed_out, o.from->time) * (1 + 1e-12) : -1), sink_(sink) {}
  void operator()(double t, std::span<const double> values) {
    if (t > after_) on_ = on_ && sink_.row(t, values);
  }
  bool on() const { return on_; }

 private:
  double after_;
  const Sink& sink_;
  bool on_ = true;
};

}  // namespace

void simulate(const Model& model, const SimulateOptions& options, const Sink& sink) {
  check(options);
  Network network = begin(model, options, sink);
  Handing row(options, sink);
  sink.begin(network.series_names());
  std::vector<double> values(network.series_names().size());
  network.series(values);
  row(network.time(), values);
  if (!row.on() && sink.keep) sink.keep(network.save());
  OutputTimes times(options, network.time());
  while (row.on() && network.time() < options.end * (1 - 1e-12)) {
    const auto stretch = times.stretch();
    const State before = network.save();
    const auto keep = [&] {
      if (sink.keep) sink.keep(before);
    };
    try {
      network.advance_to(stretch.back(), stretch, std::ref(row));
    } catch (const NumericsError&) {
      keep();
      throw;
    }
    if (!row.on()) keep();
  }
}

}  // namespace ostium::network
