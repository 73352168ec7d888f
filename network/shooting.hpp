/// Finds the periodic state of an orbit, and says what it cost.
///
///   Newton    (I - M) d = Phi(x) - x,   with c^T d = 0 for every invariant c:   [I - M  c; c^T  0] [d; l] = [Phi(x) - x; 0]
///   Anderson  x <- the combination of the last periods whose residual is least; for networks of many states
///
///   change    largest |Phi(x) - x| of all states over their scales (100 mmHg, 100 mL/s, 100 mL)
///
/// A closed loop has the eigenvalue 1 in M, one for each invariant: its periodic states form a family, one for each blood
/// volume. The volume of the start is kept. Where nothing is conserved there are no c and the equations are Newton's.
/// A step of Newton's that makes the change grow is halved. Where something is conserved that is not linear in the states,
/// plain periods, which keep it, bring the start near first. Source: Guckenheimer & Holmes 1983, sec. 1.5 (Poincare maps);
/// Walker & Ni, SIAM J. Numer. Anal. 49 (2011) 1715 (Anderson). Not checked: that the periodic state is stable.
#pragma once
#include "network/orbit.hpp"
#include "network/periodic_report.hpp"

namespace ostium::network {

/// Leaves the orbit at its periodic state. Throws UserError where there is none, NumericsError where it is not found.
/// A correction is the last one where the period before it changed the states by less than `enough` of their scales.
PeriodicReport find_periodic(Orbit& orbit, double enough = 1e-6);

/// Solves (I - M) d = r with c d = given: d on the states, over their scales. Throws UserError where a state goes on and on.
Eigen::MatrixXd bordered(const Orbit& orbit, const Eigen::MatrixXd& M, const Eigen::MatrixXd& c,
                         const Eigen::MatrixXd& r, const Eigen::MatrixXd& given);

/// Left null vectors of I - M that no linear invariant c accounts for: gradients of something else that is conserved, as
/// the volume of a sphere over its radius. One row each.
Eigen::MatrixXd further_invariants(const Eigen::MatrixXd& M, const Eigen::MatrixXd& c);

}  // namespace ostium::network
