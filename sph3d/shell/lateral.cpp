#include "sph3d/shell/lateral.hpp"

#include <fmt/format.h>

#include <cmath>

namespace ostium::sph3d {

template <int D>
Surface<D> lateral(const Surface<D>& surface) {
  Surface<D> wall{.points = surface.points, .facets = {}, .label = {}};
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    if (surface.label[f] < 0) wall.facets.push_back(surface.facets[f]), wall.label.push_back(-1);
  return wall;
}

template <int D>
std::string place(const Vec<D>& x) {
  const auto mm = [](double metres) { return std::abs(metres) < 1e-9 ? 0.0 : 1e3 * metres; };
  if constexpr (D == 2)
    return fmt::format("at ({:.4g}, {:.4g}) mm", mm(x[0]), mm(x[1]));
  else
    return fmt::format("at ({:.4g}, {:.4g}, {:.4g}) mm", mm(x[0]), mm(x[1]), mm(x[2]));
}

template std::string place<2>(const Vec2&);
template std::string place<3>(const Vec3&);
template Surface<2> lateral(const Surface<2>&);
template Surface<3> lateral(const Surface<3>&);

}  // namespace ostium::sph3d
