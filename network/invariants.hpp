/// What a network conserves: combinations of its states that no trajectory changes, the total blood volume of a closed
/// loop above all.
///
///   l^T F(t, y, dy) = c^T dy/dt - s(t)  for all y     =>     c^T x(T) - c^T x(0) = int_0^T s dt
///
///   l   combination of the equations in which no unknown is left but rates: l^T F_y = 0 along the trajectory
///   c   l^T F_dy, over the states in units of their scales;  s  what sources add, 0 in a closed loop
///
/// Found by linear algebra alone: the left null space of F_y at a first point of the trajectory, narrowed at others.
/// Blocks need to say nothing, two separate loops give two invariants, and c is right to round-off, which an
/// eigenvector of the monodromy matrix is not. Not checked: that the points show every position of the valves.
#pragma once
#include <Eigen/Core>
#include <vector>

#include "network/system.hpp"

namespace ostium::network {

class Invariants {
 public:
  explicit Invariants(const System& system);
  /// The parameters have changed.
  void forget() { seen_ = false; }

  /// Narrows them by the equations at this point.
  void see(double t, const double* y, const double* dy);

  /// c^T, one row of length 1 per invariant, orthogonal to each other. After the last `see`.
  Eigen::MatrixXd rows();

  /// l^T f: what residuals f of all equations (SI) mean for each invariant.
  Eigen::VectorXd combined(const Eigen::VectorXd& f) const;

 private:
  Eigen::MatrixXd scaled(const std::vector<double>& values) const;
  void first();

  const System& system_;
  bool seen_ = false;
  Eigen::VectorXd row_scale_;
  Eigen::MatrixXd l_;  // l^T, over the equations in units of row_scale
  std::vector<double> d_y_, d_dy_;
};

}  // namespace ostium::network
