#include <algorithm>

#include "core/error.hpp"
#include "sph3d/geometry/find_openings.hpp"
#include "sph3d/geometry/repair.hpp"

namespace ostium::sph3d {
namespace {

/// Distance from x along `direction` to the facet; infinite when the ray misses it.
double ray(const Surface<3>& surface, int f, const Vec3& x, const Vec3& direction) {
  constexpr double miss = std::numeric_limits<double>::infinity();
  const auto& corner = surface.facets[f];
  const Vec3 a = surface.points[corner[0]], ab = surface.points[corner[1]] - a,
             ac = surface.points[corner[2]] - a;
  const Vec3 p = direction.cross(ac), ax = x - a, q = ax.cross(ab);
  const double det = ab.dot(p);
  if (det == 0) return miss;
  const double u = ax.dot(p) / det, v = direction.dot(q) / det, distance = ac.dot(q) / det;
  return u < 0 || v < 0 || u + v > 1 || distance <= 0 ? miss : distance;
}

/// How far the vessel reaches inward from the region, relative to the region's size.
double depth(const Surface<3>& surface, const Region& r) {
  const double size = std::sqrt(r.area());
  const Vec3 inward = -r.normal(), start = r.centre + 1e-3 * size * inward;
  double nearest = std::numeric_limits<double>::infinity();
  for (int f = 0; f < int(surface.facets.size()); ++f)
    nearest = std::min(nearest, ray(surface, f, start, inward));
  return std::isfinite(nearest) ? nearest / size : 0;
}

std::vector<std::vector<int>> touching(const SurfaceTopology& t, const std::vector<Region>& regions) {
  std::vector<int> owner(t.surface.facets.size(), -1);
  for (int r = 0; r < int(regions.size()); ++r)
    for (int f : regions[r].facets) owner[f] = r;
  std::vector<std::vector<int>> others(regions.size());
  for (int f = 0; f < int(owner.size()); ++f)
    for (int g : t.beyond[f])
      if (owner[f] >= 0 && g >= 0 && owner[g] >= 0 && owner[g] != owner[f])
        others[owner[f]].push_back(owner[g]);
  return others;
}

}  // namespace

std::vector<Region> without_touching(const SurfaceTopology& t, std::vector<Region> regions) {
  const auto others = touching(t, regions);
  std::vector<double> deep(regions.size(), std::numeric_limits<double>::infinity());
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (!others[r].empty()) deep[r] = depth(t.surface, regions[r]);
  std::vector<char> keep(regions.size(), 1);
  for (std::size_t r = 0; r < regions.size(); ++r)
    for (int other : others[r]) {
      constexpr double clearly = 1.2;
      if (deep[r] < deep[other]) keep[r] = 0;
      const bool alike = deep[r] < clearly * deep[other] && deep[other] < clearly * deep[r];
      const bool best =
          std::all_of(others[r].begin(), others[r].end(), [&](int o) { return deep[o] <= deep[r]; });
      if (alike && best)
        user_error(
            "the flat parts of the surface at {} and {} touch and are equally deep: which of them is an "
            "opening cannot be told from the shape; give the file a ModelFaceID per face",
            place(regions[r].centre), place(regions[other].centre));
    }
  std::vector<Region> kept;
  for (std::size_t r = 0; r < regions.size(); ++r)
    if (keep[r]) kept.push_back(std::move(regions[r]));
  return kept;
}

}  // namespace ostium::sph3d
