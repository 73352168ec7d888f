#include "sph3d/neighbours/row_lists.hpp"

#include <omp.h>

#include <algorithm>
#include <limits>

#include "core/large_pages.hpp"

namespace ostium::sph3d {

namespace {

constexpr float wide_cluster = 2.0f, wide_group = 3.0f;  // extents, over the reach, of what is not compact
constexpr std::size_t read_ahead = 4;  // entries past its end that a sum over a row may read
constexpr float largest = std::numeric_limits<float>::max();

template <int D>
Box<D> box_of(const Boxes<D>& boxes, int lane) {
  Box<D> box;
  for (int d = 0; d < D; ++d) box.low[d] = boxes.low[d][lane], box.high[d] = boxes.high[d][lane];
  return box;
}

template <int D>
void set_box(Boxes<D>& boxes, int lane, const Box<D>& box) {
  for (int d = 0; d < D; ++d) boxes.low[d][lane] = box.low[d], boxes.high[d][lane] = box.high[d];
}

template <int D>
Box<D> nothing() {
  Box<D> box;
  for (int d = 0; d < D; ++d) box.low[d] = largest, box.high[d] = -largest;
  return box;
}

/// Around all eight.
template <int D>
Box<D> hull(const Boxes<D>& boxes) {
  Box<D> box;
  for (int d = 0; d < D; ++d) {
    box.low[d] = *std::min_element(boxes.low[d], boxes.low[d] + 8);
    box.high[d] = *std::max_element(boxes.high[d], boxes.high[d] + 8);
  }
  return box;
}

template <int D>
bool empty(const Box<D>& box) {
  return box.low[0] > box.high[0];
}

template <int D>
bool wider(const Box<D>& box, float limit) {
  for (int d = 0; d < D; ++d)
    if (box.high[d] - box.low[d] > limit) return true;
  return false;
}

}  // namespace

/// Points and box of every cluster, and the tree above them.
template <int D>
void RowLists<D>::bound(const std::vector<Cluster<D>>& clusters) {
  const std::size_t n = clusters.size();
  resize_in_large_pages(points_, n);
  std::size_t eights = (n + 7) / 8, height = 1;
  for (std::size_t m = eights; m > 1; m = (m + 7) / 8) ++height;
  levels_.resize(height);
  for (auto& level : levels_) level.resize(eights), eights = (eights + 7) / 8;
#pragma omp parallel for schedule(static)
  for (std::size_t g = 0; g < levels_[0].size(); ++g) {
    for (std::size_t c = n; c < 8 * g + 8; ++c) set_box(levels_[0][g], static_cast<int>(c % 8), nothing<D>());
    fluid_kernels<D>().bound(8 * g, std::min(8 * g + 8, n), clusters.data(), points_.data(),
                             levels_[0].data());
  }
  for (std::size_t l = 1; l < height; ++l)
    for (std::size_t k = 0; k < 8 * levels_[l].size(); ++k)
      set_box(levels_[l][k / 8], static_cast<int>(k % 8),
              k < levels_[l - 1].size() ? hull(levels_[l - 1][k]) : nothing<D>());
}

/// One thread's way through the tree.
template <int D>
class RowLists<D>::Search {
 public:
  explicit Search(const RowLists& lists) : lists_(lists) {}

  /// The clusters whose particles may be within reach of cluster c; group by group.
  const std::vector<std::int32_t>& candidates(const Cluster<D>& cluster, std::size_t c) {
    const Box<D> box = box_of(lists_.levels_[0][c / 8], static_cast<int>(c % 8));
    clusters_.clear();
    if (empty(box)) return clusters_;
    if (wider(box, wide_cluster)) {
      for (int lane = 0; lane < 8; ++lane) add_around(cluster, lane);
      std::sort(clusters_.begin(), clusters_.end());
      clusters_.erase(std::unique(clusters_.begin(), clusters_.end()), clusters_.end());
      return clusters_;
    }
    if (c / 8 != group_ || !compact_) find_groups(c / 8, box);
    step(box, 0, groups_, clusters_);
    return clusters_;
  }

