#include "sph3d/geometry/signed_distance.hpp"

#include <cmath>
#include <cstring>

#include "sph3d/geometry/closest_point.hpp"

namespace ostium::sph3d {
namespace {

using Float4 = float __attribute__((vector_size(16)));

/// Squared distances to the four boxes of a node, a little less so that rounding never hides a facet.
template <int D, class Node>
Float4 box_distances2(const Node& node, const float (&x)[D]) {
  Float4 sum{};
  for (int d = 0; d < D; ++d) {
    Float4 lower, upper;
    std::memcpy(&lower, node.lower[d], sizeof lower);
    std::memcpy(&upper, node.upper[d], sizeof upper);
    const Float4 below = lower - x[d], above = x[d] - upper, slack = Float4{} + 2e-7f * std::abs(x[d]);
    const Float4 beyond = (below > above ? below : above) - slack;
    const Float4 gap = beyond > 0.0f ? beyond : Float4{};
    sum += gap * gap;
  }
  return sum * (1 - 1e-6f);
}

/// What a query has still to look at: a node, or the facets of a leaf.
struct Entry {
  float distance2;
  int first, count;
};

/// A stack whose last pushes are kept in order, the nearest on top.
class Pending {
 public:
  bool empty() const { return size_ == 0; }
  Entry pop() { return entries_[--size_]; }
  void mark() { mark_ = size_; }
  void push(Entry entry) {
    int at = size_++;
    for (; at > mark_ && entries_[at - 1].distance2 < entry.distance2; --at) entries_[at] = entries_[at - 1];
    entries_[at] = entry;
  }

 private:
  Entry entries_[256];
  int size_ = 0, mark_ = 0;
};

}  // namespace

template <int D>
auto SignedDistance<D>::operator()(const Vec<D>& point, double bound) const -> Hit {
  const Vec<D> x = point - origin_;
  float xf[D];
  for (int d = 0; d < D; ++d) xf[d] = float(x[d]);
  double least = bound * bound;
  int nearest = -1;
  FacetPoint<D> closest{x, 0};
  Pending pending;
  pending.push({0, 0, 0});
  while (!pending.empty()) {
    const Entry entry = pending.pop();
    if (entry.distance2 >= least) continue;
    for (int i = entry.first; i < entry.first + entry.count; ++i) {
      const auto candidate = closest_on_facet(corners_[i], x);
      const double distance2 = (x - candidate.point).squaredNorm();
      if (distance2 < least) least = distance2, nearest = i, closest = candidate;
    }
    if (entry.count > 0) continue;
    const Node& node = nodes_[entry.first];
    const auto gap2 = box_distances2<D>(node, xf);
    pending.mark();
    for (int k = 0; k < 4; ++k)
      if (gap2[k] < least) pending.push({gap2[k], node.first[k], node.count[k]});
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

template SignedDistance<2>::Hit SignedDistance<2>::operator()(const Vec2&, double) const;
template SignedDistance<3>::Hit SignedDistance<3>::operator()(const Vec3&, double) const;

}  // namespace ostium::sph3d
