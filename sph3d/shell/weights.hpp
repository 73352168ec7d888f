/// Reference gradients and hourglass weights of one particle (docs/theory/shell.md, sections "Gradients", "Zigzags").
///
///   gradient    g_b,  sum_b g_b xi_b = I                               1/m
///   hourglass   p_b,  sum_b p_b xi_b = 0, sum_b p_b xi_b xi_b = 0      -
///
/// p is what remains of a hat function when its quadratic part, fitted with the hat as weight, has been taken away: it
/// sees nothing of a field that is quadratic over the support, and the most of a zigzag.
#pragma once
#include <vector>

#include "sph3d/shell/block.hpp"
#include "sph3d/shell/reduced_kernel.hpp"

namespace ostium::sph3d {

/// A neighbour in the tangent plane.
template <int D>
struct TangentPoint {
  Eigen::Matrix<double, D - 1, 1> xi;  ///< m
  double distance, area;               ///< the chord, m; m^(D-1)
  bool beyond_clamp = false;           ///< on the other side of a clamp: no part of the hourglass weights
};

/// False where the moment matrix had to be guarded.
template <int D>
bool pair_weights(const std::vector<TangentPoint<D>>& around, const ReducedKernel<D>& kernel,
                  double least_moment, ShellWeight<D>* out);

/// Rows e_a: tangents that form a right-handed frame with the normal.
template <int D>
Eigen::Matrix<double, D - 1, D> tangent_frame(const Vec<D>& normal);

}  // namespace ostium::sph3d
