/// Points spread evenly over the wall of a vessel, each in the middle of its patch. Internal to shell/.
///
///   position   on the surface                                              m
///   normal     of the facet there, out of the blood                        -
///   area       1 / sum of the reduced kernel, scaled; the sum is the area of the wall     m^(D-1)
///
/// Low-discrepancy samples, three for each point, then elimination, then relaxation: every point goes down the gradient of the
/// kernel sum in its tangent plane and back to the nearest point of the surface. At the rims the wall sees itself in a mirror, so
/// that the last row stands half a spacing inside and kernel sums are whole. In 2D points divide each stretch of wall from one
/// opening to the next into equal parts, and nothing needs to relax.
///
/// The same surface gives the same points, for any number of threads.
#pragma once
#include "sph3d/geometry/surface.hpp"
#include "sph3d/shell/rim.hpp"

namespace ostium::sph3d {

template <int D>
struct SurfacePoints {
  std::vector<Vec<D>> position, normal;
  std::vector<double> area;
};

/// About area/spacing^(D-1) points on a wall without openings (lateral()).
SurfacePoints<2> surface_points(const Surface<2>& wall, const std::vector<Rim<2>>& rims, double spacing,
                                int iterations);
SurfacePoints<3> surface_points(const Surface<3>& wall, const std::vector<Rim<3>>& rims, double spacing,
                                int iterations);

}  // namespace ostium::sph3d
