/// Normals of facets, edges and corners with which the sign of a distance is right. Internal to geometry/.
#pragma once
#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

template <int D>
using FeatureNormals = std::array<Vec<D>, D == 3 ? 7 : 3>;

/// Unit normal per facet; those without area take the mean of their neighbours.
std::vector<Vec3> facet_normals(const Surface<3>& surface);

/// Per facet in the order of the features of closest_on_facet().
template <int D>
std::vector<FeatureNormals<D>> pseudo_normals(const Surface<D>& surface);

}  // namespace ostium::sph3d
