/// A heart of four chambers that feeds the body, two coronary beds and the lungs: nothing enters, nothing leaves.
#pragma once
#include "tests/network/support.hpp"

namespace ostium::network {

inline const std::string twitch =
    "activation: {type: half_cosine, start: 0.1 s, duration: 0.4 s, period: 0.8 s}";
inline const std::string kick =
    "activation: {type: wrapping_cosine, end: 0.1 s, duration: 0.3 s, period: 0.8 s}";

inline const std::string closed_loop =
    "lv: {type: elastance_chamber, from: LV, Emin: 1e7 Pa/m3, Emax: 3e8 Pa/m3, V0: 10 mL, initial_volume: "
    "110 mL, " +
    twitch +
    "}\n"
    "rv: {type: elastance_chamber, from: RV, Emin: 6e6 Pa/m3, Emax: 7e7 Pa/m3, V0: 20 mL, initial_volume: "
    "110 mL, " +
    twitch +
    "}\n"
    "la: {type: exponential_chamber, from: LA, Emax: 3e7 Pa/m3, P0: 1200 Pa, k: 8000 1/m3, V0: 9 mL, "
    "initial_volume: "
    "70 mL, " +
    kick +
    "}\n"
    "ra: {type: exponential_chamber, from: RA, Emax: 2e7 Pa/m3, P0: 800 Pa, k: 7000 1/m3, V0: 9 mL, "
    "initial_volume: "
    "70 mL, " +
    kick +
    "}\n"
    "aortic: {type: valve, from: LV, to: Ao, R: 2e6 Pa.s/m3, L: 1.5e4 Pa.s2/m3}\n"
    "pulmonary: {type: valve, from: RV, to: PA, R: 1e6 Pa.s/m3, L: 1.5e4 Pa.s2/m3}\n"
    "mitral: {type: valve, from: LA, to: LV, R: 1e6 Pa.s/m3, L: 4e4 Pa.s2/m3}\n"
    "tricuspid: {type: valve, from: RA, to: RV, R: 1e6 Pa.s/m3}\n"
    "aorta: {type: vessel, from: Ao, to: cap, R: 1e6 Pa.s/m3, C: 1e-8 m3/Pa, L: 1e5 Pa.s2/m3, order: CRL, "
    "initial_pressure: 80 mmHg}\n"
    "body: {type: windkessel, from: cap, to: V, Rp: 5e6 Pa.s/m3, C: 2e-9 m3/Pa, Rd: 1.2e8 Pa.s/m3, "
    "initial_pressure: "
    "80 mmHg}\n"
    "lca: {type: coronary, from: Ao, to: V, ventricle: LV, share: 0.5, Ra: 1.3e9 Pa.s/m3, Ram: 2.1e9 "
    "Pa.s/m3, Rv: "
    "4.4e9 Pa.s/m3, Ca: 4e-12 m3/Pa, Cim: 3e-11 m3/Pa, initial_pressure: 80 mmHg}\n"
    "rca: {type: coronary, from: Ao, to: V, ventricle: RV, share: 0.7, Ra: 1.8e9 Pa.s/m3, Ram: 3e9 Pa.s/m3, "
    "Rv: 6e9 "
    "Pa.s/m3, Ca: 3e-12 m3/Pa, Cim: 2e-11 m3/Pa, initial_pressure: 80 mmHg}\n"
    "veins: {type: capacitor, from: V, C: 4e-7 m3/Pa, initial_pressure: 8 mmHg}\n"
    "cava: {type: resistor, from: V, to: RA, R: 1e6 Pa.s/m3}\n"
    "lungs: {type: rc, from: PA, to: LA, R: 1.3e7 Pa.s/m3, C: 3e-8 m3/Pa, initial_pressure: 15 mmHg}\n";

/// m3, in the chambers and on the compliances.
inline double blood(const Network& n) {
  double sum = 0;
  for (const char* volume : {"lv", "rv", "la", "ra", "lca", "rca"})
    sum += series(n, "v:" + std::string(volume) + ".V_m3");
  return sum + 1e-8 * series(n, "p:aorta.u_Pa") + 2e-9 * series(n, "p:body.Pc_Pa") +
         4e-7 * series(n, "p:veins.u_Pa") + 3e-8 * series(n, "p:lungs.u_Pa") +
         4e-12 * series(n, "p:lca.Pa_Pa") + 3e-12 * series(n, "p:rca.Pa_Pa");
}

}  // namespace ostium::network
