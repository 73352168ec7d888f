#include "sph3d/shell/surface_points.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "sph3d/geometry/pseudo_normals.hpp"
#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/geometry/stretches.hpp"
#include "sph3d/shell/eliminate.hpp"
#include "sph3d/shell/reduced_kernel.hpp"

namespace ostium::sph3d {

namespace {

constexpr double smoothing = 1.15;  // h over the spacing, that of the shell
constexpr int samples_per_point = 3;
constexpr int steps_per_search = 8;
constexpr double skin = 0.25;  // beyond the reach that the search sees, over the spacing

/// Point k of the sequence of the golden ratio's generalisation to the plane (Roberts 2018).
Vec2 low_discrepancy(int k) {
  const auto fraction = [&](double step) {
    const double x = 0.5 + step * (k + 1);
    return x - std::floor(x);
  };
  return {fraction(0.7548776662466927), fraction(0.5698402909980532)};
}

/// A cloud on its way over the surface.
struct Spreading {
  const Surface<3>& wall;
  const std::vector<Rim<3>>& rims;
  std::vector<Vec3> facet_normal = facet_normals(wall);
  SignedDistance<3> nearest{wall};
  std::vector<Vec3> position = {}, normal = {};
};

/// Evenly along the cumulated area, low-discrepancy within each facet.
void scatter(Spreading& s, int n, double whole) {
  double passed = 0;
  int f = 0;
  double next = area_vector(s.wall, 0).norm();
  for (int k = 0; k < n; ++k) {
    for (const double here = (k + 0.5) * whole / n;
         passed + next < here && f + 1 < int(s.wall.facets.size());) {
      passed += next, next = area_vector(s.wall, ++f).norm();
    }
    const auto [a, b, c] = s.wall.facets[f];
    const Vec2 u = low_discrepancy(k);
    const double root = std::sqrt(u.x());
    s.position.push_back((1 - root) * s.wall.points[a] + root * (1 - u.y()) * s.wall.points[b] +
                         root * u.y() * s.wall.points[c]);
    s.normal.push_back(s.facet_normal[f]);
  }
}

void thin_out(Spreading& s, std::size_t keep, double area) {
  const auto stay = eliminate(s.position, s.normal, s.rims, keep, area);
  std::vector<Vec3> position, normal;
  for (const auto a : stay) position.push_back(s.position[a]), normal.push_back(s.normal[a]);
  s.position = std::move(position), s.normal = std::move(normal);
}

/// One step down the gradient of the kernel sum, at most a tenth of the spacing, and back to the surface.
void step(Spreading& s, const SurfacePairs<3>& pairs, const ReducedKernel<3>& kernel, double spacing) {
  const auto n = static_cast<std::int64_t>(s.position.size());
  const double rate = 0.4 * kernel.h * kernel.h * spacing * spacing, longest = 0.1 * spacing;
  std::vector<Vec3> moved(s.position.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t a = 0; a < n; ++a) {
    Vec3 push = Vec3::Zero();
    for (const auto& pair : pairs.of(a)) {
      const Vec3 apart = s.position[a] - seen(pair, s.position, s.rims);
      push += kernel.pull(apart.norm()) * apart;
    }
    push = rate * (push - push.dot(s.normal[a]) * s.normal[a]);
    const double length = push.norm();
    const auto hit = s.nearest(s.position[a] + (length > longest ? longest / length : 1.0) * push);
    moved[a] = hit.closest;
    s.normal[a] = s.facet_normal[hit.facet];
  }
  s.position = std::move(moved);
}

void relax(Spreading& s, double spacing, int iterations) {
  const ReducedKernel<3> kernel{smoothing * spacing};
  for (int done = 0; done < iterations;) {
    const SurfacePairs<3> pairs(s.position, s.normal, s.rims, kernel.reach() + skin * spacing);
    for (int k = 0; k < steps_per_search && done < iterations; ++k, ++done) step(s, pairs, kernel, spacing);
  }
}

template <int D>
void scale_to(std::vector<double>& area, double whole) {
  const double sum = std::accumulate(area.begin(), area.end(), 0.0);
  for (double& A : area) A *= whole / sum;
}

std::vector<double> patches(const Spreading& s, double spacing) {
  const ReducedKernel<3> kernel{smoothing * spacing};
  const SurfacePairs<3> pairs(s.position, s.normal, s.rims, kernel.reach());
  std::vector<double> area;
  for (std::size_t a = 0; a < s.position.size(); ++a) {
    double sum = kernel.value(0.0);
    for (const auto& pair : pairs.of(a))
      sum += kernel.value((s.position[a] - seen(pair, s.position, s.rims)).norm());
    area.push_back(1.0 / sum);
  }
  return area;
}

}  // namespace

SurfacePoints<3> surface_points(const Surface<3>& wall, const std::vector<Rim<3>>& rims, double spacing,
                                int iterations) {
  const double whole = area(wall, -1);
  const int n = std::max(1, static_cast<int>(std::lround(whole / (spacing * spacing))));
  Spreading s{wall, rims};
  scatter(s, samples_per_point * n, whole);
  thin_out(s, static_cast<std::size_t>(n), whole);
  relax(s, spacing, iterations);
  SurfacePoints<3> points{s.position, s.normal, patches(s, spacing)};
  scale_to<3>(points.area, whole);
  return points;
}

SurfacePoints<2> surface_points(const Surface<2>& wall, const std::vector<Rim<2>>&, double spacing, int) {
  SurfacePoints<2> points;
  for (const auto& p : spread_evenly(wall, spacing)) {
    points.position.push_back(p.position), points.normal.push_back(p.normal), points.area.push_back(p.area);
  }
  scale_to<2>(points.area, area(wall, -1));
  return points;
}

}  // namespace ostium::sph3d