 private:
  /// Those of the boxes of one level, eight by eight, that are within reach.
  void step(const Box<D>& box, std::size_t level, const std::vector<std::int32_t>& eights,
            std::vector<std::int32_t>& out) const {
    const std::size_t before = out.size();
    out.resize(before + 8 * eights.size());
    const std::int32_t found =
        kernels_.boxes_within_reach(box, lists_.levels_[level].data(), eights.data(),
                                    static_cast<std::int32_t>(eights.size()), out.data() + before);
    out.resize(before + found);
  }

  /// Leaves in groups_ the groups of clusters within reach of a box.
  void descend(const Box<D>& box) {
    groups_.assign(1, 0);
    for (std::size_t level = lists_.levels_.size() - 1; level > 0; --level) {
      next_.clear();
      step(box, level, groups_, next_);
      std::swap(groups_, next_);
    }
  }

  void find_groups(std::size_t group, const Box<D>& cluster) {
    const Box<D> whole = hull(lists_.levels_[0][group]);
    compact_ = !wider(whole, wide_group);
    group_ = group;
    descend(compact_ ? whole : cluster);
  }

  void add_around(const Cluster<D>& cluster, int lane) {
    if (cluster.x[0][lane] >= far_away) return;
    Box<D> point;
    for (int d = 0; d < D; ++d) point.low[d] = point.high[d] = cluster.x[d][lane];
    descend(point);
    compact_ = false;
    step(point, 0, groups_, clusters_);
  }

  const RowLists& lists_;
  const FluidKernels<D>& kernels_ = fluid_kernels<D>();
  std::vector<std::int32_t> groups_, next_, clusters_;
  std::size_t group_ = static_cast<std::size_t>(-1);  // whose way down groups_ is, if that is compact
  bool compact_ = false;
};

template <int D>
void RowLists<D>::build(const std::vector<Cluster<D>>& clusters) {
  bound(clusters);
  const std::int64_t count = static_cast<std::int64_t>(clusters.size());
  const auto none = static_cast<std::int32_t>(8 * clusters.size());
  const auto& kernels = fluid_kernels<D>();
  rows_.resize(clusters.size());
  storage_.resize(omp_get_max_threads());
#pragma omp parallel
  {
    const int threads = omp_get_num_threads(), me = omp_get_thread_num();
    const std::int64_t begin = count * me / threads, end = count * (me + 1) / threads;
    std::vector<std::int32_t>& list = storage_[me];
    std::vector<std::size_t> offset;
    offset.reserve(end - begin + 1);
    Search search(*this);
    std::size_t size = 0;
    for (std::int64_t c = begin; c < end; ++c) {
      offset.push_back(size);
      const auto& candidates = search.candidates(clusters[c], c);
      const std::size_t most = 8 * candidates.size() + read_ahead;
      if (list.size() < size + most) resize_in_large_pages(list, 2 * (size + most));
      size += kernels.within_reach(clusters[c], box(c), points_.data(), candidates.data(),
                                   static_cast<std::int32_t>(candidates.size()), list.data() + size);
    }
    offset.push_back(size);
    list.resize(std::max(list.size(), size + read_ahead));
    std::fill_n(list.data() + size, read_ahead, none);
    for (std::int64_t c = begin; c < end; ++c)
      rows_[c] = {list.data() + offset[c - begin],
                  static_cast<std::int32_t>(offset[c - begin + 1] - offset[c - begin])};
  }
}

template <int D>
Box<D> RowLists<D>::box(std::size_t cluster) const {
  return box_of(levels_[0][cluster / 8], static_cast<int>(cluster % 8));
}

template <int D>
Box<D> RowLists<D>::group_box(std::size_t group) const {
  return hull(levels_[0][group]);
}

template <int D>
double RowLists<D>::mean_length() const {
  double sum = 0;
  for (const Rows& r : rows_) sum += r.count;
  return rows_.empty() ? 0.0 : sum / static_cast<double>(rows_.size());
}

template <int D>
std::size_t RowLists<D>::bytes() const {
  std::size_t sum = rows_.capacity() * sizeof(Rows) + points_.capacity() * sizeof(Points<D>);
  for (const auto& level : levels_) sum += level.capacity() * sizeof(Boxes<D>);
  for (const auto& list : storage_) sum += list.capacity() * sizeof(std::int32_t);
  return sum;
}

template class RowLists<2>;
template class RowLists<3>;

}  // namespace ostium::sph3d
