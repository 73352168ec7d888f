#include "sph3d/fields/surface_map.hpp"

namespace ostium::sph3d {

namespace {

/// Area-weighted normals of the wall's facets at the corners of the surface; zero where only openings meet.
template <int D>
std::vector<Vec<D>> corner_normals(const Surface<D>& surface) {
  std::vector<Vec<D>> normals(surface.points.size(), Vec<D>::Zero());
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    if (surface.label[f] >= 0) continue;
    for (const int corner : surface.facets[f]) normals[corner] += area_vector(surface, static_cast<int>(f));
  }
  for (auto& n : normals) n.normalize();
  return normals;
}

}  // namespace

template <int D>
SurfaceMap<D>::SurfaceMap(const Surface<D>& surface, const std::vector<WallPoint<D>>& rest, double h)
    : surface_(surface), weights_(mapping_weights(rest, surface.points, corner_normals(surface), h)) {}

template <int D>
Surface<D> SurfaceMap<D>::moved(const std::vector<WallPoint<D>>& rest,
                                const std::vector<WallPoint<D>>& now) const {
  std::vector<Vec<D>> displacement;
  for (std::size_t b = 0; b < rest.size(); ++b) displacement.push_back(now[b].position - rest[b].position);
  const auto mapped = (*this)(displacement);
  Surface<D> surface = surface_;
  for (std::size_t i = 0; i < mapped.size(); ++i) surface.points[i] += mapped[i];
  return surface;
}

template class SurfaceMap<2>;
template class SurfaceMap<3>;

}  // namespace ostium::sph3d
