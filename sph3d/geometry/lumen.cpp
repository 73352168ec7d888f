#include "sph3d/geometry/lumen.hpp"

#include <algorithm>

#include "sph3d/geometry/outline.hpp"

namespace ostium::sph3d {
template <>
Eigen::Matrix<double, 2, 1> plane_frame<2>(const Vec2& normal) {
  return Vec2(normal.y(), -normal.x());
}

template <>
Eigen::Matrix<double, 3, 2> plane_frame<3>(const Vec3& normal) {
  int axis;
  normal.cwiseAbs().minCoeff(&axis);
  Eigen::Matrix<double, 3, 2> t;
  t.col(0) = normal.cross(Vec3::Unit(axis)).normalized();
  t.col(1) = normal.cross(t.col(0));
  return t;
}

namespace {

/// The outline in the frame of the tangents, relative to the centre.
Polygon flat_outline(const Opening<3>& opening) {
  const auto t = plane_frame(opening.normal);
  Polygon flat;
  for (const auto& x : opening.outline) flat.push_back(t.transpose() * (x - opening.centre));
  return flat;
}

}  // namespace

template <>
bool inside_outline(const Opening<2>& opening, const Vec2& x) {
  const Vec2 along = opening.outline[1] - opening.outline[0];
  const double t = along.dot(x - opening.outline[0]);
  return t >= 0 && t <= along.squaredNorm();
}

template <>
bool inside_outline(const Opening<3>& opening, const Vec3& x) {
  // In the two coordinates that see the opening at its widest: no frame to set up for each point.
  int axis;
  opening.normal.cwiseAbs().maxCoeff(&axis);
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Vec3 p = x - (x - opening.centre).dot(opening.normal) * opening.normal;
  bool odd = false;
  const auto& rim = opening.outline;
  for (std::size_t k = 0, l = rim.size() - 1; k < rim.size(); l = k++) {
    const Vec3 &a = rim[k], &b = rim[l];
    if ((a[j] > p[j]) != (b[j] > p[j]) && p[i] < (b[i] - a[i]) * (p[j] - a[j]) / (b[j] - a[j]) + a[i])
      odd = !odd;
  }
  return odd;
}

template <>
double width(const Opening<2>& opening) {
  return (opening.outline[1] - opening.outline[0]).norm();
}

template <>
double width(const Opening<3>& opening) {
  return 2 * inscribed_radius(flat_outline(opening));
}

template <int D>
double length_between_openings(const Lumen<D>& lumen) {
  double length = 0;
  for (const auto& a : lumen.openings)
    for (const auto& b : lumen.openings) length = std::max(length, (a.centre - b.centre).norm());
  if (lumen.openings.size() == 1)
    for (const auto& x : lumen.surface.points)
      length = std::max(length, (x - lumen.openings.front().centre).norm());
  return length;
}

template double length_between_openings(const Lumen<2>&);
template double length_between_openings(const Lumen<3>&);

}  // namespace ostium::sph3d
