/// The scales of a coupled run, from the case and its network: how fast the blood may get, and what follows from that.
///
///   U     m/s   largest velocity expected: peak mean velocity at an opening times its profile's peak (parabola 2, 2D 3/2;
///               outlets likewise), the outlets' flows split as in the periodic state, else by area
///   c     m/s   sound speed, 10 U unless the case says otherwise: density varies by about 1 %; 3 c_MK at least where the wall
///               moves (app/wall_setup)
///   dp_in Pa    largest pressure difference inside: rho U^2 / 2 + rho (length) max dU/dt, the rise at the start included
///   tau_D s     of the pressure datum: an eighth of length / c, kept within 2 and 5 ms, unless the case says otherwise
///   p_b   Pa    background: dp_in + tau_D max |dP/dt|, at most dp_in + the swing of P; the swing where tau_D = 0
///
/// Source: docs/theory/coupling.md, "Scales". Not checked: a narrowing inside the vessel; the run warns when the velocity
/// outgrows c / 10 by half.
#pragma once
#include <optional>

#include "app/vessel_setup.hpp"
#include "app/wall_setup.hpp"
#include "network/periodic.hpp"

namespace ostium::app {

struct FlowScales {
  double speed = 0, sound_speed = 0, inner_pressure = 0, datum_time = 0, background = 0, length = 0;
  WallScales wall = {};
};

/// s, over which prescribed flows and the load on a moving wall rise at the start.
double start_ramp(const FlowScales& scales);

template <int D>
FlowScales flow_scales(const Case& study, const Setup<D>& setup, const std::optional<network::Start>& start);

}  // namespace ostium::app
