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

template <int D>
bool within_reach(const Cluster<D>& cluster, const Box<D>& box, const PlaceRecord& j) {
  const float* p = &j.x;
  float outside2 = 0;
  for (int d = 0; d < D; ++d) {
    const float o = std::max({box.low[d] - p[d], p[d] - box.high[d], 0.0f});
    outside2 += o * o;
  }
  if (outside2 >= 1.0f) return false;
  float r2[8];
  for (int lane = 0; lane < 8; ++lane) {
    const float dx = cluster.x[0][lane] - p[0], dy = cluster.x[1][lane] - p[1];
    r2[lane] = dx * dx + dy * dy;
    if constexpr (D == 3) {
      const float dz = cluster.x[2][lane] - p[2];
      r2[lane] += dz * dz;
    }
  }
  float least = r2[0];
  for (int lane = 1; lane < 8; ++lane) least = r2[lane] < least ? r2[lane] : least;
  return least < 1.0f;
}

}  // namespace

template <int D>
void RowLists<D>::bin(const std::vector<PlaceRecord>& place) {
  const std::size_t n = place.size() - 1;
  float high[D];
  for (int d = 0; d < D; ++d) {
    grid_.origin[d] = std::numeric_limits<float>::max();
    high[d] = std::numeric_limits<float>::lowest();
  }
  for (std::size_t i = 0; i < n; ++i)
    if (place[i].w != 0.0f)
      for (int d = 0; d < D; ++d) {
        const float x = (&place[i].x)[d];
        grid_.origin[d] = std::min(grid_.origin[d], x);
        high[d] = std::max(high[d], x);
      }
  std::size_t cells = 1;
  for (int d = 0; d < D; ++d) {
    grid_.cells[d] = std::max(1, static_cast<int>((high[d] - grid_.origin[d]) / cell_size) + 1);
    cells *= grid_.cells[d];
  }
  grid_.first.assign(cells + 1, 0);
  cell_.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    cell_[i] = -1;
    if (place[i].w == 0.0f) continue;
    std::int32_t cell = 0;
    for (int d = D - 1; d >= 0; --d)
      cell = cell * grid_.cells[d] + static_cast<int>(((&place[i].x)[d] - grid_.origin[d]) / cell_size);
    cell_[i] = cell;
    ++grid_.first[cell + 1];
  }
  for (std::size_t c = 0; c < cells; ++c) grid_.first[c + 1] += grid_.first[c];
  grid_.index.resize(grid_.first[cells]);
  std::vector<std::int32_t> next(grid_.first.begin(), grid_.first.end() - 1);
  for (std::size_t i = 0; i < n; ++i)
    if (cell_[i] >= 0) grid_.index[next[cell_[i]]++] = static_cast<std::int32_t>(i);
}

template <int D>
void RowLists<D>::build(const std::vector<Cluster<D>>& clusters, const std::vector<PlaceRecord>& place) {
  bin(place);
  const std::int64_t count = static_cast<std::int64_t>(clusters.size());
  const auto none = static_cast<std::int32_t>(place.size() - 1);
  rows_.resize(clusters.size());
  storage_.resize(omp_get_max_threads());
#pragma omp parallel
  {
    const int threads = omp_get_num_threads(), me = omp_get_thread_num();
    const std::int64_t begin = count * me / threads, end = count * (me + 1) / threads;
    std::vector<std::int32_t>& list = storage_[me];
    list.clear();
    std::vector<std::size_t> offset;
    offset.reserve(end - begin + 1);
    for (std::int64_t c = begin; c < end; ++c) {
      offset.push_back(list.size());
      const Box<D> box = bounds(clusters[c], &place[8 * c]);
      if (box.low[0] > box.high[0]) continue;
      int low[3] = {0, 0, 0}, high[3] = {0, 0, 0};
      for (int d = 0; d < D; ++d) {
        low[d] = std::max(0, static_cast<int>(std::floor((box.low[d] - 1.0f - grid_.origin[d]) / cell_size)));
        high[d] = std::min(grid_.cells[d] - 1,
                           static_cast<int>((box.high[d] + 1.0f - grid_.origin[d]) / cell_size));
      }
      for (int k = low[2]; k <= high[2]; ++k)
        for (int j = low[1]; j <= high[1]; ++j) {
          const std::size_t line =
              (static_cast<std::size_t>(D == 3 ? k * grid_.cells[1] : 0) + j) * grid_.cells[0];
          for (std::int32_t n = grid_.first[line + low[0]]; n < grid_.first[line + high[0] + 1]; ++n)
            if (within_reach(clusters[c], box, place[grid_.index[n]])) list.push_back(grid_.index[n]);
        }
      if ((list.size() - offset.back()) % 2) list.push_back(none);
    }
    offset.push_back(list.size());
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
