/// Signed distance to a closed surface, exact, by a bounding-volume hierarchy.
///
///   phi(x) = sign((x - c) . N(c)) |x - c|,   c the closest point of the surface
///
///   phi      m   negative inside
///   closest  m   c
///   normal   -   grad phi, unit: (x - c)/phi, and the pseudo-normal N(c) where x lies on the surface
///   facet    -   the facet c lies on; -1 when nothing lies within `bound`
///
/// N is the normal of the facet, the mean over the two facets of an edge, or the angle-weighted mean over the
/// facets of a corner, which gives the right sign everywhere (Baerentzen & Aanaes 2005). Queries are
/// thread-safe. Not checked: that the surface is closed and does not cut itself; the sign means nothing
/// otherwise.
#pragma once
#include <cstdint>
#include <limits>

#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

template <int D>
class SignedDistance {
 public:
  struct Hit {
    double phi;
    Vec<D> closest, normal;
    int facet;
  };

  explicit SignedDistance(const Surface<D>& surface);

  /// With a bound (m), farther facets are not looked at: a miss answers facet = -1, phi = +infinity whatever
  /// the side, and costs almost nothing.
  Hit operator()(const Vec<D>& x, double bound = std::numeric_limits<double>::infinity()) const;

 private:
  /// Four children at a time: boxes in single precision, rounded outward, relative to origin_.
  struct Node {
    float lower[D][4], upper[D][4];
    std::int32_t first[4];  ///< where the facets of a leaf begin, or the child node
    std::int32_t count[4];  ///< facets of a leaf; 0: a child node
  };
  using Corners = std::array<Vec<D>, D>;

  void build(std::vector<int>& order, const std::vector<Bounds<D>>& boxes);
  int split(std::vector<int>& order, const std::vector<Bounds<D>>& boxes, int begin, int end) const;
  void set_child(Node& node, int child, const Bounds<D>& box) const;

  Vec<D> origin_;
  std::vector<Node> nodes_;
  std::vector<Corners> corners_;  ///< in leaf order, relative to origin_
  std::vector<int> facet_;        ///< leaf order -> facet of the surface
  /// Per facet in leaf order: its own normal, then those of its edges (3D only), then of its corners.
  std::vector<std::array<Vec<D>, D == 3 ? 7 : 3>> normals_;
};

extern template class SignedDistance<2>;
extern template class SignedDistance<3>;

}  // namespace ostium::sph3d
