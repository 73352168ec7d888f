/// Compliance and resistance: the pulmonary bed of a closed loop.
///
///   from o---o---[ R ]---o to       stores: true    C du/dt = q - q_out,   R q_out = u - p_to,   u = p_from
///            |
///           === C                   stores: false   C du/dt = q - (u - p_to)/R,   q_out = q
///            |
///         ambient
///
///   q, q_out   m3/s      flow in at `from`, out at `to` (series q:NAME_m3_s, q:NAME.q_out_m3_s)
///   u          Pa        pressure at `from`, a state: starts at initial_pressure (series p:NAME.u_Pa)
///   R          Pa.s/m3   resistance, > 0
///   C          m3/Pa     compliance, > 0
///   stores     with false the pressure lags as on a compliance, but all blood that enters leaves at once: the
///              pulmonary bed of Sankaran's closed loop. Volumes of such a loop are those of its chambers.
///
/// Example:
///   lungs: {type: rc, from: PA, to: LA, R: 1.3e7 Pa.s/m3, C: 8e-9 m3/Pa}
///
/// Source: Sankaran et al., Ann. Biomed. Eng. 40 (2012) 2228. Not checked: plausible values.
#pragma once
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct Rc : TwoTerminal {
  double R = 0, C = 0;
  bool stores = true;
  double initial_pressure = 0;
  std::optional<double> ground;

  static constexpr const char* type = "rc";
  static constexpr bool autonomous = true;
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false},
                                       Unknown{"q_out", Quantity::flow, false},
                                       Unknown{"u", Quantity::pressure, true}};

  template <class T>
  void equations(const In<Rc, T>& x, Out<Rc, T>& f) const {
    const T &q = x.y[0], &q_out = x.y[1], &u = x.y[2], &du = x.dy[2];
    const T through = (u - x.p[To]) / R;
    f.own[0] = x.p[From] - u;
    f.own[1] = q_out - (stores ? through : q);
    f.own[2] = C * du - (q - through);
    f.into = {q, -q_out};
  }
  std::vector<Terminal> terminals() const { return two_ends(*this, ground); }
  std::vector<Branch> branches() const {
    return {{From, lumped::ground, Nature::capacitive}, {From, To, Nature::resistive}};
  }
  void initial(double* y) const { y[2] = initial_pressure; }
  double compliance() const { return stores ? C : 0; }
};

inline void declare(config::Fields<Rc>& f) {
  declare_ends(f);
  f.quantity("R", &Rc::R, "Pa.s/m3", "resistance").positive();
  f.quantity("C", &Rc::C, "m3/Pa", "compliance").positive();
  f.flag("stores", &Rc::stores, "whether the compliance takes blood in; false: only the pressure lags")
      .or_else(true);
  f.quantity("ground", &Rc::ground, "Pa", "fixed pressure of the end that is no node");
  f.quantity("initial_pressure", &Rc::initial_pressure, "Pa", "pressure at `from` at the start").or_else(0.0);
}

}  // namespace ostium::lumped
