/// A rational impedance that is passive by construction, fitted to samples of an impedance.
///
///   Z(s) = D + sum_k a_k/(1 + s tau_k) + sum_k a_k d_k s tau_k/(1 + d_k s tau_k + s^2 tau_k^2)
///
///   made of resistances in series, each alone or with other elements beside it, so that each is passive:
///     R                                   nothing beside it              R >= 0
///     R/(1 + s tau)                       a capacitor (a = R)            R >= 0
///     R s tau/(1 + s tau)                 an inductor (a = -R, and D grows by R)
///     R B, B = d s tau/(1 + d s tau + s^2 tau^2)       both: resonant (a = R)
///     R (1 - B)                           both in series: a notch (a = -R, and D grows by R)
///
///   minimise sum_n |Z(i omega_n) - Z_n|^2/|Z_n|^2   over R >= 0 of all parts on a grid of tau and d, Z(0) exact if given
///
///   omega_n, Z_n   rad/s, Pa.s/m3   samples; the first one may be at 0
///   tau, d         s, 1             1/tau: corner or resonance, d: its damping
///
/// A sum of passive impedances is passive, whatever the samples. Non-negative least squares leave few parts different
/// from zero (Lawson & Hanson 1974, ch. 23); those near each other are joined, the ones whose loss costs least are
/// dropped until `most_states` are left, and tau and d of the rest are moved to the least error. Not checked: that the
/// samples are those of something passive; `error` says what remains.
#pragma once
#include <complex>
#include <vector>

namespace ostium::lumped {

struct ImpedanceSample {
  double omega = 0;              // rad/s, >= 0
  std::complex<double> Z{0, 0};  // Pa.s/m3
};

struct RationalImpedance {
  struct Term {
    double a, tau, damping = 0;  // Pa.s/m3, s, 1 (of a resonance, else 0)
  };
  double D = 0;  // Pa.s/m3, what answers at once
  std::vector<Term> terms;
  double error = 0;  // root mean square of |Z - Z_n|/|Z_n|

  std::complex<double> operator()(double omega) const;
};

RationalImpedance fit_impedance(const std::vector<ImpedanceSample>& samples, int most_states);

}  // namespace ostium::lumped
