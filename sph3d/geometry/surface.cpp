#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

template <>
Vec2 area_vector<2>(const Surface<2>& surface, int f) {
  const Vec2 ab = surface.points[surface.facets[f][1]] - surface.points[surface.facets[f][0]];
  return {ab.y(), -ab.x()};
}

template <>
Vec3 area_vector<3>(const Surface<3>& surface, int f) {
  const auto [a, b, c] = surface.facets[f];
  const auto& x = surface.points;
  return 0.5 * (x[b] - x[a]).cross(x[c] - x[a]);
}

template <int D>
Vec<D> centroid(const Surface<D>& surface, int f) {
  Vec<D> sum = Vec<D>::Zero();
  for (int v : surface.facets[f]) sum += surface.points[v];
  return sum / D;
}

template <int D>
double volume(const Surface<D>& surface) {
  if (surface.points.empty()) return 0;
  // Relative to a point of the surface: medical images put vessels far from the origin.
  const Vec<D> origin = surface.points.front();
  double sum = 0;
  for (int f = 0; f < int(surface.facets.size()); ++f)
    sum += (centroid(surface, f) - origin).dot(area_vector(surface, f));
  return sum / D;
}

template <int D>
double area(const Surface<D>& surface, int label) {
  double sum = 0;
  for (int f = 0; f < int(surface.facets.size()); ++f)
    if (surface.label[f] == label) sum += area_vector(surface, f).norm();
  return sum;
}

template <int D>
Bounds<D> bounds(const std::vector<Vec<D>>& points) {
  if (points.empty()) return {Vec<D>::Zero(), Vec<D>::Zero()};
  Bounds<D> box{points.front(), points.front()};
  for (const auto& x : points) {
    box.lower = box.lower.cwiseMin(x);
    box.upper = box.upper.cwiseMax(x);
  }
  return box;
}

template Vec<2> centroid(const Surface<2>&, int);
template Vec<3> centroid(const Surface<3>&, int);
template double volume(const Surface<2>&);
template double volume(const Surface<3>&);
template double area(const Surface<2>&, int);
template double area(const Surface<3>&, int);
template Bounds<2> bounds(const std::vector<Vec<2>>&);
template Bounds<3> bounds(const std::vector<Vec<3>>&);

}  // namespace ostium::sph3d
