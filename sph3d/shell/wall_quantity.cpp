#include "sph3d/shell/wall_quantity.hpp"

#include <algorithm>

#include "core/did_you_mean.hpp"
#include "core/error.hpp"
#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/shell/lateral.hpp"
#include "sph3d/shell/rim.hpp"

namespace ostium::sph3d {

namespace {

void check_positive(double x, const char* name) {
  if (!(x > 0.0)) user_error("{} is {:g}; it has to be positive", name, x);
}

/// Shares of the corners of a facet in a point of it.
std::array<double, 2> shares(const Surface<2>& s, int f, const Vec2& x) {
  const Vec2 a = s.points[s.facets[f][0]], along = s.points[s.facets[f][1]] - a;
  const double t = along.dot(x - a) / std::max(along.squaredNorm(), 1e-300);
  return {1.0 - t, t};
}

std::array<double, 3> shares(const Surface<3>& s, int f, const Vec3& x) {
  const Vec3 a = s.points[s.facets[f][0]], b = s.points[s.facets[f][1]], c = s.points[s.facets[f][2]];
  const Vec3 n = (b - a).cross(c - a);
  const double whole = std::max(n.squaredNorm(), 1e-300);
  const double u = (x - a).cross(c - a).dot(n) / whole, v = (b - a).cross(x - a).dot(n) / whole;
  return {1.0 - u - v, u, v};
}

template <int D>
void check_list(const std::vector<double>& of_point, const Lumen<D>& lumen, const char* name) {
  const auto& points = lumen.surface.points;
  if (of_point.size() != points.size())
    user_error("{} is given by {} values, but the surface has {} points; every point needs one", name,
               of_point.size(), points.size());
  for (std::size_t v = 0; v < points.size(); ++v)
    if (!(of_point[v] > 0.0))
      user_error("{} is {:g} at point {} of the surface, {}; it has to be positive", name, of_point[v], v,
                 place<D>(points[v]));
}

template <int D>
std::vector<double> interpolated(const std::vector<double>& of_point, const std::vector<Vec<D>>& points,
                                 const Lumen<D>& lumen) {
  const Surface<D> wall = lateral(lumen.surface);
  const SignedDistance<D> nearest(wall);
  std::vector<double> values;
  for (const auto& x : points) {
    const auto hit = nearest(x);
    const auto share = shares(wall, hit.facet, hit.closest);
    double value = 0.0, low = 1e300, high = -1e300;
    for (int k = 0; k < D; ++k) {
      const double v = of_point[wall.facets[hit.facet][k]];
      value += share[k] * v, low = std::min(low, v), high = std::max(high, v);
    }
    values.push_back(std::clamp(value, low, high));  // slivers have no exact shares
  }
  return values;
}

template <int D>
const Opening<D>& opening_named(const std::string& name, const Lumen<D>& lumen, const char* quantity) {
  std::vector<std::string> names;
  for (const auto& o : lumen.openings) {
    if (o.name == name) return o;
    names.push_back(o.name);
  }
  user_error("{} varies from the opening '{}', which the vessel has not{}", quantity, name,
             did_you_mean(name, names));
}

template <int D>
std::vector<double> ramp(const FromOpening& q, const std::vector<Vec<D>>& points, const Lumen<D>& lumen,
                         const char* name) {
  const Rim<D> rim(opening_named(q.opening, lumen, name), 0.0);
  check_positive(q.at_opening, name), check_positive(q.away, name);
  if (!(q.length > 0.0))
    user_error("{} varies over a length of {:g} m; it has to be positive", name, q.length);
  std::vector<double> values;
  for (const auto& x : points) {
    const double share = std::min(rim.distance(x) / q.length, 1.0);
    values.push_back(q.at_opening + share * (q.away - q.at_opening));
  }
  return values;
}

}  // namespace

template <int D>
std::vector<double> values_at(const WallQuantity& quantity, const std::vector<Vec<D>>& points,
                              const Lumen<D>& lumen, const char* name) {
  if (const auto* value = std::get_if<double>(&quantity)) {
    check_positive(*value, name);
    return std::vector<double>(points.size(), *value);
  }
  if (const auto* list = std::get_if<std::vector<double>>(&quantity)) {
    check_list(*list, lumen, name);
    return interpolated(*list, points, lumen);
  }
  return ramp(std::get<FromOpening>(quantity), points, lumen, name);
}

template std::vector<double> values_at(const WallQuantity&, const std::vector<Vec<2>>&, const Lumen<2>&,
                                       const char*);
template std::vector<double> values_at(const WallQuantity&, const std::vector<Vec<3>>&, const Lumen<3>&,
                                       const char*);

}  // namespace ostium::sph3d
