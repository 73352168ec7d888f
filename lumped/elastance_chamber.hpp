/// Heart chamber with a linear, time-varying elastance.
///
///   from o---+---( L )---o to      (without `to` the chamber is at `from` alone)
///            |
///          E(t)
///            |
///         ambient
///
///   p_from = E (V - V0),     E = Emin + (Emax - Emin) A(t),     V0 = V0s + (1 - A(t)) (V0d - V0s)
///   dV/dt = q - q_out,       L dq_out/dt = p_from - p_to
///
///   q, q_out     m3/s       flow in at `from`, flow out at `to` (series q:NAME_m3_s, q:NAME.q_out_m3_s)
///   V            m3         volume, a state: starts at initial_volume, else V0d (series v:NAME.V_m3)
///   A            1          activation, 0 at rest, 1 at the height of systole
///   Emin, Emax   Pa/m3      elastance at rest and at the height of systole
///   V0, V0_systole   m3     unstressed volume at rest (V0d) and at the height of systole (V0s, default V0)
///   L            Pa.s2/m3   inertance of the outlet, with `to`
///
/// Example:
///   lv: {type: elastance_chamber, from: LV, Emin: 0.08 mmHg/mL, Emax: 2.5 mmHg/mL, V0: 10 mL,
///       initial_volume: 120 mL, activation: {type: double_hill, start: 0.2 s, tau_1: 0.215 s, tau_2: 0.362
///       s, m1: 1.32, m2: 27.4, period: 0.8 s}}
///
/// Source: Suga & Sagawa, Circ. Res. 35 (1974) 117. Not checked: that V stays positive.
#pragma once
#include "lumped/chamber.hpp"

namespace ostium::lumped {

struct ElastanceChamber : ChamberEnds {
  double Emin = 0, Emax = 0, V0 = 0;
  std::optional<double> V0_systole;

  static constexpr const char* type = "elastance_chamber";

  template <class T>
  void equations(const In<ElastanceChamber, T>& x, Out<ElastanceChamber, T>& f) const {
    const double A = activation(x.t), E = Emin + (Emax - Emin) * A;
    const double V0s = V0_systole.value_or(V0);
    chamber(x, E * (x.y[V] - (V0s + (1 - A) * (V0 - V0s))), f);
  }
  void initial(double* y) const { y[V] = initial_volume.value_or(V0); }
  double compliance() const { return 1 / Emin; }
};

inline void declare(config::Fields<ElastanceChamber>& f) {
  declare_chamber(f);
  f.quantity("Emin", &ElastanceChamber::Emin, "Pa/m3", "elastance at rest").positive();
  f.quantity("Emax", &ElastanceChamber::Emax, "Pa/m3", "elastance at the height of systole").positive();
  f.quantity("V0", &ElastanceChamber::V0, "m3", "unstressed volume").or_else(0.0);
  f.quantity("V0_systole", &ElastanceChamber::V0_systole, "m3",
             "unstressed volume at the height of systole; V0 if not given");
  f.check([](const ElastanceChamber& c) -> std::string {
    if (c.Emin < c.Emax) return {};
    return fmt::format("\"Emin\" is {:g} Pa/m3 and must be smaller than \"Emax\" = {:g} Pa/m3", c.Emin,
                       c.Emax);
  });
}

}  // namespace ostium::lumped
