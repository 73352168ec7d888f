/// The steady stage: from where svZeroDSolver starts a run with `steady_initial`.
///
/// All sources at their means, no compliance in the outlets, 3.1 periods from the start that the file gives; vessels,
/// inertances and chambers go on as they are, so it is not a steady state where they are slow or beat.
/// Models that swing so fast that a million steps do not suffice are refused: a fraction of a second is a million of their
/// swings, and the run would be many times longer.
#pragma once
#include "app/import/svzerod_circuit.hpp"
#include "network/network.hpp"

namespace ostium::app::svzerod {

/// The blocks joined to a network of at most so many steps; throws UserError where it cannot be solved, `what` names it.
network::Network joined(const Circuit& circuit, const std::string& file, const std::string& what,
                        long most_steps);

/// The last values of every series; throws UserError where the network cannot be solved.
Values run_steady_stage(const Source& source, const UnitSystem& units, const std::string& file,
                        const Tell& tell);

}  // namespace ostium::app::svzerod
