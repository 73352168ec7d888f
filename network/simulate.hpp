/// Runs a network alone and hands out its series at the wanted times.
///
///   t = 0, every, 2 every, .. end     s;  values in the order of Network::series_names, SI
///
/// Not checked: that `every` resolves the signal; the integrator's own steps do not depend on it.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "network/model.hpp"
#include "network/network.hpp"
#include "network/periodic_report.hpp"

namespace ostium::network {

enum class Initial { rest, periodic };

struct SimulateOptions {
  double end = 1.0;     // s
  double every = 0.01;  // s between outputs; the end is always among them
  Initial initial = Initial::rest;
  double period = 0.0;             // s, needed for Initial::periodic
  std::optional<State> from = {};  // goes on from this state, whose row is not handed out again ..
  double handed_out = 0;           // s, .. nor those up to this time
  /// Of each step, see NetworkOptions: series are then right to some tenths of a per mille.
  double relative_tolerance = 3e-6;
};

/// `begin(names)` once, then `row(t, values)` at t = 0, every, 2 every, .. end, then nothing. row returns
/// false to stop early. `keep` is given a state from which a run that ends before its time, stopped by row or failing,
/// goes on with the same bits: it lies a few dozen rows back.
struct Sink {
  std::function<void(const std::vector<std::string>& names)> begin;
  std::function<bool(double time, std::span<const double> values)> row;
  std::function<void(const State&)> keep = {};
  std::function<void(const PeriodicReport&)> periodic = {};  // before `begin`, where the start is periodic
};

/// Throws UserError on a bad network, NumericsError where the integrator gives up.
void simulate(const Model& model, const SimulateOptions& options, const Sink& sink);

}  // namespace ostium::network
