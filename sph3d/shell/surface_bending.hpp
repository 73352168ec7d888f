/// How a surface is bent, as a wall of some thickness feels it. Internal to shell/.
///
///   contact normals    averages of the normals of the facets, over the kernel (twice)
///   wall normals       averaged on, over the length t/2 in all: a corner is then bent over 5/4 of the thickness
///   bending            S = sym( sum_b (n_b - n_a) (x) g_ab ) in the frame of n_a,  g = M^-1 w xi as in model.hpp
///   opening            f = 1 + k t/2, k the least eigenvalue of S: distances half a thickness further out over those here
///
/// Positive curvature: the normals part. One-sided sums at a rim are corrected by M. Averages of normals leave spheres and
/// cylinders exactly as they are. Where f < `least_opening` normals are averaged on, there and next to there alone, until the
/// outside of the wall does not cross itself or a length of 3/2 t is used up. Source: docs/theory/shell.md, "Shells on surfaces".
#pragma once
#include "sph3d/shell/surface_average.hpp"

namespace ostium::sph3d {

inline constexpr double least_opening = 0.6;

/// Symmetric, in tangent_frame(normal).
template <int D>
using Bending = Eigen::Matrix<double, D - 1, D - 1>;

template <int D>
using Curvatures = Eigen::Matrix<double, D - 1, 1>;

template <int D>
std::vector<Vec<D>> contact_normals(const SurfacePoints<D>& points, const SurfaceAverage<D>& average);

template <int D>
std::vector<Vec<D>> wall_normals(const SurfacePoints<D>& points, const SurfaceAverage<D>& average,
                                 const std::vector<Vec<D>>& contact_normal,
                                 const std::vector<double>& thickness, double spacing);

template <int D>
std::vector<Bending<D>> bending(const SurfacePoints<D>& points, const SurfacePairs<D>& pairs,
                                const std::vector<Vec<D>>& normal, double spacing);

/// Ascending.
template <int D>
Curvatures<D> principal(const Bending<D>& S) {
  return Eigen::SelfAdjointEigenSolver<Bending<D>>(S, Eigen::EigenvaluesOnly).eigenvalues();
}

}  // namespace ostium::sph3d
