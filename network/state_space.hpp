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
#include <array>

#include "network/system.hpp"

namespace ostium::network {

struct StateSpace {
  Eigen::MatrixXd A, B, C, D;
};

/// Throws UserError where the equations are of higher index or have no unique solution.
StateSpace linearise(const System& system, double t, const double* y, const double* dy);

/// The same refusal about the start, without the matrices: cheap for large networks.
void check_index(const System& system);

Eigen::MatrixXd held_flow_response(const StateSpace& s, double dt);
Eigen::MatrixXcd frequency_response(const StateSpace& s, double omega);
Eigen::MatrixXd transition(const StateSpace& s, double dt);

/// phi_0 = e^M and phi_k = int_0^1 e^{(1-s)M} s^(k-1)/(k-1)! ds for k = 1 .. 4: from x to e^M x + sum phi_(k+1) c_k where
/// dx/ds = M x + sum c_k s^k/k!. Source: Hochbruck & Ostermann, Acta Numer. 19 (2010) 209; Skaflestad & Wright, Appl.
/// Numer. Math. 59 (2009) 783 (scaling and squaring).
std::array<Eigen::MatrixXd, 5> phi_functions(const Eigen::MatrixXd& m);

/// e^M.
Eigen::MatrixXd matrix_exponential(const Eigen::MatrixXd& m);

}  // namespace ostium::network
