/// Carries the state of a network across an interval, stopping at the kinks of its sources.
#pragma once
#include "network/engine.hpp"
#include "network/network.hpp"

namespace ostium::network {

/// From state.time = flows.t0 to flows.t1; the state is consistent at the end, whatever it was. What is handed out at
/// `rows` is consistent too.
/// Throws NumericsError where the integrator gives up; the state is then worthless.
void march(const System& system, Consistent& consistent, Engine& engine, const Flows& flows, State& state,
           Rows* rows = nullptr);

/// Times after t0 at which an integrator must stop: the kinks in between, rows that it cannot interpolate, and t1.
std::vector<double> stops(const System& system, double t0, double t1, std::span<const double> rows = {});

/// The engine the options ask for.
std::unique_ptr<Engine> make_engine(const System& system, Consistent& consistent,
                                    const NetworkOptions& options);

}  // namespace ostium::network
