#include "sph3d/shell/circumference.hpp"

#include <algorithm>
#include <cmath>

#include "sph3d/shell/weights.hpp"

namespace ostium::sph3d {

namespace {

using Frame = Eigen::Matrix<double, 2, 3>;
using Tensor = Eigen::Matrix3d;

/// What a point itself knows of its direction.
Tensor own_direction(const Frame& e, const Bending<3>& S) {
  const double half = 0.5 * (S(0, 0) - S(1, 1)), apart = std::hypot(half, S(0, 1)), mean = 0.5 * S.trace();
  Bending<3> q;
  q << half, S(0, 1), S(0, 1), -half;
  // |k1| + |k2| of k = mean +- apart
  return e.transpose() * q * e / std::max({apart, std::abs(mean), 1e-300});
}

/// The traceless part of Q in the tangent plane.
Tensor laid_into(const Frame& e, const Tensor& Q) {
  Bending<3> q = e * Q * e.transpose();
  q -= 0.5 * q.trace() * Bending<3>::Identity();
  return e.transpose() * q * e;
}

}  // namespace

std::vector<Vec3> circumference(const SurfaceAverage<3>& average, const std::vector<Vec3>& normal,
                                const std::vector<Bending<3>>& bending, const std::vector<double>& thickness,
                                double spacing) {
  const std::size_t n = normal.size();
  std::vector<Frame> frame(n);
  std::vector<Tensor> Q(n), next(n);
  double length = 2.0 * spacing;
  for (std::size_t a = 0; a < n; ++a) {
    frame[a] = tangent_frame<3>(normal[a]);
    Q[a] = own_direction(frame[a], bending[a]);
    length = std::max(length, thickness[a]);
  }
  const int passes = static_cast<int>(std::ceil(length * length / average.variance()));
  for (int pass = 0; pass < passes; ++pass) {
#pragma omp parallel for schedule(static)
    for (std::size_t a = 0; a < n; ++a) next[a] = laid_into(frame[a], average(Q, a));
    Q.swap(next);
  }
  std::vector<Vec3> around(n);
  for (std::size_t a = 0; a < n; ++a) {
    const Bending<3> q = frame[a] * Q[a] * frame[a].transpose();
    around[a] = frame[a].transpose() * Eigen::SelfAdjointEigenSolver<Bending<3>>(q).eigenvectors().col(1);
  }
  return around;
}

}  // namespace ostium::sph3d
