/// The wall point next to a place, from a table over the lattice: for every particle near the wall in every step.
///
///   cells of half the spacing of the points, each with the point nearest to its middle that does not look at it from behind;
///   stored in blocks of 8^D where the wall is near
///
/// The answer is that of the middle of the cell, so that another point may be nearer by up to half the diagonal of a cell. Not
/// checked: points further apart than their spacing.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "sph3d/geometry/sample.hpp"

namespace ostium::sph3d {

template <int D>
class NearestWallPoint {
 public:
  /// Answers within `reach` of the wall, m.
  NearestWallPoint(const std::vector<WallPoint<D>>& wall, double spacing, double reach);

  /// Number of the point; -1 where the wall is further than the reach.
  std::int32_t operator()(const Vec<D>& x) const;

 private:
  static constexpr int edge = 8, block_size = D == 2 ? edge * edge : edge * edge * edge;
  using Cell = std::array<int, D>;

  Cell cell_of(const Vec<D>& x) const;
  std::int64_t block_of(const Cell& cell) const;  // -1 outside
  static int place_in_block(const Cell& cell);

  double cell_;
  Vec<D> origin_;
  Cell blocks_{};
  std::vector<std::int32_t> slot_;   // of each block; -1: not stored
  std::vector<std::int32_t> point_;  // slot after slot
};

extern template class NearestWallPoint<2>;
extern template class NearestWallPoint<3>;

}  // namespace ostium::sph3d
