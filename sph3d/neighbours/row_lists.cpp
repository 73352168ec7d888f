#include "sph3d/neighbours/row_lists.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ostium::sph3d {

namespace {

constexpr float cell_size = 0.5f;

template <int D>
struct Box {
  float low[D], high[D];
};

template <int D>
Box<D> bounds(const Cluster<D>& cluster, const PlaceRecord* own) {
  Box<D> box;
  for (int d = 0; d < D; ++d) {
    box.low[d] = std::numeric_limits<float>::max();
    box.high[d] = std::numeric_limits<float>::lowest();
    for (int lane = 0; lane < 8; ++lane)
      if (own[lane].w != 0.0f) {
        box.low[d] = std::min(box.low[d], cluster.x[d][lane]);
        box.high[d] = std::max(box.high[d], cluster.x[d][lane]);
      }
  }
  return box;
}

/// Lower and upper corner of everything that is there.
template <int D>
Box<D> bounds(const std::vector<PlaceRecord>& place) {
  Box<D> box;
  std::fill(box.low, box.low + D, std::numeric_limits<float>::max());
  std::fill(box.high, box.high + D, std::numeric_limits<float>::lowest());
#pragma omp parallel
  {
    Box<D> mine = box;
#pragma omp for schedule(static) nowait
    for (std::size_t i = 0; i < place.size(); ++i)
      for (int d = 0; d < D && place[i].w != 0.0f; ++d) {
        mine.low[d] = std::min(mine.low[d], (&place[i].x)[d]);
        mine.high[d] = std::max(mine.high[d], (&place[i].x)[d]);
      }
#pragma omp critical
    for (int d = 0; d < D; ++d) {
      box.low[d] = std::min(box.low[d], mine.low[d]);
      box.high[d] = std::max(box.high[d], mine.high[d]);
    }
  }
  return box;
}

}  // namespace

template <int D>
void RowLists<D>::bin(const std::vector<PlaceRecord>& place) {
  const std::size_t n = place.size() - 1;
  const Box<D> box = bounds<D>(place);
  std::size_t cells = 1;
  for (int d = 0; d < D; ++d) {
    grid_.origin[d] = box.low[d];
    grid_.cells[d] = std::max(1, static_cast<int>((box.high[d] - box.low[d]) / cell_size) + 1);
    cells *= grid_.cells[d];
  }
  cell_.resize(n);
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < n; ++i) {
    std::int32_t cell = place[i].w == 0.0f ? -1 : 0;
    for (int d = D - 1; d >= 0 && cell >= 0; --d)
      cell = cell * grid_.cells[d] + static_cast<int>(((&place[i].x)[d] - grid_.origin[d]) / cell_size);
    cell_[i] = cell;
  }
  grid_.first.assign(cells + 1, 0);
  for (const std::int32_t cell : cell_) ++grid_.first[cell + 1];  // the empty ones at 0, taken back at once
  grid_.first[0] = 0;
  for (std::size_t c = 0; c < cells; ++c) grid_.first[c + 1] += grid_.first[c];
  grid_.index.resize(grid_.first[cells]);
  std::vector<std::int32_t> next(grid_.first.begin(), grid_.first.end() - 1);
  for (std::size_t i = 0; i < n; ++i)
    if (cell_[i] >= 0) grid_.index[next[cell_[i]]++] = static_cast<std::int32_t>(i);
  grid_.place.resize(grid_.index.size());
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < grid_.index.size(); ++k) grid_.place[k] = place[grid_.index[k]];
}

/// Lines of cells along the first axis that come within reach of the cluster's box, and the stretch of each that does.
template <int D>
void RowLists<D>::find_stretches(const Cluster<D>& cluster, const PlaceRecord* own,
                                 std::vector<Stretch>& stretches) const {
  stretches.clear();
  const Box<D> box = bounds(cluster, own);
  if (box.low[0] > box.high[0]) return;
  const auto cell = [&](int d, float x) {
    return std::min(static_cast<int>(std::max(x - grid_.origin[d], 0.0f) / cell_size), grid_.cells[d] - 1);
  };
  const auto outside = [&](int d, int c) {  // distance between the box and the cells c of direction d
    const float low = grid_.origin[d] + cell_size * c;
    return std::max({0.0f, low - box.high[d], box.low[d] - low - cell_size});
  };
  const int k_low = D == 3 ? cell(D - 1, box.low[D - 1] - 1) : 0,
            k_high = D == 3 ? cell(D - 1, box.high[D - 1] + 1) : 0;
  for (int k = k_low; k <= k_high; ++k) {
    const float away_k = D == 3 ? outside(D - 1, k) : 0.0f;
    for (int j = cell(1, box.low[1] - 1); j <= cell(1, box.high[1] + 1); ++j) {
      const float away_j = outside(1, j), left = 1.001f - away_k * away_k - away_j * away_j;
      if (left <= 0.0f) continue;
      const float along = std::sqrt(left);
      const std::size_t line =
          (static_cast<std::size_t>(D == 3 ? k * grid_.cells[1] : 0) + j) * grid_.cells[0];
      const Stretch stretch{grid_.first[line + cell(0, box.low[0] - along)],
                            grid_.first[line + cell(0, box.high[0] + along) + 1]};
      if (stretch.begin < stretch.end) stretches.push_back(stretch);
    }
  }
}

template <int D>
void RowLists<D>::build(const std::vector<Cluster<D>>& clusters, const std::vector<PlaceRecord>& place) {
  bin(place);
  const std::int64_t count = static_cast<std::int64_t>(clusters.size());
  const auto none = static_cast<std::int32_t>(place.size() - 1);
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
    std::vector<Stretch> stretches;
    std::size_t size = 0;
    for (std::int64_t c = begin; c < end; ++c) {
      offset.push_back(size);
      find_stretches(clusters[c], &place[8 * c], stretches);
      std::size_t candidates = 2;
      for (const Stretch& s : stretches) candidates += s.end - s.begin;
      if (list.size() < size + candidates) list.resize(2 * (size + candidates));
      size += kernels.within_reach(clusters[c], grid_.place.data(), grid_.index.data(), stretches.data(),
                                   static_cast<std::int32_t>(stretches.size()), list.data() + size);
      if ((size - offset.back()) % 2) list[size++] = none;
    }
    offset.push_back(size);
    for (std::int64_t c = begin; c < end; ++c)
      rows_[c] = {list.data() + offset[c - begin],
                  static_cast<std::int32_t>(offset[c - begin + 1] - offset[c - begin])};
  }
}

template <int D>
double RowLists<D>::mean_length() const {
  double sum = 0;
  for (const Rows& r : rows_) sum += r.count;
  return rows_.empty() ? 0.0 : sum / static_cast<double>(rows_.size());
}

template <int D>
std::size_t RowLists<D>::bytes() const {
  std::size_t sum = rows_.capacity() * sizeof(Rows) +
                    (grid_.first.capacity() + grid_.index.capacity() + cell_.capacity()) * 4;
  for (const auto& list : storage_) sum += list.capacity() * sizeof(std::int32_t);
  return sum;
}

template class RowLists<2>;
template class RowLists<3>;

}  // namespace ostium::sph3d
