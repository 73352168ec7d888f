/// The point of a vessel's wall, its openings left out, that is nearest to a place. Looks at every facet: for
/// a few places.
#pragma once
#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

template <int D>
struct PlaceOnWall {
  Vec<D> point, normal;  ///< m; unit normal of its facet, out of the vessel
};

template <int D>
PlaceOnWall<D> nearest_on_wall(const Surface<D>& surface, const Vec<D>& x);

}  // namespace ostium::sph3d
