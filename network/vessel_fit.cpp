#include "network/vessel_fit.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <vector>

namespace ostium::network {

namespace {

using Eigen::ArrayXd;
using Eigen::MatrixXd;
using Eigen::Vector4d;
using Eigen::VectorXd;

enum { R, C, L, S };

double spread(const VectorXd& a, const VectorXd& b) {
  const double size = std::sqrt(0.5 * (a.squaredNorm() + b.squaredNorm()) / static_cast<double>(a.size()));
  return size > 0 ? size : 1;
}

/// The weighted equations and their derivatives.
class Equations {
 public:
  Equations(const EndsOfVessel& e, bool balanced) : e_(e), q_(e.compliance_first ? e.q_out : e.q_in) {
    if (!balanced) return;
    s_q_ = spread(e.q_in, e.q_out);
    const VectorXd level = VectorXd::Constant(e.p_in.size(), 0.5 * (e.p_in.mean() + e.p_out.mean()));
    s_p_ = spread(e.p_in - level, e.p_out - level);
  }
  Eigen::Index rows() const { return 2 * q_.size(); }

  VectorXd residual(const Vector4d& x) const {
    VectorXd r(rows());
    const ArrayXd drop = (x[R] + x[S] * q_.array().abs()) * q_.array() + x[L] * e_.dq_out.array();
    r << ((e_.p_in - e_.p_out).array() - drop).matrix() / s_p_,
        ((e_.q_in - e_.q_out) - x[C] * charging(x)) / s_q_;
    return r;
  }

  MatrixXd jacobian(const Vector4d& x) const {
    const auto n = q_.size();
    const ArrayXd q = q_.array();
    MatrixXd J = MatrixXd::Zero(rows(), 4);
    J.col(R).head(n) = -q / s_p_, J.col(L).head(n) = -e_.dq_out / s_p_,
    J.col(S).head(n) = -q * q.abs() / s_p_;
    J.col(C).tail(n) = -charging(x) / s_q_;
    if (e_.compliance_first) return J;
    J.col(R).tail(n) = x[C] * e_.dq_in / s_q_;
    J.col(S).tail(n) = 2 * x[C] * q.abs() * e_.dq_in.array() / s_q_;
    return J;
  }

 private:
  VectorXd charging(const Vector4d& x) const {  // dPc/dt
    if (e_.compliance_first) return e_.dp_in;
    return (e_.dp_in.array() - (x[R] + 2 * x[S] * q_.array().abs()) * e_.dq_in.array()).matrix();
  }

  const EndsOfVessel& e_;
  const VectorXd& q_;
  double s_p_ = 1, s_q_ = 1;
};

struct Step {
  Vector4d d = Vector4d::Zero();
  int undetermined = 0;
};

/// Least squares over the parameters that are free; columns that the data do not see are left out.
Step step(const Equations& equations, const Vector4d& x, const std::vector<int>& free) {
  constexpr double seen = 1e-10;  // smaller pivots of columns of length one are round-off of the data
  const MatrixXd J = equations.jacobian(x);
  MatrixXd A(J.rows(), free.size());
  VectorXd length(free.size());
  for (std::size_t k = 0; k < free.size(); ++k) {
    length[k] = J.col(free[k]).norm();
    A.col(k) = length[k] > 0 ? VectorXd(J.col(free[k]) / length[k]) : VectorXd::Zero(J.rows());
  }
  Eigen::CompleteOrthogonalDecomposition<MatrixXd> least(A.rows(), A.cols());
  least.setThreshold(seen);
  least.compute(A);
  const VectorXd y = least.solve(-equations.residual(x));
  Step s;
  s.undetermined = static_cast<int>(free.size() - least.rank());
  for (std::size_t k = 0; k < free.size(); ++k)
    if (length[k] > 0) s.d[free[k]] = y[k] / length[k];
  return s;
}

/// Gauss-Newton, a step that does not help is halved; returns the directions that are not determined.
int minimise(const Equations& equations, const std::vector<int>& free, Vector4d& x, int& iterations) {
  constexpr int most = 50;
  int undetermined = 0;
  double now = equations.residual(x).squaredNorm();
  for (int i = 0; i < most && !free.empty(); ++i, ++iterations) {
    const Step s = step(equations, x, free);
    undetermined = s.undetermined;
    double share = 1, then = now;
    for (; share > 1e-4; share *= 0.5)
      if (then = equations.residual(x + share * s.d).squaredNorm(); then <= now) break;
    if (!(then <= now)) break;
    x += share * s.d;
    const bool done = now - then <= 1e-14 * now;
    now = then;
    if (done) break;
  }
  return undetermined;
}

}  // namespace

VesselFit fit_vessel(const EndsOfVessel& ends, const VesselParameters& start,
                     const VesselFitOptions& options) {
  const Equations equations(ends, options.balanced);
  Vector4d x(start.R, options.compliance ? start.C : 0, start.L, options.stenosis ? start.S : 0);
  std::vector<int> free{R, L};
  if (options.stenosis) free.push_back(S);
  VesselFit fit;
  // the linear answers: R, L, S of the first equation with C = 0, then C of the second
  const double C_start = x[C];
  x[C] = 0;
  minimise(equations, free, x, fit.iterations);
  x[C] = C_start;
  if (options.compliance) {
    minimise(equations, {C}, x, fit.iterations);
    free.push_back(C);
  }
  fit.undetermined = minimise(equations, free, x, fit.iterations);
  for (int bound : {C, L}) {
    if (x[bound] >= 0) continue;
    x[bound] = 0;
    std::erase(free, bound);
    fit.undetermined = minimise(equations, free, x, fit.iterations);
  }
  fit.parameters = {x[R], x[C], x[L], x[S]};
  fit.residual = std::sqrt(equations.residual(x).squaredNorm() / static_cast<double>(equations.rows()));
  return fit;
}

}  // namespace ostium::network
