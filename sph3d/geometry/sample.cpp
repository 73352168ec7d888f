#include "sph3d/geometry/sample.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sph3d/geometry/point_grid.hpp"
#include "sph3d/geometry/pseudo_normals.hpp"
#include "sph3d/geometry/signed_distance.hpp"

namespace ostium::sph3d {
namespace {

constexpr int relaxation_steps = 80;
constexpr double smoothing = 1.15;  // h over the spacing

/// The wall of a lumen alone: an open surface, fit for closest points only.
struct Wall {
  Surface<3> surface;
  std::vector<Vec3> normal;
  int kept = 0;  ///< facets from here on are extensions beyond the openings
};

/// Beyond its openings the wall runs on for some spacings, so that points near a rim have neighbours on all sides.
Wall extended_wall(const Lumen<3>& lumen, double spacing) {
  const auto longer = extended(lumen, 4 * spacing);
  Wall wall;
  wall.surface.points = longer.surface.points;
  const auto normals = facet_normals(longer.surface);
  for (std::size_t f = 0; f < longer.surface.facets.size(); ++f) {
    if (longer.surface.label[f] != -1) continue;
    wall.surface.facets.push_back(longer.surface.facets[f]);
    wall.surface.label.push_back(-1);
    wall.normal.push_back(normals[f]);
    if (f < lumen.surface.facets.size()) ++wall.kept;
  }
  return wall;
}

/// Point k of the sequence of the golden ratio's generalisation to the plane (Roberts 2018).
Vec2 low_discrepancy(int k) {
  const auto fraction = [&](double step) {
    const double x = 0.5 + step * (k + 1);
    return x - std::floor(x);
  };
  return {fraction(0.7548776662466927), fraction(0.5698402909980532)};
}

/// Evenly along the cumulated area, low-discrepancy within each facet.
std::vector<Vec3> scatter(const Surface<3>& s, double spacing) {
  std::vector<double> cumulated;
  double whole = 0;
  for (int f = 0; f < int(s.facets.size()); ++f) cumulated.push_back(whole += area_vector(s, f).norm());
  const int n = std::max(1, int(std::ceil(whole / (spacing * spacing))));
  std::vector<Vec3> points;
  for (int k = 0, f = 0; k < n; ++k) {
    while (f + 1 < int(cumulated.size()) && cumulated[f] < (k + 0.5) * whole / n) ++f;
    const auto [a, b, c] = s.facets[f];
    const Vec2 u = low_discrepancy(k);
    const double root = std::sqrt(u.x());
    points.push_back((1 - root) * s.points[a] + root * (1 - u.y()) * s.points[b] +
                     root * u.y() * s.points[c]);
  }
  return points;
}

/// Wendland C2 of the plane, h = 1, without its constant: W and -W'/q.
double kernel(double q) { return q < 2 ? std::pow(1 - 0.5 * q, 4) * (1 + 2 * q) : 0; }
double slope(double q) { return q < 2 ? 5 * std::pow(1 - 0.5 * q, 3) : 0; }

struct Points {
  std::vector<Vec3> position, normal;
  std::vector<int> facet;
};

/// Onto the wall again; the facet there gives the normal.
void project(Points& p, const SignedDistance<3>& nearest, const Wall& wall) {
#pragma omp parallel for schedule(static) if (p.position.size() > 4000)
  for (int i = 0; i < int(p.position.size()); ++i) {
    const auto hit = nearest(p.position[i]);
    p.position[i] = hit.closest;
    p.facet[i] = hit.facet;
    p.normal[i] = wall.normal[hit.facet];
  }
}

/// One step down the gradient of the number density in the tangent plane. Walls that face each other across a
/// narrow lumen do not see each other.
void spread(Points& p, double spacing) {
  const double h = smoothing * spacing;
  const PointGrid<3> grid(p.position, 2 * h);
  std::vector<Vec3> moved = p.position;
#pragma omp parallel for schedule(static) if (p.position.size() > 4000)
  for (int i = 0; i < int(p.position.size()); ++i) {
    Vec3 push = Vec3::Zero();
    grid.near(p.position[i], [&](int j, const Vec3& apart) {
      if (j != i && p.normal[i].dot(p.normal[j]) > 0) push += slope(apart.norm() / h) * apart / h;
    });
    push -= push.dot(p.normal[i]) * p.normal[i];
    constexpr double rate = 0.03, longest = 0.15;
    const double length = push.norm();
    if (length > 0) moved[i] += h * std::min(rate, longest / length) * push;
  }
  p.position = std::move(moved);
}

/// Number density and smoothed normal of every point.
std::pair<std::vector<double>, std::vector<Vec3>> smoothed(const Points& p, double spacing) {
  const double h = smoothing * spacing;
  const PointGrid<3> grid(p.position, 2 * h);
  std::vector<double> density(p.position.size(), 0);
  std::vector<Vec3> normal(p.position.size(), Vec3::Zero());
#pragma omp parallel for schedule(static) if (p.position.size() > 4000)
  for (int i = 0; i < int(p.position.size()); ++i) {
    grid.near(p.position[i], [&](int j, const Vec3& apart) {
      if (p.normal[i].dot(p.normal[j]) <= 0) return;
      const double w = kernel(apart.norm() / h);
      density[i] += w, normal[i] += w * p.normal[j];
    });
    normal[i].normalize();
  }
  return {density, normal};
}

void check_spacing(double spacing) {
  if (!(spacing > 0)) user_error("wall points: a positive spacing, found {} m", spacing);
}

template <int D>
void scale_to(std::vector<WallPoint<D>>& points, double wall_area) {
  double sum = 0;
  for (const auto& p : points) sum += p.area;
  for (auto& p : points) p.area *= wall_area / sum;
}

}  // namespace

template <>
std::vector<WallPoint<3>> sample_wall(const Lumen<3>& lumen, double spacing) {
  check_spacing(spacing);
  const auto wall = extended_wall(lumen, spacing);
  const SignedDistance<3> nearest(wall.surface);
  Points p{.position = scatter(wall.surface, spacing), .normal = {}, .facet = {}};
  p.normal.resize(p.position.size()), p.facet.resize(p.position.size());
  project(p, nearest, wall);
  for (int step = 0; step < relaxation_steps; ++step) spread(p, spacing), project(p, nearest, wall);
  const auto [density, normal] = smoothed(p, spacing);
  std::vector<WallPoint<3>> points;
  for (std::size_t i = 0; i < p.position.size(); ++i)
    if (p.facet[i] < wall.kept) points.push_back({p.position[i], normal[i], 1 / density[i]});
  if (points.empty()) user_error("wall points: the spacing {} m is coarser than the vessel", spacing);
  scale_to(points, lumen.wall_area);
  return points;
}

/// Wall segments one by one, each with at least one point: corners of an outline stay corners.
template <>
std::vector<WallPoint<2>> sample_wall(const Lumen<2>& lumen, double spacing) {
  check_spacing(spacing);
  const auto& s = lumen.surface;
  std::vector<WallPoint<2>> points;
  for (int f = 0; f < int(s.facets.size()); ++f) {
    if (s.label[f] != -1) continue;
    const Vec2 a = s.points[s.facets[f][0]], along = s.points[s.facets[f][1]] - a;
    const int n = std::max(1, int(std::round(along.norm() / spacing)));
    for (int k = 0; k < n; ++k)
      points.push_back({a + (k + 0.5) / n * along, area_vector(s, f).normalized(), along.norm() / n});
  }
  return points;
}

}  // namespace ostium::sph3d
