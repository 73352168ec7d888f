#include "sph3d/shell/lateral.hpp"

#include <fmt/format.h>

namespace ostium::sph3d {

template <int D>
Surface<D> lateral(const Surface<D>& surface) {
  Surface<D> wall{.points = surface.points, .facets = {}, .label = {}};
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    if (surface.label[f] < 0) wall.facets.push_back(surface.facets[f]), wall.label.push_back(-1);
  return wall;
}

template <>
std::string place<2>(const Vec2& x) {
  return fmt::format("at ({:.4g}, {:.4g}) m", x[0], x[1]);
}

template <>
std::string place<3>(const Vec3& x) {
  return fmt::format("at ({:.4g}, {:.4g}, {:.4g}) m", x[0], x[1], x[2]);
}

template Surface<2> lateral(const Surface<2>&);
template Surface<3> lateral(const Surface<3>&);

}  // namespace ostium::sph3d
