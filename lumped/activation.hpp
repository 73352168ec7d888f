/// Activation of a heart chamber: how far its muscle is contracted in the course of a beat.
///
///   A(t) in [0, 1], repeated with the period T;   s = (t - start) mod T
///
///   half_cosine       A = (1 - cos(2 pi s/duration))/2 for s < duration, else 0
///   wrapping_cosine   the same, given by its `end` instead of its start: the atrial kick that begins in the beat before
///   piecewise_cosine  rises as a half cosine from `contract_start` over `contract_duration`, falls as one from
///                     `relax_start` over `relax_duration`, 1 between the two
///   double_hill       g1/(1 + g1)/(1 + g2) over its maximum,  g1 = (s/tau_1)^m1,  g2 = (s/tau_2)^m2
///   fourier           mean + sum_n cos_n cos(2 pi n t/T) + sin_n sin(2 pi n t/T), as it is
///   ventricle         the normalised elastance of human ventricles in 24 harmonics, scaled to [0, 1]
///   table             a waveform of its own
///
///   period T, start, end, durations, tau_1, tau_2   s
///   m1, m2, cos, sin, mean                          1
///
/// Example:
///   {type: half_cosine, start: 0.2 s, duration: 0.3 s, period: 0.8 s}
///
/// Source: piecewise cosine: Regazzoni et al., J. Comput. Phys. 457 (2022) 111083; double Hill: Mynard et al., Int. J.
/// Numer. Meth. Biomed. Engng. 28 (2012) 626, eq. 25; ventricle: coefficients of
/// the tuning framework of J. Tran as published with Menon et al. 2023 and in svZeroDSolver. Not checked: that `fourier` and `table` stay in [0, 1].
#pragma once
#include <optional>
#include <vector>

#include "core/config.hpp"
#include "core/waveform.hpp"

namespace ostium::lumped {

struct Activation {
  enum class Form { half_cosine, wrapping_cosine, piecewise_cosine, double_hill, fourier, ventricle, table };
  Form form = Form::half_cosine;
  std::optional<double> period, start, end, duration;
  std::optional<double> contract_start, contract_duration, relax_start, relax_duration;
  std::optional<double> tau_1, tau_2, m1, m2;
  std::optional<double> mean;
  std::optional<std::vector<double>> cos, sin;
  std::optional<Waveform> table;

  /// Computes what every evaluation needs; once, before the first one.
  void prepare();
  double operator()(double t) const;
  /// s, times in (t0, t1) at which a derivative of A jumps.
  std::vector<double> kinks(double t0, double t1) const;

 private:
  void check_values() const;
  std::vector<double> corners() const;
  double start_ = 0;
  double largest_ = 1;  // of the two Hill functions
  std::vector<double> cos_, sin_;
  double mean_ = 0;
};

/// Least and largest value of the normalised ventricular elastance before it is scaled to [0, 1].
struct Range {
  double low, high;
};
Range ventricular_range();

void declare(config::Fields<Activation>& f);

}  // namespace ostium::lumped
