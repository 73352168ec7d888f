/// Linear compliance: the volume an elastic vessel stores.
///
///   from o---| C |---o to          0 = p_from - p_to - u,   C du/dt = q
///
///   u       Pa      pressure across it (series p:NAME.u_Pa), a state: starts at initial_pressure
///   q       m3/s    flow into it at `from` (series q:NAME_m3_s)
///   C       m3/Pa   compliance, > 0
///   ground  Pa      pressure of the end that is no node (default 0: the surroundings)
///
/// Example:
///   aorta: {type: capacitor, from: AAo, C: 1e-8 m3/Pa, initial_pressure: 80 mmHg}
///
/// Source: Formaggia, Quarteroni & Veneziani 2009, ch. 10. Not checked: loops of capacitors (network/graph
/// does).
#pragma once
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct Capacitor : TwoTerminal {
  double C = 0;
  double initial_pressure = 0;
  std::optional<double> ground;

  static constexpr const char* type = "capacitor";
  static constexpr bool autonomous = true;
  static constexpr Nature nature = Nature::capacitive;
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false},
                                       Unknown{"u", Quantity::pressure, true}};

  template <class T>
  void equations(const In<Capacitor, T>& x, Out<Capacitor, T>& f) const {
    const T &q = x.y[0], &u = x.y[1], &du = x.dy[1];
    f.own[0] = x.p[From] - x.p[To] - u;
    f.own[1] = C * du - q;
    f.into = {q, -q};
  }
  std::vector<Terminal> terminals() const { return grounded_ends(*this, ground); }
  void initial(double* y) const { y[1] = initial_pressure; }
  double compliance() const { return C; }
};

inline void declare(config::Fields<Capacitor>& f) {
  declare_ends(f);
  f.quantity("C", &Capacitor::C, "m3/Pa", "compliance").positive();
  f.quantity("ground", &Capacitor::ground, "Pa", "pressure of the end that is no node; 0 if not given");
  f.quantity("initial_pressure", &Capacitor::initial_pressure, "Pa", "pressure across it at the start")
      .or_else(0.0);
}

}  // namespace ostium::lumped
