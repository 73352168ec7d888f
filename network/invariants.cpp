#include "network/invariants.hpp"

#include <Eigen/QR>
#include <Eigen/SVD>

namespace ostium::network {

namespace {

constexpr double null = 1e-10;  // of the scaled equations: above round-off, below any leak

}  // namespace

Invariants::Invariants(const System& system)
    : system_(system), d_y_(system.pattern().nonZeros()), d_dy_(system.pattern().nonZeros()) {}

/// A part of the Jacobian with its columns in units of the unknowns' scales and its rows in units of row_scale.
Eigen::MatrixXd Invariants::scaled(const std::vector<double>& values) const {
  const int n = system_.size();
  Eigen::MatrixXd m = Eigen::MatrixXd::Zero(n, n);
  const int *begin = system_.pattern().outerIndexPtr(), *row = system_.pattern().innerIndexPtr();
  for (int j = 0; j < n; ++j)
    for (int k = begin[j]; k < begin[j + 1]; ++k)
      m(row[k], j) = values[k] * system_.scale()[j] / row_scale_[row[k]];
  return m;
}

void Invariants::see(double t, const double* y, const double* dy) {
  if (seen_ && l_.rows() == 0) return;
  system_.jacobian(t, y, dy, d_y_.data(), d_dy_.data());
  if (!seen_) return first();
  const Eigen::MatrixXd left = l_ * scaled(d_y_);
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(left, Eigen::ComputeFullU);
  const auto kept = (svd.singularValues().array() < null).count() + left.rows() - svd.singularValues().size();
  l_ = (svd.matrixU().rightCols(kept).transpose() * l_).eval();
}

void Invariants::first() {
  const int n = system_.size();
  row_scale_ = Eigen::VectorXd::Ones(n);
  const Eigen::VectorXd of_y = scaled(d_y_).cwiseAbs().rowwise().maxCoeff(),
                        of_dy = scaled(d_dy_).cwiseAbs().rowwise().maxCoeff();
  for (int i = 0; i < n; ++i) row_scale_[i] = of_y[i] > 0 ? of_y[i] : of_dy[i] > 0 ? of_dy[i] : 1.0;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(scaled(d_y_));
  qr.setThreshold(null);
  const Eigen::MatrixXd q = qr.householderQ();
  l_ = q.rightCols(n - qr.rank()).transpose();
  seen_ = true;
}

Eigen::MatrixXd Invariants::rows() {
  const auto& states = system_.states();
  Eigen::MatrixXd c(l_.rows(), states.size());
  const Eigen::MatrixXd all = l_ * scaled(d_dy_);
  for (size_t i = 0; i < states.size(); ++i) c.col(i) = all.col(states[i]);
  if (c.size() == 0) return Eigen::MatrixXd(0, states.size());
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(c, Eigen::ComputeThinU | Eigen::ComputeThinV);
  const auto kept = (svd.singularValues().array() > null).count();
  const Eigen::MatrixXd to_unit =
      svd.singularValues().head(kept).cwiseInverse().asDiagonal() * svd.matrixU().leftCols(kept).transpose();
  l_ = (to_unit * l_).eval();
  return svd.matrixV().leftCols(kept).transpose();
}

Eigen::VectorXd Invariants::combined(const Eigen::VectorXd& f) const {
  return l_ * f.cwiseQuotient(row_scale_);
}

}  // namespace ostium::network
