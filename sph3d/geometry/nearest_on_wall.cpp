#include "sph3d/geometry/nearest_on_wall.hpp"

#include "sph3d/geometry/closest_point.hpp"

namespace ostium::sph3d {

template <int D>
PlaceOnWall<D> nearest_on_wall(const Surface<D>& surface, const Vec<D>& x) {
  PlaceOnWall<D> nearest{Vec<D>::Zero(), Vec<D>::Zero()};
  double least = 1e300;
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    if (surface.label[f] >= 0) continue;
    std::array<Vec<D>, D> corners;
    for (int k = 0; k < D; ++k) corners[k] = surface.points[surface.facets[f][k]];
    const Vec<D> point = closest_on_facet(corners, x).point;
    if ((point - x).squaredNorm() >= least) continue;
    least = (point - x).squaredNorm();
    nearest = {point, area_vector(surface, static_cast<int>(f)).normalized()};
  }
  return nearest;
}

template PlaceOnWall<2> nearest_on_wall(const Surface<2>&, const Vec2&);
template PlaceOnWall<3> nearest_on_wall(const Surface<3>&, const Vec3&);

}  // namespace ostium::sph3d
