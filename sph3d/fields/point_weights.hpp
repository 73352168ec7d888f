/// Weighted sums that carry fields from one set of points to another, and how they are chosen on a wall.
///
///   f_i = sum_b w_ib f_b
///
///   smoothing   w_ab = W(x_a - x_b) A_a / sum_c W(x_c - x_b) A_c    of the forces F_b: their sum is kept
///   mapping     w_ib ~ W(x_i - x_b) (1 - slope . (x_b - x_i)), sum 1: exact for fields that are linear along the wall
///
///   W     kernel of the surface (shell/reduced_kernel.hpp)
///   A_a   area of the point, m^(D-1)
///
/// Only points whose normals are within 60 degrees take part, so that walls which face each other do not mix. Source:
/// docs/theory/walls.md, "Wall fields".
#pragma once
#include <cstdint>
#include <vector>

#include "sph3d/geometry/sample.hpp"

namespace ostium::sph3d {

struct PointWeights {
  struct Entry {
    std::int32_t index;
    float weight;
  };
  std::vector<std::int64_t> begin{0};  // of each receiving point, and the end
  std::vector<Entry> entry;

  std::size_t count() const { return begin.size() - 1; }
  /// Of receiving point i; `zero` where no point is near.
  template <class T>
  T at(std::size_t i, const std::vector<T>& from, T zero) const {
    for (auto n = begin[i]; n < begin[i + 1]; ++n) zero += double(entry[n].weight) * from[entry[n].index];
    return zero;
  }
};

/// h: smoothing length, m.
template <int D>
PointWeights smoothing_weights(const std::vector<WallPoint<D>>& wall, double h);

/// Onto points with unit normals; a zero normal takes whatever is near. The kernel is widened where fewer than D points are near.
template <int D>
PointWeights mapping_weights(const std::vector<WallPoint<D>>& wall, const std::vector<Vec<D>>& points,
                             const std::vector<Vec<D>>& normals, double h);

}  // namespace ostium::sph3d
