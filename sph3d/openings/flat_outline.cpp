#include "sph3d/openings/flat_outline.hpp"

namespace ostium::sph3d {

Surface<2> flat_outline(const Opening<3>& opening, const Eigen::Matrix<double, 3, 2>& frame) {
  Surface<2> polygon;
  const int n = static_cast<int>(opening.outline.size());
  double twice_area = 0;
  for (int k = 0; k < n; ++k)
    polygon.points.push_back(frame.transpose() * (opening.outline[k] - opening.centre));
  for (int k = 0; k < n; ++k) {
    const Vec2 &a = polygon.points[k], &b = polygon.points[(k + 1) % n];
    twice_area += a[0] * b[1] - a[1] * b[0];
  }
  for (int k = 0; k < n; ++k)  // the inside is on the left of a counter-clockwise polygon
    polygon.facets.push_back(twice_area > 0 ? std::array<int, 2>{k, (k + 1) % n}
                                            : std::array<int, 2>{(k + 1) % n, k});
  polygon.label.assign(n, -1);
  return polygon;
}

}  // namespace ostium::sph3d
