/// How many cycles svZeroDSolver would run.
///
///   without use_cycle_to_cycle_error   number_of_cardiac_cycles
///   with it and an RCR                 ceil(-max(Rd C)/T ln(error)): the slowest outlet has forgotten its start
///   with it and no RCR                 at least number_of_cardiac_cycles, until the means of pressure and flow at the
///                                      ends of the network change by less than the error from cycle to cycle
///
/// Source: Pfaller et al., Int. J. Numer. Meth. Biomed. Engng. 37 (2021) e3513, eq. 21. The last rule looks at nothing
/// else; what is inside the blocks may still be on its way.
#pragma once
#include "app/import/svzerod_circuit.hpp"
#include "network/network.hpp"

namespace ostium::app::svzerod {

/// `network` is the one of `circuit`, at its start; it is run where the last rule applies. Throws UserError where that
/// never ends.
int cycles_of(const Source& source, const Circuit& circuit, network::Network network, const Tell& tell);

}  // namespace ostium::app::svzerod
