/// The network linearised about a state, in the form of control theory, and its responses at the ports.
///
///   dx/dt = A x + B Q,   P = C x + D Q       (deviations from the state)
///
///   x  differential unknowns over their scales;  Q  port flows, m3/s;  P  port pressures, Pa
///   held flow          dP(t + dt)/dQ = D + C (int_0^dt e^{As} ds) B
///   oscillation        Z(w) = D + C (i w - A)^-1 B
///   free motion        x(t + dt) = e^{A dt} x(t)
///
/// From M [dx/dt; z] + N x = E Q with M of network/consistent. A singular M is refused: its null vector names
/// the unknowns that the equations leave open. Ports of prescribed flow have zero rows and columns. Source:
/// Antoulas, Approximation of Large-Scale Dynamical Systems (2005), ch. 4; van Loan, IEEE TAC 23 (1978) 395.
/// Not checked: that the state is consistent.
#pragma once
#include <Eigen/Core>

#include "network/system.hpp"

namespace ostium::network {

struct StateSpace {
  Eigen::MatrixXd A, B, C, D;
};

/// Throws UserError where the equations are of higher index or have no unique solution.
StateSpace linearise(const System& system, double t, const double* y, const double* dy);

Eigen::MatrixXd held_flow_response(const StateSpace& s, double dt);
Eigen::MatrixXcd frequency_response(const StateSpace& s, double omega);
Eigen::MatrixXd transition(const StateSpace& s, double dt);

/// e^M.
Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& m);

}  // namespace ostium::network
