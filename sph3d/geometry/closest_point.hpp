/// Closest point of a facet, and on which of its features it lies. Internal to geometry/.
#pragma once
#include <algorithm>
#include <array>

#include "core/vec.hpp"

namespace ostium::sph3d {

/// Features are numbered: 0 the facet; 3D: 1..3 its edges, 4..6 its corners; 2D: 1, 2 its ends.
template <int D>
struct FacetPoint {
  Vec<D> point;
  int feature;
};

inline FacetPoint<2> closest_on_facet(const std::array<Vec2, 2>& s, const Vec2& x) {
  const Vec2 ab = s[1] - s[0];
  const double t = ab.dot(x - s[0]), length2 = ab.squaredNorm();
  if (t <= 0) return {s[0], 1};
  if (t >= length2) return {s[1], 2};
  return {s[0] + ab * (t / length2), 0};
}

/// Regions of the plane of a triangle, after Ericson, Real-Time Collision Detection, 5.1.5.
inline FacetPoint<3> closest_on_facet(const std::array<Vec3, 3>& t, const Vec3& x) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ax = x - t[0];
  const double d1 = ab.dot(ax), d2 = ac.dot(ax);
  if (d1 <= 0 && d2 <= 0) return {t[0], 4};
  const Vec3 bx = x - t[1];
  const double d3 = ab.dot(bx), d4 = ac.dot(bx);
  if (d3 >= 0 && d4 <= d3) return {t[1], 5};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return {t[0] + ab * (d1 / (d1 - d3)), 1};
  const Vec3 cx = x - t[2];
  const double d5 = ab.dot(cx), d6 = ac.dot(cx);
  if (d6 >= 0 && d5 <= d6) return {t[2], 6};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return {t[0] + ac * (d2 / (d2 - d6)), 3};
  const double va = d3 * d6 - d5 * d4, along = d4 - d3, back = d5 - d6;
  if (va <= 0 && along >= 0 && back >= 0) return {t[1] + (t[2] - t[1]) * (along / (along + back)), 2};
  const double scale = 1 / (va + vb + vc);
  return {t[0] + ab * (vb * scale) + ac * (vc * scale), 0};
}

}  // namespace ostium::sph3d
