/// Resistance, compliance, inertance and stenosis of a vessel from pressures and flows at its two ends.
///
///   Qin --o--[ R + S|Qin| ]--+--[ L ]--o-- Qout        R first;   C first: the capacitor stands at the inlet and
///        Pin                 C         Pout            the resistance sees Qout
///                           ===
///
///   Pin - Pout = (R + S|Q|) Q + L dQout/dt                         for every observation k
///   Qin - Qout = C dPc/dt,   Pc = Pin - (R + S|Qin|) Qin  (C first: Pin)
///
///   minimise  sum_k (first/s_P)^2 + (second/s_Q)^2 over R, C >= 0, L >= 0, S
///
///   R, C, L, S   Pa.s/m3, m3/Pa, Pa.s2/m3, Pa.s2/m6 (or any other consistent units)
///   s_P, s_Q     spreads of the pressures and flows: the answer does not depend on the units
///
/// The first equation is linear in R, L, S, the second in C: Gauss-Newton from the two linear answers, each step by an
/// orthogonal decomposition of columns of length one. Directions the data do not see (L where flows are steady) keep
/// their start values. R and S may be negative: so they are where pressure is recovered behind a narrowing.
/// Source: Bjoerck, Numerical Methods for Least Squares Problems (1996), ch. 2 and 9.3; Richter et al., IEEE Trans.
/// Biomed. Eng. 71 (2024) 2 (the task). Not checked: that the rates are those of the values.
#pragma once
#include <Eigen/Core>

namespace ostium::network {

/// One row per observation.
struct EndsOfVessel {
  Eigen::VectorXd p_in, p_out, q_in, q_out;  // Pa, m3/s
  Eigen::VectorXd dp_in, dq_in, dq_out;      // their rates, Pa/s, m3/s2
  bool compliance_first = false;
};

struct VesselParameters {
  double R = 0, C = 0, L = 0, S = 0;
};

struct VesselFitOptions {
  bool stenosis = true;    // false: S = 0
  bool compliance = true;  // false: C = 0
  bool balanced = true;    // false: s_P = s_Q = 1, a misfit of one unit of pressure counts as one of flow
};

struct VesselFit {
  VesselParameters parameters;
  double residual = 0;   // root mean square of the weighted equations, ratio
  int undetermined = 0;  // directions in which the data do not say anything
  int iterations = 0;
};

VesselFit fit_vessel(const EndsOfVessel& ends, const VesselParameters& start,
                     const VesselFitOptions& options);

}  // namespace ostium::network
