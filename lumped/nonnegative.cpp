#include "lumped/nonnegative.hpp"

#include <Eigen/QR>
#include <vector>

namespace ostium::lumped {
namespace {

/// The least squares solution over the columns of the set; 0 elsewhere.
Eigen::VectorXd solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b, const std::vector<int>& set) {
  const Eigen::MatrixXd part = A(Eigen::all, set);
  const Eigen::VectorXd y = part.colPivHouseholderQr().solve(b);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  x(set) = y;
  return x;
}

/// The column that would lower the error most; -1: none would.
int entering(const Eigen::VectorXd& gradient, const std::vector<int>& set, double tolerance) {
  Eigen::VectorXd g = gradient;
  for (int k : set) g[k] = 0;
  Eigen::Index best = 0;
  return g.maxCoeff(&best) > tolerance ? static_cast<int>(best) : -1;
}

/// From x towards z as far as all stay non-negative; what reaches zero leaves the set.
void shorten(Eigen::VectorXd& x, const Eigen::VectorXd& z, std::vector<int>& set) {
  double step = 1;
  for (int k : set)
    if (z[k] <= 0) step = std::min(step, x[k] / (x[k] - z[k]));
  x += step * (z - x);
  const double tiny = 1e-14 * x.maxCoeff();
  std::erase_if(set, [&](int k) { return x[k] <= tiny ? (x[k] = 0, true) : false; });
}

}  // namespace

Eigen::VectorXd nonnegative_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  std::vector<int> set;
  const double tolerance = 1e-9 * (A.transpose() * b).cwiseAbs().maxCoeff();
  double error = b.squaredNorm();
  for (Eigen::Index round = 0; round < A.cols(); ++round) {
    const int k = entering(A.transpose() * (b - A * x), set, tolerance);
    if (k < 0) break;
    set.push_back(k);
    Eigen::VectorXd z = solve(A, b, set);
    for (Eigen::Index inner = 0; inner < A.cols() && !set.empty() && z(set).minCoeff() <= 0; ++inner) {
      shorten(x, z, set);
      if (!set.empty()) z = solve(A, b, set);
    }
    x = set.empty() ? Eigen::VectorXd::Zero(A.cols()) : z;
    const double now = (b - A * x).squaredNorm();
    if (now > (1 - 1e-4) * error) break;  // nothing is gained any more
    error = now;
  }
  return x;
}

}  // namespace ostium::lumped
