/// Heart chamber that fills against an exponential stiffness and contracts with a linear elastance: an atrium.
///
///   from o---+---( L )---o to      (without `to` the chamber is at `from` alone)
///            |
///        muscle || tissue
///            |
///         ambient
///
///   p_from = A(t) Emax (V - V0) + (1 - A(t)) P0 (e^{k (V - V0)} - 1)
///   dV/dt = q - q_out,       L dq_out/dt = p_from - p_to
///
///   q, q_out   m3/s       flow in at `from`, flow out at `to` (series q:NAME_m3_s, q:NAME.q_out_m3_s)
///   V          m3         volume, a state: starts at initial_volume, else V0 (series v:NAME.V_m3)
///   A          1          activation
///   Emax       Pa/m3      elastance of the contracted muscle
///   P0, k      Pa, 1/m3   passive pressure and its exponent
///   V0         m3         unstressed volume
///   L          Pa.s2/m3   inertance of the outlet, with `to`
///
/// Example:
///   la: {type: exponential_chamber, from: LA, Emax: 0.3 mmHg/mL, P0: 9.2 mmHg, k: 0.008 1/mL, V0: 9 mL,
///       initial_volume: 38 mL, activation: {type: half_cosine, start: 0.7 s, duration: 0.4 s, period: 1 s}}
///
/// Source: Sankaran et al., Ann. Biomed. Eng. 40 (2012) 2228. Not checked: that V stays positive.
#pragma once
#include "lumped/chamber.hpp"

namespace ostium::lumped {

struct ExponentialChamber : ChamberEnds {
  double Emax = 0, P0 = 0, k = 0, V0 = 0;

  static constexpr const char* type = "exponential_chamber";

  template <class T>
  void equations(const In<ExponentialChamber, T>& x, Out<ExponentialChamber, T>& f) const {
    using std::exp;
    const double A = activation(x.t);
    const T stretch = x.y[V] - V0;
    chamber(x, A * Emax * stretch + (1 - A) * P0 * (exp(k * stretch) - 1.0), f);
  }
  void initial(double* y) const { y[V] = initial_volume.value_or(V0); }
  double compliance() const { return 1 / (P0 * k); }
};

inline void declare(config::Fields<ExponentialChamber>& f) {
  declare_chamber(f);
  f.quantity("Emax", &ExponentialChamber::Emax, "Pa/m3", "elastance of the contracted muscle").positive();
  f.quantity("P0", &ExponentialChamber::P0, "Pa", "passive pressure").positive();
  f.quantity("k", &ExponentialChamber::k, "1/m3", "exponent of the passive stiffness").positive();
  f.quantity("V0", &ExponentialChamber::V0, "m3", "unstressed volume").or_else(0.0);
}

}  // namespace ostium::lumped
