/// Will the exchange between vessel and network be stable? The numbers, printed before a run, and the verdict.
///
///   Z_c   = rho c / A                 Pa.s/m3   acoustic impedance of the vessel behind a port
///   C_f   = V/(rho c^2) + C_wall      m3/Pa     what the compressible fluid and the walls store
///   L     = rho length / A            Pa.s2/m3  inertance of the blood behind a port
///   R     = dP/dQ over one window     Pa.s/m3   answer of the network
///
/// A scheme that holds pressures answers a flow disturbance one window late:
///   window << length/c                          factor -R/Z_c per window            stable for R < Z_c
///   window >> length/c, prescribed inflow       factor -R C_f/window                stable for window > R C_f
///   window >> length/c, pressure upstream       factor 1 - R window/L               stable for window < 2 L/R
/// In between the hold feeds the standing waves of the vessel, and an undamped one grows even for R = Z_c/10. So the
/// verdict asks for margins (half of Z_c, four times the window for `extrapolated`):
///   window < transit/50                          R < Z_c
///   prescribed inflow                            window > 3 transit and window > 5 R C_f, all ports in parallel
///   pressure upstream                            R < min(Z_c, L/window)/2
///   any window                                   R < Z_c/20
/// Those with prescribed inflow are confirmed by an undamped one-dimensional pipe (tests/coupling); slow growth at single
/// resonances, which any damping stops, is not excluded.
/// `linearised` is stable for every R and every window; its filter needs filter_time > window, better
/// >= 5 (window + delay).
///
/// Source: docs/theory/coupling.md. Not checked: the damping of the fluid (it helps), several acoustic paths.
#pragma once
#include <string>
#include <vector>

#include "coupling/scheme.hpp"

namespace ostium::coupling {

struct VesselNumbers {
  double density = 1060;       // kg/m3
  double sound_speed = 0;      // m/s, of the compressible fluid
  double volume = 0;           // m3
  double length = 0;           // m, from the inlet to the farthest opening
  double wall_compliance = 0;  // m3/Pa
};

struct ExchangeNumbers {
  double window = 0;       // s between exchanges
  double filter_time = 0;  // s, of the complementary filter; 0: no filter
  double delay = 0;        // s, from the measuring plane to the opening
};

struct PortNumbers {
  std::string opening;
  double Zc = 0, R_instant = 0, R_window = 0, inertance = 0;
  double Z1 = 0;  // |Z(omega1)|, Pa.s/m3
};

struct StabilityNumbers {
  std::vector<PortNumbers> ports;                       // pressure ports only
  double fluid_compliance = 0, network_compliance = 0;  // m3/Pa
  double transit = 0;                                   // s, length / c
  double R_parallel = 0;                                // Pa.s/m3 over one window
  bool prescribed_inflow = false;
  ExchangeNumbers exchange;

  /// A few lines for the start of a run.
  std::string text() const;
};

/// omega1: heart frequency, rad/s.
StabilityNumbers stability_numbers(const network::Network& network, const VesselNumbers& vessel,
                                   const ExchangeNumbers& exchange, double omega1);

/// Throws UserError for a choice outside the margins, with the remedy. Forced: returns the sentence as a warning
/// instead. Returns every warning, none where all is well.
std::vector<std::string> check_stability(const StabilityNumbers& numbers, SchemeKind scheme, bool force);

}  // namespace ostium::coupling
