/// The equations of the sensitivities along a trajectory, and what happens to them where a valve switches.
///
///   F_y s + F_dy ds/dt + F_p = 0          between two events, one column s = dy/dp per direction
///   s_x+ = s_x- + (dx/dt- - dx/dt+) dtau/dp,     dtau/dp = -(g_y s- + g_p)/(g_t + g_y dy/dt-)       at an event
///
///   s     dy/dp, over the size of the direction: a state's scale, a parameter's size
///   F_p   dF/dp, a central difference of the one block's residual: blocks are linear or smooth in their parameters, so
///         that it is right to 1e-9
///   g     guard of the switch, tau the time at which it passes zero; x the states, which are continuous there
///
/// Directions are first the states (`free` of them, F_p = 0), then the parameters. The rates ds_x/dt and the algebraic
/// s follow from s_x by the matrix M of network/consistent. Where a guard only touches zero (its rate vanishes) the time
/// of the event has no derivative, and no jump is made. Source: Hiskens & Pai, IEEE Trans. Circuits Syst. I 47 (2000)
/// 204, eq. 26-34; Leine & Nijmeijer, Dynamics and Bifurcations of Non-Smooth Mechanical Systems (2004), ch. 7.
/// Not checked: that two guards do not pass zero in the same instant for different reasons.
#pragma once
#include <Eigen/Dense>
#include <Eigen/SparseLU>
#include <span>
#include <vector>

#include "network/parameters.hpp"
#include "network/system.hpp"

namespace ostium::network {

/// The block with a parameter a little above and below its value; weight: size/(distance of the two).
struct Nearby {
  int entry = 0;
  std::shared_ptr<const lumped::Block> above, below;
  double weight = 0;
  double reach = 0;  // s, how far the two are apart in time, where the parameter is a time
};

/// Throws UserError where the parameter is 0 and leaves an element out.
Nearby nearby(const System& system, const Parameter& parameter);

class Tangent {
 public:
  Tangent(const System& system, int free, std::vector<Nearby> parameters);

  int count() const { return free_ + static_cast<int>(parameters_.size()); }

  /// The piece between two stops in which the next calls are. A parameter that moves a kink is differenced inside it: at
  /// its ends the two neighbours lie on different sides of the kink.
  void piece(double a, double b);

  /// Start values of the columns of the parameters, on the differential unknowns: dy(0)/dp of a start from rest.
  Eigen::MatrixXd start() const;

  /// From the rows of the states in S: its other rows, and the rates dS of the states, at consistent (y, dy).
  void settle(double t, const double* y, const double* dy, Eigen::MatrixXd& S, Eigen::MatrixXd& dS);

  /// F_y s + F_dy ds + F_p for all columns: what the integrator brings to zero.
  void residual(double t, const double* y, const double* dy, const std::vector<const double*>& s,
                const std::vector<const double*>& ds, const std::vector<double*>& f);

  /// Rates of all unknowns at consistent (y, dy).
  Eigen::VectorXd rates(double t, std::span<const double> port_flow, const double* y, const double* dy);

  /// dtau/dp of the event at which guard k passes zero; S complete, before the switch is thrown.
  Eigen::RowVectorXd event_time(int k, double t, std::span<const double> port_flow, const double* y,
                                const double* dy, const Eigen::MatrixXd& S);

 private:
  void factorise(double t, const double* y, const double* dy);
  Eigen::MatrixXd solved(const Eigen::MatrixXd& f) const;
  double guard(int k, double t, const Eigen::VectorXd& y, const double* dy) const;
  void add_parameter(int p, double t, const double* y, const double* dy, double* f) const;

  const System& system_;
  int free_;
  std::vector<Nearby> parameters_;
  double inside_from_ = -1e300, inside_to_ = 1e300;
  std::vector<double> d_y_, d_dy_;
  Eigen::SparseMatrix<double> matrix_;
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu_;
  Eigen::VectorXd row_scale_;
};

}  // namespace ostium::network
