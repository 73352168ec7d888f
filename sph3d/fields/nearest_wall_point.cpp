#include "sph3d/fields/nearest_wall_point.hpp"

#include <cmath>
#include <limits>

namespace ostium::sph3d {

template <int D>
typename NearestWallPoint<D>::Cell NearestWallPoint<D>::cell_of(const Vec<D>& x) const {
  Cell cell;
  for (int d = 0; d < D; ++d) cell[d] = static_cast<int>(std::floor((x[d] - origin_[d]) / cell_));
  return cell;
}

template <int D>
std::int64_t NearestWallPoint<D>::block_of(const Cell& cell) const {
  std::int64_t block = 0;
  for (int d = D - 1; d >= 0; --d) {
    if (cell[d] < 0 || cell[d] >= edge * blocks_[d]) return -1;
    block = block * blocks_[d] + cell[d] / edge;
  }
  return block;
}

template <int D>
int NearestWallPoint<D>::place_in_block(const Cell& cell) {
  int place = 0;
  for (int d = D - 1; d >= 0; --d) place = place * edge + cell[d] % edge;
  return place;
}

template <int D>
NearestWallPoint<D>::NearestWallPoint(const std::vector<WallPoint<D>>& wall, double spacing, double reach)
    : cell_(0.5 * spacing) {
  // a place within reach of the wall is at most this far from a point, and its cell's middle a little further
  const double furthest = std::hypot(reach, spacing) + 0.5 * std::sqrt(double(D)) * cell_;
  Vec<D> lower = wall.front().position, upper = lower;
  for (const auto& p : wall) lower = lower.cwiseMin(p.position), upper = upper.cwiseMax(p.position);
  const int margin = static_cast<int>(std::ceil(furthest / cell_)) + 1;
  origin_ = lower - Vec<D>::Constant(margin * cell_);
  std::size_t blocks = 1;
  for (int d = 0; d < D; ++d) {
    blocks_[d] = (static_cast<int>((upper[d] - lower[d]) / cell_) + 2 * margin) / edge + 1;
    blocks *= static_cast<std::size_t>(blocks_[d]);
  }
  slot_.assign(blocks, -1);
  std::vector<float> least;  // squared distance, like point_
  const int across = 2 * margin + 1;
  for (std::size_t a = 0; a < wall.size(); ++a) {
    const Cell own = cell_of(wall[a].position);
    for (int k = 0; k < (D == 3 ? across * across * across : across * across); ++k) {
      Cell cell = own;
      Vec<D> apart;
      for (int d = 0, rest = k; d < D; ++d, rest /= across) {
        cell[d] += rest % across - margin;
        apart[d] = wall[a].position[d] - origin_[d] - (cell[d] + 0.5) * cell_;
      }
      if (apart.squaredNorm() > furthest * furthest || apart.dot(wall[a].normal) < -spacing) continue;
      const std::int64_t block = block_of(cell);
      if (block < 0) continue;
      if (slot_[block] < 0) {
        slot_[block] = static_cast<std::int32_t>(point_.size() / block_size);
        point_.resize(point_.size() + block_size, -1);
        least.resize(point_.size(), std::numeric_limits<float>::max());
      }
      const std::size_t at = std::size_t(slot_[block]) * block_size + place_in_block(cell);
      const auto distance2 = static_cast<float>(apart.squaredNorm());
      if (distance2 < least[at]) least[at] = distance2, point_[at] = static_cast<std::int32_t>(a);
    }
  }
}

template <int D>
std::int32_t NearestWallPoint<D>::operator()(const Vec<D>& x) const {
  const Cell cell = cell_of(x);
  const std::int64_t block = block_of(cell);
  if (block < 0 || slot_[block] < 0) return -1;
  return point_[std::size_t(slot_[block]) * block_size + place_in_block(cell)];
}

template class NearestWallPoint<2>;
template class NearestWallPoint<3>;

}  // namespace ostium::sph3d
