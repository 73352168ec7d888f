/// Points on the wall of a vessel, evenly spread: where pressure and wall shear stress are reported.
///
///   position  m    on the wall
///   normal    -    outward unit normal, smoothed over one spacing
///   area      m2   share of the wall (2D: m); the shares add up to Lumen::wall_area
///
/// About wall_area/spacing^(D-1) points, from a low-discrepancy sequence over the cumulated facet area, then
/// relaxed on the surface by the gradient of the reduced kernel (Zhang, Hu & Adams 2017 for volumes; here in
/// the tangent plane, without pairs that face each other across the lumen). The same lumen gives the same
/// points.
#pragma once
#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

template <int D>
struct WallPoint {
  Vec<D> position, normal;
  double area;
};

template <int D>
std::vector<WallPoint<D>> sample_wall(const Lumen<D>& lumen, double spacing);

}  // namespace ostium::sph3d
