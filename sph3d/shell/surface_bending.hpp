/// Normals and curvatures of a cloud of points on a surface. Internal to shell/.
///
///   n_a = sum_b W_ab n_b / |...|      (twice),  b = a included
///   k   = eigenvalues of sym(e S e^T),  S = sum_b (n_b - n_a) (x) g_ab,  g = M^-1 w xi as in model.hpp
///
/// Positive curvature: the normals part. One-sided sums at a rim are corrected by M.
#pragma once
#include "sph3d/shell/surface_points.hpp"

namespace ostium::sph3d {

template <int D>
using Curvatures = Eigen::Matrix<double, D - 1, 1>;

/// The normals of the facets, smoothed.
template <int D>
std::vector<Vec<D>> smoothed_normals(const SurfacePoints<D>& points, double spacing);

/// Ascending.
template <int D>
std::vector<Curvatures<D>> curvatures(const SurfacePoints<D>& points, const std::vector<Vec<D>>& normal,
                                      double spacing);

}  // namespace ostium::sph3d
