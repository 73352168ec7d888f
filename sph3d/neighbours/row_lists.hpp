/// Neighbour rows: for each cluster of eight, every particle within reach of any of the eight.
///
/// Rebuilt from scratch when positions are frozen: the particles are binned on a grid of half the reach, and
/// each cluster filters the bins around it exactly. Rows are in grid order, so a sum over them is the same
/// for any number of threads. Coordinates are those of the records (over the reach, so the reach is 1).
/// Particles with w = 0 (empty places) are left out; odd lists are padded with the index `none`.
#pragma once
#include <cstdint>
#include <vector>

#include "sph3d/fluid/cluster.hpp"

namespace ostium::sph3d {

template <int D>
class RowLists {
 public:
  /// place has 8 * clusters.size() entries and one more, an empty one, whose index is `none`.
  void build(const std::vector<Cluster<D>>& clusters, const std::vector<PlaceRecord>& place);

  const Rows* data() const { return rows_.data(); }
  const Rows& operator[](std::size_t cluster) const { return rows_[cluster]; }
  double mean_length() const;
  std::size_t bytes() const;

 private:
  struct Grid {
    float origin[D];
    int cells[D];
    std::vector<std::int32_t> first;  // of each cell, then the end
    std::vector<std::int32_t> index;  // particles by cell
    std::vector<PlaceRecord> place;   // their records in that order
  };
  void bin(const std::vector<PlaceRecord>& place);
  void find_stretches(const Cluster<D>& cluster, const PlaceRecord* own,
                      std::vector<Stretch>& stretches) const;

  Grid grid_;
  std::vector<std::int32_t> cell_;
  std::vector<std::vector<std::int32_t>> storage_;  // one per thread
  std::vector<Rows> rows_;
};

extern template class RowLists<2>;
extern template class RowLists<3>;

}  // namespace ostium::sph3d
