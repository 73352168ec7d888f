/// Heart valve as a switch: open it is a resistance and an inertance, closed it is tight or leaks.
///
///   from o---|>|---[ R ]---( L )---o to
///
///   open     L dq/dt + R q = p_from - p_to          until q falls through 0
///   closed   q = 0                                  until p_from rises above p_to
///            or with R_closed:  L dq/dt + R_closed q = p_from - p_to, until q rises through 0
///
///   q          m3/s       flow from -> to (series q:NAME_m3_s), a state if L > 0: starts at initial_flow
///   open       1          1 open, 0 closed (series x:NAME.open)
///   R          Pa.s/m3    resistance when open, >= 0, > 0 without L
///   L          Pa.s2/m3   inertance, >= 0
///   R_closed   Pa.s/m3    resistance when closed, > R; without it the valve is tight
///
/// The integrator finds the times of opening and closing; nothing is smoothed and there is no steepness to choose.
///
/// Example:
///   aortic: {type: valve, from: LV, to: AAo, R: 4.6e6 Pa.s/m3, L: 1.5e4 Pa.s2/m3}
///
/// Source: Sankaran et al., Ann. Biomed. Eng. 40 (2012) 2228. Not checked: plausible values.
#pragma once
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct Valve : TwoTerminal {
  double R = 0, L = 0, initial_flow = 0;
  std::optional<double> R_closed, ground;

  static constexpr const char* type = "valve";
  static constexpr bool autonomous = true;
  static constexpr bool linear = false;
  enum Own { q, open };
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false},
                                       Unknown{"open", Quantity::ratio, true, true}};

  template <class T>
  void equations(const In<Valve, T>& x, Out<Valve, T>& f) const {
    const T &flow = x.y[q], drop = x.p[From] - x.p[To];
    const bool is_open = x.y[open] > 0.5;
    if (is_open || R_closed)
      f.own[0] = L * x.dy[q] + (is_open ? R : *R_closed) * flow - drop;
    else
      f.own[0] = L > 0 ? L * x.dy[q] : flow;
    f.own[1] = x.dy[open];
    f.into = {flow, -flow};
  }
  std::array<double, 1> guards(const In<Valve, double>& x) const {
    const bool by_flow = x.y[open] > 0.5 || (R_closed && L > 0);
    if (by_flow) return {x.y[q] / scale_of(Quantity::flow)};
    return {(x.p[From] - x.p[To]) / scale_of(Quantity::pressure)};
  }
  void reset(int, double* y) const {
    if (y[open] < 0.5 && !R_closed) y[q] = 0;
  }
  std::array<Unknown, 2> present_unknowns() const {
    auto all = unknowns;
    all[q].differential = L > 0;
    return all;
  }
  std::vector<Terminal> terminals() const { return two_ends(*this, ground); }
  std::vector<Branch> branches() const { return {{From, To, L > 0 ? Nature::inductive : Nature::resistive}}; }
  void initial(double* y) const { y[q] = initial_flow, y[open] = initial_flow > 0 ? 1 : 0; }
};

void declare(config::Fields<Valve>& f);

}  // namespace ostium::lumped
