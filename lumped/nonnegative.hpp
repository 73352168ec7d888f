/// Least squares with non-negative unknowns.
///
///   minimise |A x - b|^2   over x >= 0
///
/// Source: Lawson & Hanson, Solving Least Squares Problems, 1974, ch. 23 (active set). Not checked: that A is not empty.
#pragma once
#include <Eigen/Core>

namespace ostium::lumped {

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace ostium::lumped
