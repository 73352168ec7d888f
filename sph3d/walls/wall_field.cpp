#include "sph3d/walls/wall_field.hpp"

#include <algorithm>
#include <cmath>

#include "core/large_pages.hpp"

namespace ostium::sph3d {

namespace {

/// Visits every node of a block: f(index within the block, offset per direction).
template <int D, class F>
void for_nodes(int edge, F&& f) {
  int n = 0;
  std::array<int, D> o{};
  for (int k = 0; k < (D == 3 ? edge : 1); ++k)
    for (int j = 0; j < edge; ++j)
      for (int i = 0; i < edge; ++i) {
        o[0] = i, o[1] = j;
        if constexpr (D == 3) o[2] = k;
        f(n++, o);
      }
}

}  // namespace

template <int D>
WallField<D>::WallField(const std::function<double(const Vec<D>&)>& phi, const Vec<D>& lower,
                        const Vec<D>& upper, const Wendland<D>& kernel, double dp)
    : spacing_(dp / 3.0) {
  const double margin = kernel.reach() + 2.0 * edge * spacing_;
  origin_ = lower.array() - margin;
  std::size_t count = 1;
  for (int d = 0; d < D; ++d) {
    blocks_[d] = static_cast<int>(std::ceil((upper[d] - lower[d] + 2.0 * margin) / (edge * spacing_)));
    count *= blocks_[d];
  }
  block_of_.assign(count, all_wall);
  find_blocks(phi, kernel.reach());
  const auto fraction = fractions(phi);
  convolve(fraction, kernel);
  sharpen();
  find_felt();
  widen_rows();
}

template <int D>
auto WallField<D>::first_node(std::size_t block) const -> Index {
  Index node;
  for (int d = 0; d < D; ++d) {
    node[d] = static_cast<int>(block % blocks_[d]) * edge;
    block /= blocks_[d];
  }
  return node;
}

template <int D>
Vec<D> WallField<D>::position(const Index& node) const {
  Vec<D> x;
  for (int d = 0; d < D; ++d) x[d] = origin_[d] + node[d] * spacing_;
  return x;
}

template <int D>
void WallField<D>::find_blocks(const std::function<double(const Vec<D>&)>& phi, double reach) {
  const double radius = 0.5 * edge * spacing_ * std::sqrt(D);
  const double band =
      reach + radius + 2.0 * spacing_;  // a node whose support reaches the wall, or that of a fluid one
#pragma omp parallel for schedule(dynamic, 64)
  for (std::size_t b = 0; b < block_of_.size(); ++b) {
    const Vec<D> centre = position(first_node(b)).array() + 0.5 * (edge - 1) * spacing_;
    const double distance = phi(centre);
    block_of_[b] = std::abs(distance) < band ? 0 : distance < 0.0 ? all_fluid : all_wall;
  }
  for (std::size_t b = 0; b < block_of_.size(); ++b)
    if (block_of_[b] == 0) {
      block_of_[b] = static_cast<std::int32_t>(stored_.size());
      stored_.push_back(b);
    }
}

template <int D>
std::vector<float> WallField<D>::fractions(const std::function<double(const Vec<D>&)>& phi) const {
  std::vector<float> fraction(stored_.size() * block_size);
#pragma omp parallel for schedule(dynamic, 8)
  for (std::size_t slot = 0; slot < stored_.size(); ++slot) {
    const Index first = first_node(stored_[slot]);
    for_nodes<D>(edge, [&](int n, const Index& o) {
      Index node;
      for (int d = 0; d < D; ++d) node[d] = first[d] + o[d];
      fraction[slot * block_size + n] =
          static_cast<float>(std::clamp(0.5 + phi(position(node)) / spacing_, 0.0, 1.0));
    });
  }
  return fraction;
}

template <int D>
std::int32_t WallField<D>::block_at(const Index& node) const {
  std::size_t block = 0;
  for (int d = D - 1; d >= 0; --d) {
    const int b = node[d] >> 3;
    if (node[d] < 0 || b >= blocks_[d]) return all_wall;
    block = block * blocks_[d] + b;
  }
  return block_of_[block];
}

template <int D>
bool WallField<D>::felt_in(const Vec<D>& low, const Vec<D>& high) const {
  constexpr double slack = 1e-3;  // of a cell, for round-off
  Index first, last, node;
  for (int d = 0; d < D; ++d) {
    first[d] = static_cast<int>(std::floor((low[d] - origin_[d]) * nodes_per_length_ - slack)) >> 3;
    last[d] = static_cast<int>(std::floor((high[d] - origin_[d]) * nodes_per_length_ + slack)) >> 3;
    if (last[d] - first[d] > 2) return true;  // not worth the search
  }
  const int deepest = D == 3 ? last[D - 1] - first[D - 1] : 0;
  for (int k = 0; k <= deepest; ++k)
    for (int j = first[1]; j <= last[1]; ++j)
      for (int i = first[0]; i <= last[0]; ++i) {
        node[0] = edge * i, node[1] = edge * j;
        if constexpr (D == 3) node[2] = edge * (first[2] + k);
        const std::int32_t slot = block_at(node);
        if (slot == all_wall || (slot >= 0 && felt_slot_[slot])) return true;
      }
  return false;
}

/// Number of a node, and of the cell above it, within its block.
template <int D>
int WallField<D>::number_of(const Index& node) {
  int n = 0;
  for (int d = D - 1; d >= 0; --d) n = n * edge + (node[d] & (edge - 1));
  return n;
}

template <int D>
float WallField<D>::node_value(const std::vector<float>& values, const Index& node) const {
  const std::int32_t slot = block_at(node);
  if (slot < 0) return slot == all_wall ? 1.0f : 0.0f;
  return values[static_cast<std::size_t>(slot) * block_size + number_of(node)];
}

template <int D>
void WallField<D>::convolve(const std::vector<float>& fraction, const Wendland<D>& kernel) {
  const int m = static_cast<int>(std::ceil(kernel.reach() / spacing_)) - 1;  // stencil half-width
  const int side = 2 * m + 1, padded = edge + 2 * m, layers = D == 3 ? side : 1;
  std::vector<float> stencil(static_cast<std::size_t>(side) * side * layers);
  double total = 0;
  for (int pass = 0; pass < 2; ++pass)
    for (int k = 0; k < layers; ++k)
      for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
          const double r2 = (i - m) * (i - m) + (j - m) * (j - m) + (D == 3 ? (k - m) * (k - m) : 0);
          const double w = kernel.value(std::sqrt(r2) * spacing_);
          if (pass == 0)
            total += w;
          else
            stencil[(static_cast<std::size_t>(k) * side + j) * side + i] = static_cast<float>(w / total);
        }
  values_.assign(stored_.size() * block_size, 0.0f);
#pragma omp parallel
  {
    std::vector<float> around(static_cast<std::size_t>(padded) * padded * (D == 3 ? padded : 1));
#pragma omp for schedule(dynamic, 8)
    for (std::size_t slot = 0; slot < stored_.size(); ++slot) {
      const Index first = first_node(stored_[slot]);
      bool uniform = true;
      for_nodes<D>(padded, [&](int n, const Index& o) {
        Index node;
        for (int d = 0; d < D; ++d) node[d] = first[d] + o[d] - m;
        around[n] = node_value(fraction, node);
        uniform = uniform && around[n] == around[0];
      });
      float* out = &values_[slot * block_size];
      if (uniform) {
        std::fill(out, out + block_size, around[0]);
        continue;
      }
      for (int k = 0; k < (D == 3 ? edge : 1); ++k)
        for (int j = 0; j < edge; ++j) {
          float sum[edge] = {};
          for (int c = 0; c < layers; ++c)
            for (int b = 0; b < side; ++b) {
              const float* row = &around[(static_cast<std::size_t>(k + c) * padded + j + b) * padded];
              const float* weight = &stencil[(static_cast<std::size_t>(c) * side + b) * side];
              for (int a = 0; a < side; ++a)
                for (int i = 0; i < edge; ++i) sum[i] += weight[a] * row[a + i];
            }
          for (int i = 0; i < edge; ++i) *out++ = sum[i];
        }
    }
  }
}

