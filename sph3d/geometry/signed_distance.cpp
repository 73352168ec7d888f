#include "sph3d/geometry/signed_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "sph3d/geometry/closest_point.hpp"
#include "sph3d/geometry/pseudo_normals.hpp"

namespace ostium::sph3d {
namespace {

constexpr int leaf_size = 2, bins = 16;

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
                             int end) {
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
void SignedDistance<D>::build(std::vector<int>& order, const std::vector<Bounds<D>>& boxes) {
  struct Range {
    int node, begin, end, depth;
  };
  constexpr int deep = 60;  // beyond it halve by number, so that a query's stack of 128 suffices
  constexpr float inf = std::numeric_limits<float>::infinity();
  std::vector<Range> open{{0, 0, int(order.size()), 0}};
  nodes_.emplace_back();
  while (!open.empty()) {
    const auto [node, begin, end, depth] = open.back();
    open.pop_back();
    const int middle = end - begin < 2 ? end
                       : depth > deep  ? (begin + end) / 2
                                       : split(order, boxes, begin, end);
    const int from[2] = {begin, middle}, to[2] = {middle, end};
    for (int side = 0; side < 2; ++side) {
      const auto box = enclose(order, boxes, from[side], to[side]);
      for (int d = 0; d < D; ++d) {
        nodes_[node].lower[side][d] = std::nextafter(float(box.lower[d]), -inf);
        nodes_[node].upper[side][d] = std::nextafter(float(box.upper[d]), inf);
      }
      const int count = to[side] - from[side];
      if (count <= leaf_size) {
        nodes_[node].first[side] = from[side], nodes_[node].count[side] = count;
      } else {
        nodes_[node].first[side] = int(nodes_.size()), nodes_[node].count[side] = 0;
        open.push_back({int(nodes_.size()), from[side], to[side], depth + 1});
        nodes_.emplace_back();
      }
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

namespace {

/// Squared distance to a box, a little less so that rounding never hides a facet.
template <int D>
float box_distance2(const float (&lower)[D], const float (&upper)[D], const float (&x)[D]) {
  float sum = 0;
  for (int d = 0; d < D; ++d) {
    const float gap = std::max({lower[d] - x[d], x[d] - upper[d], 0.0f}) - 2e-7f * std::abs(x[d]);
    sum += gap > 0 ? gap * gap : 0;
  }
  return sum * (1 - 1e-6f);
}

}  // namespace

template <int D>
auto SignedDistance<D>::operator()(const Vec<D>& point, double bound) const -> Hit {
  const Vec<D> x = point - origin_;
  float xf[D];
  for (int d = 0; d < D; ++d) xf[d] = float(x[d]);
  double least = bound * bound;
  int nearest = -1;
  FacetPoint<D> closest{x, 0};
  struct Entry {
    int node;
    float distance2;
  };
  std::array<Entry, 128> stack;
  int top = 0;
  stack[top++] = {0, 0};
  while (top > 0) {
    const Entry entry = stack[--top];
    if (entry.distance2 > least) continue;
    const Node& node = nodes_[entry.node];
    const float gap[2] = {box_distance2<D>(node.lower[0], node.upper[0], xf),
                          box_distance2<D>(node.lower[1], node.upper[1], xf)};
    const int near = gap[1] < gap[0] ? 1 : 0;
    for (const int side : {near, 1 - near}) {
      if (node.count[side] == 0 || gap[side] > least) continue;
      for (int i = node.first[side]; i < node.first[side] + node.count[side]; ++i) {
        const auto candidate = closest_on_facet(corners_[i], x);
        const double distance2 = (x - candidate.point).squaredNorm();
        if (distance2 < least || (nearest < 0 && distance2 <= least))
          least = distance2, nearest = i, closest = candidate;
      }
    }
    for (const int side : {1 - near, near})
      if (node.count[side] == 0 && gap[side] <= least) stack[top++] = {node.first[side], gap[side]};
  }
  if (nearest < 0) return {std::numeric_limits<double>::infinity(), point, Vec<D>::Zero(), -1};
  const Vec<D>& pseudo = normals_[nearest][closest.feature];
  const Vec<D> away = x - closest.point;
  const double distance = std::sqrt(least), sign = away.dot(pseudo) < 0 ? -1 : 1;
  // So close to the surface that the direction of x - c is round-off.
  const bool touching = distance <= 1e-12 * (1e-3 + closest.point.template lpNorm<Eigen::Infinity>());
  return {sign * distance, closest.point + origin_, touching ? pseudo : Vec<D>(away * (sign / distance)),
          facet_[nearest]};
}

template class SignedDistance<2>;
template class SignedDistance<3>;

}  // namespace ostium::sph3d
