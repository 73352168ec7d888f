#include "sph3d/shell/surface_bending.hpp"

#include "sph3d/shell/reduced_kernel.hpp"
#include "sph3d/shell/surface_pairs.hpp"
#include "sph3d/shell/weights.hpp"

namespace ostium::sph3d {

namespace {

constexpr double smoothing = 1.15;  // h over the spacing, that of the shell

template <int D>
using Tensor = Eigen::Matrix<double, D - 1, D - 1>;

template <int D>
std::vector<Vec<D>> smoothed_once(const SurfacePoints<D>& p, const std::vector<Vec<D>>& normal,
                                  const SurfacePairs<D>& pairs, const ReducedKernel<D>& kernel) {
  std::vector<Vec<D>> mean(normal.size());
  for (std::size_t a = 0; a < normal.size(); ++a) {
    Vec<D> sum = kernel.value(0.0) * p.area[a] * normal[a];
    for (const auto [b, rim] : pairs.of(a))
      sum += kernel.value((p.position[a] - p.position[b]).norm()) * p.area[b] * normal[b];
    mean[a] = sum.normalized();
  }
  return mean;
}

/// The inverse of M; a point that sees too little has no gradient.
template <int D>
Tensor<D> inverse(const Tensor<D>& M) {
  const Eigen::SelfAdjointEigenSolver<Tensor<D>> eigen(M);
  auto values = eigen.eigenvalues();
  for (auto& v : values) v = v > 0.05 ? 1.0 / v : 0.0;
  return eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
}

}  // namespace

template <int D>
std::vector<Vec<D>> smoothed_normals(const SurfacePoints<D>& p, double spacing) {
  const ReducedKernel<D> kernel{smoothing * spacing};
  const SurfacePairs<D> pairs(p.position, p.normal, {}, kernel.reach());
  return smoothed_once(p, smoothed_once(p, p.normal, pairs, kernel), pairs, kernel);
}

template <int D>
std::vector<Curvatures<D>> curvatures(const SurfacePoints<D>& p, const std::vector<Vec<D>>& normal,
                                      double spacing) {
  const ReducedKernel<D> kernel{smoothing * spacing};
  const SurfacePairs<D> pairs(p.position, normal, {}, kernel.reach());
  std::vector<Curvatures<D>> found(normal.size());
  for (std::size_t a = 0; a < normal.size(); ++a) {
    const auto e = tangent_frame<D>(normal[a]);
    Tensor<D> M = Tensor<D>::Zero(), turn = Tensor<D>::Zero();
    for (const auto [b, rim] : pairs.of(a)) {
      const Vec<D> apart = p.position[b] - p.position[a];
      const Eigen::Matrix<double, D - 1, 1> xi = e * apart, dn = e * (normal[b] - normal[a]);
      const double w = kernel.pull(apart.norm()) * p.area[b];
      M += w * xi * xi.transpose(), turn += w * dn * xi.transpose();
    }
    const Tensor<D> S = turn * inverse<D>(M);
    found[a] = Eigen::SelfAdjointEigenSolver<Tensor<D>>(0.5 * (S + S.transpose())).eigenvalues();
  }
  return found;
}

template std::vector<Vec<2>> smoothed_normals(const SurfacePoints<2>&, double);
template std::vector<Vec<3>> smoothed_normals(const SurfacePoints<3>&, double);
template std::vector<Curvatures<2>> curvatures(const SurfacePoints<2>&, const std::vector<Vec<2>>&, double);
template std::vector<Curvatures<3>> curvatures(const SurfacePoints<3>&, const std::vector<Vec<3>>&, double);

}  // namespace ostium::sph3d