/// The fraction of a cell is the wall's indicator smoothed with variance spacing^2/12: S <- S - spacing^2/24
/// laplace S.
template <int D>
void WallField<D>::sharpen() {
  std::vector<float> sharp(values_.size());
#pragma omp parallel for schedule(dynamic, 8)
  for (std::size_t slot = 0; slot < stored_.size(); ++slot) {
    const Index first = first_node(stored_[slot]);
    for_nodes<D>(edge, [&](int n, const Index& o) {
      Index node;
      for (int d = 0; d < D; ++d) node[d] = first[d] + o[d];
      const float centre = values_[slot * block_size + n];
      float laplacian = 0;
      for (int d = 0; d < D; ++d) {
        Index next = node, previous = node;
        ++next[d], --previous[d];
        laplacian += node_value(values_, next) + node_value(values_, previous) - 2 * centre;
      }
      sharp[slot * block_size + n] = centre - laplacian / 24.0f;
    });
  }
  values_ = std::move(sharp);
}

/// A cell is felt where one of its corners has a filling that counts: between them it falls off smoothly.
template <int D>
void WallField<D>::find_felt() {
  constexpr std::size_t words = block_size / 64;
  felt_.assign(stored_.size() * words, 0);
  felt_slot_.assign(stored_.size(), 0);
#pragma omp parallel for schedule(dynamic, 8)
  for (std::size_t slot = 0; slot < stored_.size(); ++slot) {
    const Index first = first_node(stored_[slot]);
    for_nodes<D>(edge + 1, [&](int, const Index& corner) {
      Index node;
      for (int d = 0; d < D; ++d) node[d] = first[d] + corner[d];
      if (std::abs(node_value(values_, node)) < counts) return;
      for_nodes<D>(2, [&](int, const Index& back) {
        Index cell;
        for (int d = 0; d < D; ++d) {
          cell[d] = corner[d] - back[d];
          if (cell[d] < 0 || cell[d] >= edge) return;
        }
        const int n = number_of(cell);
        felt_[slot * words + n / 64] |= std::uint64_t(1) << n % 64;
        felt_slot_[slot] = 1;
      });
    });
  }
}

/// The blocks as they are read: every row with one node more before and two after it, and one to keep rows aligned.
template <int D>
void WallField<D>::widen_rows() {
  constexpr int rows = block_size / edge;
  std::vector<float> wide;
  resize_in_large_pages(wide, stored_.size() * rows * wide_row);
#pragma omp parallel for schedule(dynamic, 8)
  for (std::size_t slot = 0; slot < stored_.size(); ++slot) {
    const Index first = first_node(stored_[slot]);
    for (int r = 0; r < rows; ++r)
      for (int i = 0; i < wide_row; ++i) {
        Index node = first;
        node[0] += i - 1, node[1] += r % edge;
        if constexpr (D == 3) node[2] += r / edge;
        wide[(slot * rows + r) * wide_row + i] = node_value(values_, node);
      }
  }
  values_ = std::move(wide);
}

template class WallField<2>;
template class WallField<3>;

}  // namespace ostium::sph3d
