/// Three-element Windkessel: characteristic resistance, compliance and resistance of the bed beyond an
/// outlet.
///
///                      Pc
///   from o---[ Rp ]----o----[ Rd ]---o to, or the distal pressure Pd
///                      |
///                     === C
///                      |
///                   ambient (0 Pa)
///
///   0 = p_from - Pc - Rp q,     C dPc/dt = q - (Pc - p_to)/Rd
///
///   q        m3/s      flow entering at `from` (series q:NAME_m3_s)
///   Pc       Pa        pressure on the compliance, a state: starts at initial_pressure (series p:NAME.Pc_Pa)
///   Rp, Rd   Pa.s/m3   proximal resistance >= 0, distal resistance > 0
///   C        m3/Pa     compliance, > 0
///   Pd       Pa        distal pressure where there is no node `to` (default 0)
///
/// Impedance Z(w) = Rp + Rd/(1 + i w Rd C). With Rp = 0 it is the two-element Windkessel.
///
/// Example:
///   dao: {type: windkessel, from: DAo, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3, Pd: 5 mmHg}
///
/// Source: Westerhof, Lankhaar & Westerhof, Med. Biol. Eng. Comput. 47 (2009) 131. Not checked: plausible
/// values.
#pragma once
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct Windkessel : TwoTerminal {
  double Rp = 0, C = 0, Rd = 0;
  std::optional<double> Pd, initial_pressure;

  static constexpr const char* type = "windkessel";
  static constexpr bool autonomous = true;
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false},
                                       Unknown{"Pc", Quantity::pressure, true}};

  template <class T>
  void equations(const In<Windkessel, T>& x, Out<Windkessel, T>& f) const {
    const T &q = x.y[0], &Pc = x.y[1], &dPc = x.dy[1];
    const T q_distal = (Pc - x.p[To]) / Rd;
    f.own[0] = x.p[From] - Pc - Rp * q;
    f.own[1] = C * dPc - (q - q_distal);
    f.into = {q, -q_distal};
  }
  std::vector<Terminal> terminals() const { return distal_end(*this, Pd); }
  std::vector<Branch> branches() const {
    return {{From, lumped::ground, Rp > 0 ? Nature::resistive : Nature::capacitive},
            {To, lumped::ground, Nature::resistive}};
  }
  void initial(double* y) const { y[1] = initial_pressure.value_or(Pd.value_or(0)); }
  double compliance() const { return C; }
};

inline void declare(config::Fields<Windkessel>& f) {
  declare_ends(f);
  f.quantity("Rp", &Windkessel::Rp, "Pa.s/m3", "proximal (characteristic) resistance").non_negative();
  f.quantity("C", &Windkessel::C, "m3/Pa", "compliance").positive();
  f.quantity("Rd", &Windkessel::Rd, "Pa.s/m3", "distal resistance").positive();
  f.quantity("Pd", &Windkessel::Pd, "Pa", "distal pressure where there is no node `to`; 0 if not given");
  f.quantity("initial_pressure", &Windkessel::initial_pressure, "Pa",
             "pressure on C at the start; Pd if not given");
}

}  // namespace ostium::lumped
