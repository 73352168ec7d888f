/// Neighbour rows: for each cluster of eight, every particle within reach of any of the eight.
///
/// Rebuilt from scratch when positions are frozen. The order of memory is a nested bisection, so eight consecutive clusters
/// form a compact group, eight groups a larger one, and so on: a tree of boxes without pointers. A group of clusters goes
/// down that tree once, each of its clusters then tests boxes and at last particles, eight side by side. Clusters that are
/// not compact (particles that came through openings since the last ordering, or two branches in one cluster) go down the
/// tree once for each of their particles. Rows are in the order of memory, so a sum over them is the same for any number of
/// threads. Coordinates are those of the records (over the reach, so the reach is 1). What may be read past the end of a row is
/// the next row, or the index `none`.
#pragma once
#include <cstdint>
#include <vector>

#include "sph3d/fluid/cluster.hpp"

namespace ostium::sph3d {

template <int D>
class RowLists {
 public:
  /// Coordinates of empty places are far_away; the index `none` is that after the last place.
  void build(const std::vector<Cluster<D>>& clusters);

  const Rows* data() const { return rows_.data(); }
  const Rows& operator[](std::size_t cluster) const { return rows_[cluster]; }
  /// Around the particles of a cluster when the rows were built; low above high where it is empty.
  Box<D> box(std::size_t cluster) const;
  /// Around the eight clusters from 8 group on.
  Box<D> group_box(std::size_t group) const;
  double mean_length() const;
  std::size_t bytes() const;

 private:
  class Search;
  void bound(const std::vector<Cluster<D>>& clusters);

  std::vector<Points<D>> points_;  // of each cluster
  std::vector<std::vector<Boxes<D>>>
      levels_;  // of clusters, of groups of eight clusters, and so on up to one eight
  std::vector<std::vector<std::int32_t>> storage_;  // one per thread
  std::vector<Rows> rows_;
};

extern template class RowLists<2>;
extern template class RowLists<3>;

}  // namespace ostium::sph3d
