/// The openings of a closed surface. Internal to geometry/.
///
///   labelled   connected parts of a face id that are nearly plane
///   capped     the caps of ends that were open
///   flat       regions grown over plane neighbours whose rim bends away sharply and inward all around
///
/// A flat region is told from an opening by what surrounds it: an opening meets wall, never another opening.
/// Where flat regions touch (a vessel of plane walls) the ones that are deepest for their size are the
/// openings.
#pragma once
#include "sph3d/geometry/soup.hpp"

namespace ostium::sph3d {

/// Sorted by falling area, named opening1, ...; writes surface.label.
std::vector<Opening<3>> find_openings(Surface<3>& surface, const Soup& soup);

/// A connected set of facets that may be an opening.
struct Region {
  std::vector<int> facets;
  Vec3 area_vector = Vec3::Zero(), centre = Vec3::Zero();
  double unevenness = 0;
  int face_id = -1;
  double area() const { return area_vector.norm(); }
  Vec3 normal() const { return area_vector.normalized(); }
};

/// What the searches share.
struct SurfaceTopology {
  const Surface<3>& surface;
  std::vector<Vec3> normal;
  std::vector<Triangle> beyond;  ///< facet across each side
};

Region measure(const SurfaceTopology& topology, std::vector<int> facets);
/// Connected parts of the facets that share a value of `key`; negative keys are left out.
std::vector<Region> parts(const SurfaceTopology& topology, const std::vector<int>& key);
/// Plane regions with a sharp, convex rim among the facets that are not `taken`.
std::vector<Region> flat_regions(const SurfaceTopology& topology, const std::vector<char>& taken);
/// Share of the rim, by length, along which the surface bends sharply back into the vessel; `number`: per facet the region.
double sharp_share(const SurfaceTopology& topology, const Region& region, const std::vector<int>& number);
/// Specks of a coarse or stepped wall pass every local test, but no vessel ends in one so small.
void drop_specks(std::vector<Region>& regions, const Surface<3>& surface);
/// By how much an opening of this area may leave its plane, m: labelled faces may have rounded rims, a wall never comes near
/// that; without labels only what is exactly plane is told from a wall.
double allowed_unevenness(double area, bool labelled);
/// Of regions that touch one another, those that are deep for their size; refuses what cannot be told.
std::vector<Region> without_touching(const SurfaceTopology& topology, std::vector<Region> regions);

}  // namespace ostium::sph3d
