#include "sph3d/shell/weights.hpp"

namespace ostium::sph3d {

namespace {

template <int D>
using Tangent = Eigen::Matrix<double, D - 1, 1>;
template <int D>
using TangentMatrix = Eigen::Matrix<double, D - 1, D - 1>;

/// The inverse with eigenvalues of M kept above the least one.
template <int D>
TangentMatrix<D> guarded_inverse(const TangentMatrix<D>& M, double least, bool& exact) {
  const Eigen::SelfAdjointEigenSolver<TangentMatrix<D>> eigen(M);
  Tangent<D> values = eigen.eigenvalues();
  exact = values.minCoeff() >= least;
  for (auto& v : values) v = 1.0 / std::max(v, least);
  return eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
}

/// Linear and quadratic terms, over the reach.
template <int D>
std::vector<double> monomials(const Tangent<D>& xi, double reach) {
  const Tangent<D> x = xi / reach;
  if constexpr (D == 2)
    return {x[0], x[0] * x[0]};
  else
    return {x[0], x[1], x[0] * x[0], x[0] * x[1], x[1] * x[1]};
}

template <int D>
void hourglass_weights(const std::vector<TangentPoint<D>>& around, double reach, ShellWeight<D>* out) {
  constexpr int terms = D == 2 ? 2 : 5;
  const auto n = static_cast<Eigen::Index>(around.size());
  Eigen::MatrixXd fit(n, terms);
  Eigen::VectorXd root(n);
  for (Eigen::Index b = 0; b < n; ++b) {
    const double hat = around[b].beyond_clamp ? 0.0 : 1.0 - around[b].distance / reach;
    root[b] = std::sqrt(std::max(hat, 0.0));
    const auto phi = monomials<D>(around[b].xi, reach);
    for (int k = 0; k < terms; ++k) fit(b, k) = root[b] * phi[k];
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver(fit);
  solver.setThreshold(1e-8);
  const Eigen::VectorXd rest = root - fit * solver.solve(root);
  const double all = std::max(root.squaredNorm(), 1e-300);
  for (Eigen::Index b = 0; b < n; ++b) out[b].hourglass = float(root[b] * rest[b] / all);
}

}  // namespace

template <int D>
bool pair_weights(const std::vector<TangentPoint<D>>& around, const ReducedKernel<D>& kernel,
                  double least_moment, ShellWeight<D>* out) {
  TangentMatrix<D> M = TangentMatrix<D>::Zero();
  for (const auto& b : around) M += kernel.pull(b.distance) * b.area * b.xi * b.xi.transpose();
  bool exact = true;
  const TangentMatrix<D> B = guarded_inverse<D>(M, least_moment, exact);
  for (std::size_t b = 0; b < around.size(); ++b) {
    const Tangent<D> g = kernel.pull(around[b].distance) * around[b].area * B * around[b].xi;
    for (int k = 0; k < D - 1; ++k) out[b].gradient[k] = float(g[k]);
  }
  if (!around.empty()) hourglass_weights<D>(around, kernel.reach(), out);
  return exact;
}

template <int D>
Eigen::Matrix<double, D - 1, D> tangent_frame(const Vec<D>& n) {
  Eigen::Matrix<double, D - 1, D> e;
  if constexpr (D == 2) {
    e.row(0) << n[1], -n[0];
  } else {
    const double sign = std::copysign(1.0, n[2]), a = -1.0 / (sign + n[2]), b = n[0] * n[1] * a;
    e.row(0) << 1.0 + sign * n[0] * n[0] * a, sign * b, -sign * n[0];
    e.row(1) << b, sign + n[1] * n[1] * a, -n[1];
  }
  return e;
}

template bool pair_weights(const std::vector<TangentPoint<2>>&, const ReducedKernel<2>&, double,
                           ShellWeight<2>*);
template bool pair_weights(const std::vector<TangentPoint<3>>&, const ReducedKernel<3>&, double,
                           ShellWeight<3>*);
template Eigen::Matrix<double, 1, 2> tangent_frame<2>(const Vec<2>&);
template Eigen::Matrix<double, 2, 3> tangent_frame<3>(const Vec<3>&);

}  // namespace ostium::sph3d
