/// Linear resistance: Poiseuille losses of a segment, a venous bed, a valve held open.
///
///   from o---[ R ]---o to          0 = p_from - p_to - R q
///
///   q       m3/s      flow from -> to (series q:NAME_m3_s)
///   R       Pa.s/m3   resistance, > 0
///   ground  Pa        pressure of the end that is no node, where only one of from, to is given
///
/// Example:
///   vein: {type: resistor, from: capillary, ground: 4 mmHg, R: 1.2e7 Pa.s/m3}
///
/// Source: Ohm's law of hemodynamics; Formaggia, Quarteroni & Veneziani 2009, ch. 10. Not checked: that R
/// fits a geometry.
#pragma once
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct Resistor : TwoTerminal {
  double R = 0;
  std::optional<double> ground;

  static constexpr const char* type = "resistor";
  static constexpr bool autonomous = true;
  static constexpr Nature nature = Nature::resistive;
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false}};

  template <class T>
  void equations(const In<Resistor, T>& x, Out<Resistor, T>& f) const {
    const T& q = x.y[0];
    f.own[0] = x.p[From] - x.p[To] - R * q;
    f.into = {q, -q};
  }
  std::vector<Terminal> terminals() const { return two_ends(*this, ground); }
};

inline void declare(config::Fields<Resistor>& f) {
  declare_ends(f);
  f.quantity("R", &Resistor::R, "Pa.s/m3", "resistance").positive();
  f.quantity("ground", &Resistor::ground, "Pa", "fixed pressure of the end that is no node");
}

}  // namespace ostium::lumped
