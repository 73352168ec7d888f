#include <algorithm>
#include <numeric>

#include "sph3d/geometry/find_openings.hpp"

namespace ostium::sph3d {
namespace {

const double smooth = std::cos(pi / 90);  // 2 degrees: same plane
const double sharp = std::cos(pi / 6);    // 30 degrees: a rim

/// Grows from the facet `seed` over neighbours that lie in its plane. Slivers have no normal to speak of:
/// they belong to the plane when their corners do.
std::vector<int> grow(const SurfaceTopology& t, int seed, std::vector<int>& region, int number) {
  const auto& [surface, normal, beyond] = t;
  const Vec3 n = normal[seed], origin = surface.points[surface.facets[seed][0]];
  std::vector<int> found{seed};
  region[seed] = number;
  double area = area_vector(surface, seed).norm();
  const auto in_plane = [&](int f) {
    const double tolerance = allowed_unevenness(area, false);
    return std::all_of(surface.facets[f].begin(), surface.facets[f].end(),
                       [&](int v) { return std::abs((surface.points[v] - origin).dot(n)) < tolerance; });
  };
  for (std::size_t i = 0; i < found.size(); ++i)
    for (int g : beyond[found[i]]) {
      if (g < 0 || region[g] >= 0) continue;
      if (normal[g].dot(n) < smooth && !in_plane(g)) continue;
      region[g] = number;
      found.push_back(g);
      area += area_vector(surface, g).norm();
    }
  return found;
}

std::vector<int> by_falling_area(const Surface<3>& surface) {
  std::vector<double> area(surface.facets.size());
  for (std::size_t f = 0; f < area.size(); ++f) area[f] = area_vector(surface, int(f)).norm();
  std::vector<int> order(area.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return area[a] > area[b]; });
  return order;
}

}  // namespace

double sharp_share(const SurfaceTopology& t, const Region& r, const std::vector<int>& region) {
  const auto& [surface, normal, beyond] = t;
  const Vec3 n = r.normal();
  const int number = region[r.facets.front()];
  double all = 0, bent = 0;
  for (int f : r.facets)
    for (int s = 0; s < 3; ++s) {
      const int g = beyond[f][s];
      if (g < 0 || region[g] == number) continue;
      const Vec3 from = surface.points[surface.facets[f][s]],
                 to = surface.points[surface.facets[f][(s + 1) % 3]];
      const double length = (to - from).norm();
      all += length;
      if (normal[g].dot(n) < sharp && (centroid(surface, g) - 0.5 * (from + to)).dot(n) < 0) bent += length;
    }
  return all > 0 ? bent / all : 0;
}

std::vector<Region> flat_regions(const SurfaceTopology& t, const std::vector<char>& taken) {
  std::vector<int> region(t.surface.facets.size(), -1);
  std::vector<Region> flat;
  int number = 0;
  for (int seed : by_falling_area(t.surface)) {
    if (region[seed] >= 0 || taken[seed]) continue;
    auto r = measure(t, grow(t, seed, region, number));
    const bool speck = r.facets.size() < 2;  // one facet of a coarse wall
    if (!speck && r.unevenness < allowed_unevenness(r.area(), false) && sharp_share(t, r, region) > 0.9)
      flat.push_back(std::move(r));
    ++number;
  }
  return flat;
}

}  // namespace ostium::sph3d
