/// Lumped values of a piece of a vessel with openBF's wall law at a working pressure, and that pressure.
///
///   A = A0 (1 + (P - Pext)/beta)^2
///   R = int 2 (gamma + 2) pi mu/A^2 dx,   L = int rho/A dx,   C = int 2 sqrt(A A0)/beta dx
///
///   The radius is linear in x; the integrals are Simpson sums.
///
/// The working pressures are those of the steady state at the mean inflow, in which each vessel's R belongs to its mean
/// pressure: about it the linear network has the mean flows and the small waves of the nonlinear one.
#pragma once
#include "app/import/openbf_source.hpp"

namespace ostium::app::openbf {

struct Lumped {
  double R = 0, L = 0, C = 0;  // Pa.s/m3, Pa.s2/m3, m3/Pa
};

/// Of the piece between the shares a and b of the vessel's length.
Lumped lumped(const VesselData& v, const BloodData& blood, double pressure, double a, double b);

/// rho c/A at the end of a vessel, Pa.s/m3.
double wave_impedance(const VesselData& v, const BloodData& blood, double pressure);

/// What ends a last vessel.
struct Outlet {
  double R1 = 0, R2 = 0, Cc = 0;  // Windkessel, Cc = 0: a resistance R1
  double ground = 0;              // Pa
};
Outlet outlet(const VesselData& v, const BloodData& blood, double pressure);

struct Steady {
  std::vector<double> pressure, flow;  // Pa, m3/s: mean over each vessel
  std::vector<double> end;             // Pa, at its end
};
/// Throws UserError where that state does not exist.
Steady steady_state(const Source& source);

}  // namespace ostium::app::openbf
