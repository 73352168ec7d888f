/// Pairs of triangles that cut one another. Internal to geometry/.
///
/// Edge against triangle, both ways, for pairs without a common corner whose boxes overlap; touching in one plane
/// does not count.
#pragma once
#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

std::vector<std::pair<int, int>> self_intersections(const Surface<3>& surface);

}  // namespace ostium::sph3d
