/// The hierarchy of boxes: four children per node, cut where the boxes' surface is least.
#include "sph3d/geometry/signed_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "sph3d/geometry/pseudo_normals.hpp"

namespace ostium::sph3d {
namespace {

constexpr int leaf_size = 4, bins = 16;

template <int D>
double half_area(const Bounds<D>& b) {
  const Vec<D> e = b.extent();
  if constexpr (D == 2)
    return e.x() + e.y();
  else
    return e.x() * e.y() + e.y() * e.z() + e.z() * e.x();
}

template <int D>
void include(Bounds<D>& b, const Bounds<D>& other) {
  b.lower = b.lower.cwiseMin(other.lower);
  b.upper = b.upper.cwiseMax(other.upper);
}

template <int D>
Bounds<D> nothing() {
  constexpr double inf = std::numeric_limits<double>::infinity();
  return {Vec<D>::Constant(inf), Vec<D>::Constant(-inf)};
}

template <int D>
Bounds<D> enclose(const std::vector<int>& order, const std::vector<Bounds<D>>& boxes, int begin, int end) {
  auto all = nothing<D>();
  for (int i = begin; i < end; ++i) include(all, boxes[order[i]]);
  return all;
}

template <int D>
struct Bin {
  Bounds<D> box = nothing<D>();
  int count = 0;
};

/// The bin boundary with the least surface-area cost; 0 if every facet falls in one bin.
template <int D>
int best_cut(const std::array<Bin<D>, bins>& bin) {
  std::array<double, bins> right{};
  auto box = nothing<D>();
  int count = 0;
  for (int b = bins - 1; b > 0; --b) {
    include(box, bin[b].box);
    count += bin[b].count;
    right[b] = count ? count * half_area(box) : -1;
  }
  box = nothing<D>(), count = 0;
  int cut = 0;
  double least = std::numeric_limits<double>::infinity();
  for (int b = 1; b < bins; ++b) {
    include(box, bin[b - 1].box);
    count += bin[b - 1].count;
    if (!count || right[b] < 0) continue;
    const double cost = count * half_area(box) + right[b];
    if (cost < least) least = cost, cut = b;
  }
  return cut;
}

}  // namespace

/// Reorders [begin, end) and returns where it is cut in two (surface-area heuristic, bins along the longest
/// axis).
template <int D>
int SignedDistance<D>::split(std::vector<int>& order, const std::vector<Bounds<D>>& boxes, int begin,
                             int end) const {
  const auto middle = [&](int f) { return Vec<D>(0.5 * (boxes[f].lower + boxes[f].upper)); };
  auto centres = nothing<D>();
  for (int i = begin; i < end; ++i) include(centres, {middle(order[i]), middle(order[i])});
  int axis;
  const double width = centres.extent().maxCoeff(&axis);
  const auto bin_of = [&](int f) {
    return std::min(bins - 1, int((middle(f)[axis] - centres.lower[axis]) / width * bins));
  };
  int cut = 0;
  if (width > 0) {
    std::array<Bin<D>, bins> bin{};
    for (int i = begin; i < end; ++i) {
      auto& b = bin[bin_of(order[i])];
      include(b.box, boxes[order[i]]);
      ++b.count;
    }
    cut = best_cut<D>(bin);
  }
  if (cut == 0) return (begin + end) / 2;
  const auto first = order.begin();
  return int(std::stable_partition(first + begin, first + end, [&](int f) { return bin_of(f) < cut; }) -
             first);
}

template <int D>
void SignedDistance<D>::set_child(Node& node, int child, const Bounds<D>& box) const {
  constexpr float inf = std::numeric_limits<float>::infinity();
  for (int d = 0; d < D; ++d) {
    node.lower[d][child] = std::nextafter(float(box.lower[d]), -inf);
    node.upper[d][child] = std::nextafter(float(box.upper[d]), inf);
  }
}

template <int D>
void SignedDistance<D>::build(std::vector<int>& order, const std::vector<Bounds<D>>& boxes) {
  struct Range {
    int node, begin, end, depth;
  };
  constexpr int deep = 40;  // beyond it halve by number, so that the stack of a query suffices
  std::vector<Range> open{{0, 0, int(order.size()), 0}};
  nodes_.emplace_back();
  while (!open.empty()) {
    const auto [node, begin, end, depth] = open.back();
    open.pop_back();
    const auto cut = [&](int from, int to) {
      return to - from < 2 || depth > deep ? (from + to) / 2 : split(order, boxes, from, to);
    };
    const int middle = cut(begin, end);
    const int edge[5] = {begin, cut(begin, middle), middle, cut(middle, end), end};
    for (int child = 0; child < 4; ++child) {
      const int count = edge[child + 1] - edge[child];
      // An empty child has an inverted, infinite box: no query ever enters it.
      set_child(nodes_[node], child, enclose(order, boxes, edge[child], edge[child + 1]));
      const bool leaf = count <= leaf_size;
      nodes_[node].first[child] = leaf ? edge[child] : int(nodes_.size());
      nodes_[node].count[child] = leaf ? std::max(count, 1) : 0;
      if (leaf) continue;
      open.push_back({int(nodes_.size()), edge[child], edge[child + 1], depth + 1});
      nodes_.emplace_back();
    }
  }
}

template <int D>
SignedDistance<D>::SignedDistance(const Surface<D>& surface) {
  const int n = int(surface.facets.size());
  OSTIUM_ASSERT(n > 1, "a closed surface has more than {} facet", n);
  const auto box = bounds(surface.points);
  origin_ = 0.5 * (box.lower + box.upper);
  std::vector<Bounds<D>> boxes(n, nothing<D>());
  for (int f = 0; f < n; ++f)
    for (int v : surface.facets[f]) {
      const Vec<D> x = surface.points[v] - origin_;
      include(boxes[f], {x, x});
    }
  facet_.resize(n);
  std::iota(facet_.begin(), facet_.end(), 0);
  build(facet_, boxes);
  const auto normals = pseudo_normals(surface);
  corners_.resize(n), normals_.resize(n);
  for (int i = 0; i < n; ++i) {
    normals_[i] = normals[facet_[i]];
    for (int k = 0; k < D; ++k) corners_[i][k] = surface.points[surface.facets[facet_[i]][k]] - origin_;
  }
}

template class SignedDistance<2>;
template class SignedDistance<3>;

}  // namespace ostium::sph3d
