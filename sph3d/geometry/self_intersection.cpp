#include "sph3d/geometry/self_intersection.hpp"

#include <algorithm>
#include <numeric>

namespace ostium::sph3d {
namespace {

using Corners = std::array<Vec3, 3>;

/// Six times the volume of a tetrahedron; its sign tells the side of the plane (a, b, c) on which d lies.
double side(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return (b - a).cross(c - a).dot(d - a);
}

bool pierces(const Vec3& p, const Vec3& q, const Corners& t) {
  if (!(side(t[0], t[1], t[2], p) * side(t[0], t[1], t[2], q) < 0)) return false;
  const double u = side(p, q, t[0], t[1]), v = side(p, q, t[1], t[2]), w = side(p, q, t[2], t[0]);
  return (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
}

bool any_edge_pierces(const Corners& s, const Corners& t) {
  for (int k = 0; k < 3; ++k)
    if (pierces(s[k], s[(k + 1) % 3], t)) return true;
  return false;
}

bool share_a_corner(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  return std::any_of(a.begin(), a.end(), [&](int v) { return v == b[0] || v == b[1] || v == b[2]; });
}

}  // namespace

std::vector<std::pair<int, int>> self_intersections(const Surface<3>& surface) {
  const int n = int(surface.facets.size());
  std::vector<Corners> corner(n);
  std::vector<Bounds<3>> box(n);
  for (int f = 0; f < n; ++f) {
    for (int k = 0; k < 3; ++k) corner[f][k] = surface.points[surface.facets[f][k]];
    box[f] = {corner[f][0].cwiseMin(corner[f][1]).cwiseMin(corner[f][2]),
              corner[f][0].cwiseMax(corner[f][1]).cwiseMax(corner[f][2])};
  }
  int axis;
  bounds(surface.points).extent().maxCoeff(&axis);
  std::vector<int> order(n), open;
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](int a, int b) { return box[a].lower[axis] < box[b].lower[axis]; });
  std::vector<std::pair<int, int>> found;
  for (int f : order) {  // a plane sweeps along the vessel; `open` are the triangles it cuts
    std::erase_if(open, [&](int g) { return box[g].upper[axis] < box[f].lower[axis]; });
    for (int g : open) {
      const bool apart = (box[f].lower.array() > box[g].upper.array()).any() ||
                         (box[g].lower.array() > box[f].upper.array()).any();
      if (apart || share_a_corner(surface.facets[f], surface.facets[g])) continue;
      if (any_edge_pierces(corner[f], corner[g]) || any_edge_pierces(corner[g], corner[f]))
        found.push_back(std::minmax(f, g));
    }
    open.push_back(f);
  }
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace ostium::sph3d
