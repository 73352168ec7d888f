/// Inertance: the mass of blood in a segment that a pressure difference has to accelerate.
///
///   from o---( L )---o to          L dq/dt = p_from - p_to
///
///   q       m3/s      flow from -> to, a state: starts at initial_flow (series q:NAME_m3_s)
///   L       Pa.s2/m3  inertance, > 0 (rho length / area)
///   ground  Pa        pressure of the end that is no node, where only one of from, to is given
///
/// Example:
///   column: {type: inductor, from: AAo, to: arch, L: 2e5 Pa.s2/m3}
///
/// Source: Formaggia, Quarteroni & Veneziani 2009, ch. 10. Not checked: nodes with inductors only
/// (network/graph does).
#pragma once
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct Inductor : TwoTerminal {
  double L = 0;
  double initial_flow = 0;
  std::optional<double> ground;

  static constexpr const char* type = "inductor";
  static constexpr bool autonomous = true;
  static constexpr Nature nature = Nature::inductive;
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, true}};

  template <class T>
  void equations(const In<Inductor, T>& x, Out<Inductor, T>& f) const {
    const T &q = x.y[0], &dq = x.dy[0];
    f.own[0] = L * dq - (x.p[From] - x.p[To]);
    f.into = {q, -q};
  }
  std::vector<Terminal> terminals() const { return two_ends(*this, ground); }
  void initial(double* y) const { y[0] = initial_flow; }
};

inline void declare(config::Fields<Inductor>& f) {
  declare_ends(f);
  f.quantity("L", &Inductor::L, "Pa.s2/m3", "inertance").positive();
  f.quantity("ground", &Inductor::ground, "Pa", "fixed pressure of the end that is no node");
  f.quantity("initial_flow", &Inductor::initial_flow, "m3/s", "flow at the start").or_else(0.0);
}

}  // namespace ostium::lumped
