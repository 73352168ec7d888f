/// Heart valve as an orifice that takes its time to open and to close.
///
///   from o---|>|---( L(A) )---[ B(A) |q| ]---o to
///
///   rho l/A dq/dt + rho/(2 A^2) |q| q + R q = p_from - p_to
///   A = A_closed + (A_open - A_closed) z
///   dz/dt = K_open (1 - z) (p_from - p_to)     where p_from > p_to
///   dz/dt = K_close z (p_from - p_to)          where p_from < p_to
///
///   q                  m3/s          flow from -> to, a state: starts at initial_flow (series q:NAME_m3_s)
///   z                  1             how far it is open, a state in [0, 1] (series x:NAME.z)
///   A_open, A_closed   m2            effective area; A_closed > 0 is the leak (regurgitation; small: tight)
///   l                  m             length of the accelerated column
///   rho                kg/m3         density of blood
///   K_open, K_close    1/(Pa.s)      rates of opening and closing
///   R                  Pa.s/m3       viscous resistance, default 0
///
/// The change of sign of the pressure difference is an event of the integrator (series x:NAME.forward).
///
/// Example:
///   aortic: {type: orifice_valve, from: LV, to: AAo, A_open: 4 cm2, A_closed: 1e-4 cm2, l: 1 cm, K_open: 0.2
///       1/Pa/s, K_close: 0.2 1/Pa/s}
///
/// Source: Mynard et al., Int. J. Numer. Meth. Biomed. Engng. 28 (2012) 626, eq. 1-6. Not checked: plausible values.
#pragma once
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct OrificeValve : TwoTerminal {
  double A_open = 0, A_closed = 0, l = 0, rho = 0, K_open = 0, K_close = 0, R = 0;
  double initial_flow = 0, initial_opening = 0;
  std::optional<double> ground;

  static constexpr const char* type = "orifice_valve";
  static constexpr bool linear = false;
  static constexpr Nature nature = Nature::inductive;
  enum Own { q, z, forward };
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, true},
                                       Unknown{"z", Quantity::ratio, true},
                                       Unknown{"forward", Quantity::ratio, true, true}};

  template <class T>
  void equations(const In<OrificeValve, T>& x, Out<OrificeValve, T>& f) const {
    using std::abs;
    const T &flow = x.y[q], drop = x.p[From] - x.p[To];
    const T A = A_closed + (A_open - A_closed) * x.y[z];
    // times A/(rho l): a nearly closed orifice has no large coefficients
    f.own[0] = x.dy[q] + abs(flow) * flow / (2.0 * l * A) - A / (rho * l) * (drop - R * flow);
    f.own[1] = x.dy[z] - (x.y[forward] > 0.5 ? K_open * (1.0 - x.y[z]) : K_close * x.y[z]) * drop;
    f.own[2] = x.dy[forward];
    f.into = {flow, -flow};
  }
  std::array<double, 1> guards(const In<OrificeValve, double>& x) const {
    return {(x.p[From] - x.p[To]) / scale_of(Quantity::pressure)};
  }
  std::vector<Terminal> terminals() const { return two_ends(*this, ground); }
  void initial(double* y) const { y[q] = initial_flow, y[z] = initial_opening, y[forward] = 0; }
};

void declare(config::Fields<OrificeValve>& f);

}  // namespace ostium::lumped
