#include "sph3d/geometry/find_openings.hpp"

#include <algorithm>

#include "sph3d/geometry/pseudo_normals.hpp"

namespace ostium::sph3d {
namespace {

bool nearly_plane(const SurfaceTopology& t, const Region& r) {
  double facets = 0;
  for (int f : r.facets) facets += area_vector(t.surface, f).norm();
  return r.area() > 0.97 * facets && r.unevenness < allowed_unevenness(r.area(), true);
}

std::vector<Region> labelled(const SurfaceTopology& t, const Soup& soup) {
  auto regions = parts(t, soup.face_id);
  for (auto& r : regions) r.face_id = soup.face_id[r.facets.front()];
  std::erase_if(regions, [&](const Region& r) { return !nearly_plane(t, r); });
  return regions;
}

std::vector<Region> candidates(const SurfaceTopology& t, const Soup& soup) {
  std::vector<Region> found, more;
  std::vector<char> taken(t.surface.facets.size(), 0);
  if (!soup.cap.empty()) found = parts(t, soup.cap);
  for (const auto& r : found)
    for (int f : r.facets) taken[f] = 1;
  if (!soup.face_id.empty()) more = labelled(t, soup);
  if (more.empty()) {
    more = flat_regions(t, taken);
    drop_specks(more, t.surface);
  }
  more = without_touching(t, std::move(more));
  found.insert(found.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
  return found;
}

/// The longest loop around the region, counter-clockwise seen from outside.
std::vector<Vec3> outline(const SurfaceTopology& t, const Region& r) {
  std::vector<char> inside(t.surface.facets.size(), 0);
  for (int f : r.facets) inside[f] = 1;
  std::vector<std::pair<int, int>> sides;
  for (int f : r.facets)
    for (int s = 0; s < 3; ++s)
      if (const int g = t.beyond[f][s]; g < 0 || !inside[g])
        sides.emplace_back(t.surface.facets[f][s], t.surface.facets[f][(s + 1) % 3]);
  std::vector<Vec3> longest;
  double length = 0;
  for (const auto& loop : loops(std::move(sides))) {
    std::vector<Vec3> points;
    double around = 0;
    for (int v : loop) points.push_back(t.surface.points[v]);
    for (std::size_t i = 0; i < points.size(); ++i)
      around += (points[(i + 1) % points.size()] - points[i]).norm();
    if (around > length) length = around, longest = std::move(points);
  }
  return longest;
}

Opening<3> make_opening(const SurfaceTopology& t, const Region& r, const Soup& soup) {
  const auto name = soup.face_name.find(r.face_id);
  return {.centre = r.centre,
          .normal = r.normal(),
          .area = r.area(),
          .outline = outline(t, r),
          .face_id = r.face_id,
          .planarity = r.unevenness,
          .face_name = name == soup.face_name.end() ? "" : name->second};
}

}  // namespace

double allowed_unevenness(double area, bool labelled) { return (labelled ? 0.05 : 1e-3) * std::sqrt(area); }

void drop_specks(std::vector<Region>& regions, const Surface<3>& surface) {
  double largest = 0, whole = 0;
  for (const auto& r : regions) largest = std::max(largest, r.area());
  for (int f = 0; f < int(surface.facets.size()); ++f) whole += area_vector(surface, f).norm();
  std::erase_if(regions, [&](const Region& r) { return r.area() < std::max(2e-3 * largest, 2e-4 * whole); });
}

Region measure(const SurfaceTopology& t, std::vector<int> facets) {
  Region r{.facets = std::move(facets)};
  double area = 0;
  for (int f : r.facets) {
    const Vec3 a = area_vector(t.surface, f);
    r.area_vector += a;
    r.centre += a.norm() * centroid(t.surface, f);
    area += a.norm();
  }
  r.centre /= std::max(area, 1e-300);
  const Vec3 n = r.normal();
  for (int f : r.facets)
    for (int v : t.surface.facets[f])
      r.unevenness = std::max(r.unevenness, std::abs((t.surface.points[v] - r.centre).dot(n)));
  return r;
}

std::vector<Region> parts(const SurfaceTopology& t, const std::vector<int>& key) {
  std::vector<char> seen(key.size(), 0);
  std::vector<Region> regions;
  for (int start = 0; start < int(key.size()); ++start) {
    if (seen[start] || key[start] < 0) continue;
    std::vector<int> facets{start};
    seen[start] = 1;
    for (std::size_t i = 0; i < facets.size(); ++i)
      for (int g : t.beyond[facets[i]])
        if (g >= 0 && !seen[g] && key[g] == key[start]) seen[g] = 1, facets.push_back(g);
    regions.push_back(measure(t, std::move(facets)));
  }
  return regions;
}

std::vector<Opening<3>> find_openings(Surface<3>& surface, const Soup& soup) {
  const SurfaceTopology topology{surface, facet_normals(surface), neighbours(surface.facets)};
  auto regions = candidates(topology, soup);
  std::stable_sort(regions.begin(), regions.end(),
                   [](const Region& a, const Region& b) { return a.area() > b.area(); });
  surface.label.assign(surface.facets.size(), -1);
  std::vector<Opening<3>> openings;
  for (const auto& r : regions) {
    for (int f : r.facets) surface.label[f] = int(openings.size());
    openings.push_back(make_opening(topology, r, soup));
    openings.back().name = "opening" + std::to_string(openings.size());
  }
  return openings;
}

}  // namespace ostium::sph3d
