/// Coronary bed: arteries and veins on both sides of a compliance that the heart muscle squeezes.
///
///                     Pa            Pim(t) + share p_ventricle
///                     |                     |
///   from o---[ Ra ]---o---[ Ram ]---o---||--+        V: blood in Cim
///                     |             |  Cim
///                    === Ca         +---[ Rv ]---o to, or the distal pressure Pd
///                     |
///                  ambient
///
///   0 = p_from - Pa - Ra q                      Ca dPa/dt = q - q_m
///   p_m = Pim + share p_ventricle + V/Cim       dV/dt = q_m - q_out
///   q_m = (Pa - p_m)/Ram                        Rv q_out = p_m - p_to
///
///   q, q_out  m3/s      flow in at `from`, out at `to` (series q:NAME_m3_s, q:NAME.q_out_m3_s)
///   Pa        Pa        pressure on Ca, a state: starts at initial_pressure (series p:NAME.Pa_Pa)
///   V         m3        blood that Cim holds, a state: starts at initial_volume, or where veins and muscle balance
///   Ra, Ram, Rv   Pa.s/m3   resistances of large arteries, of arterioles in the muscle, of veins
///   Ca, Cim   m3/Pa     compliances of arteries and of the bed in the muscle
///   Pim       Pa        intramyocardial pressure, a waveform; `ventricle` adds `share` of that node's pressure (closed loop)
///   Ram_max   with it the arterioles are throttled in systole: Ram(t) = (sqrt(Ram) + (sqrt(Ram_max) - sqrt(Ram)) A(t))^2
///             where A is the `activation`
///
/// Example:
///   lca: {type: coronary, from: LCA, Ra: 1.3e9 Pa.s/m3, Ram: 2.1e9 Pa.s/m3, Rv: 4.4e9 Pa.s/m3, Ca: 4e-12
///       m3/Pa, Cim: 3e-11 m3/Pa, Pim: 40 mmHg}
///
/// Source: Kim et al., Ann. Biomed. Eng. 38 (2010) 3195; closed loop: Sankaran et al., Ann. Biomed. Eng. 40 (2012) 2228.
/// Not checked: plausible values.
#pragma once
#include "core/waveform.hpp"
#include "lumped/activation.hpp"
#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"

namespace ostium::lumped {

struct Coronary {
  static constexpr int ports = 3;
  enum Port { From, To, Ventricle };
  Name from, to, ventricle;
  double Ra = 0, Ram = 0, Rv = 0, Ca = 0, Cim = 0, share = 1;
  Waveform Pim;
  std::optional<double> Pd, Ram_max, initial_pressure, initial_volume;
  std::optional<Activation> activation;

  static constexpr const char* type = "coronary";
  static constexpr std::array unknowns{
      Unknown{"q", Quantity::flow, false}, Unknown{"q_out", Quantity::flow, false},
      Unknown{"Pa", Quantity::pressure, true}, Unknown{"V", Quantity::volume, true}};

  template <class T>
  void equations(const In<Coronary, T>& x, Out<Coronary, T>& f) const {
    const T &q = x.y[0], &q_out = x.y[1], &Pa = x.y[2], &V = x.y[3], &dPa = x.dy[2], &dV = x.dy[3];
    const T p_m = Pim.value(x.t) + share * x.p[Ventricle] + V / Cim;
    const T q_m = (Pa - p_m) / arterioles(x.t);
    f.own[0] = x.p[From] - Pa - Ra * q;
    f.own[1] = Rv * q_out - (p_m - x.p[To]);
    f.own[2] = Ca * dPa - (q - q_m);
    f.own[3] = dV - (q_m - q_out);
    f.into = {q, -q_out, T(0)};
  }
  void prepare() {
    if (activation) activation->prepare();
  }
  std::array<Unknown, 4> present_unknowns() const {
    auto all = unknowns;
    all[2].differential = Ca > 0;
    return all;
  }
  std::vector<Terminal> terminals() const;
  std::vector<Branch> branches() const {
    return {{From, lumped::ground, Ra > 0 || Ca == 0 ? Nature::resistive : Nature::capacitive},
            {To, lumped::ground, Nature::resistive}};
  }
  void initial(double* y) const {
    y[2] = initial_pressure.value_or(Pd.value_or(0));
    y[3] = initial_volume.value_or(Cim * (Pd.value_or(0) - Pim.value(0)));
  }
  double compliance() const { return Ca + Cim; }
  bool linear() const { return !Ram_max; }
  std::vector<double> kinks(double t0, double t1) const;

 private:
  double arterioles(double t) const {
    if (!Ram_max) return Ram;
    const double root = std::sqrt(Ram) + (std::sqrt(*Ram_max) - std::sqrt(Ram)) * (*activation)(t);
    return root * root;
  }
};

void declare(config::Fields<Coronary>& f);

}  // namespace ostium::lumped
