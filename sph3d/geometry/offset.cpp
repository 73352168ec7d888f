#include "sph3d/geometry/offset.hpp"

namespace ostium::sph3d {

namespace {

/// The quadratic form whose minimum is the shift of a corner.
template <int D>
struct Corner {
  Mat<D> matrix = Mat<D>::Zero();
  Vec<D> side = Vec<D>::Zero();
  double weight = 0;

  void ask(const Vec<D>& n, double shift, double w) {
    matrix += w * n * n.transpose(), side += w * shift * n;
  }

  Vec<D> shift() const {
    // Along flat parts and straight edges only the shift across them is given; the rest is to be small.
    return (matrix + 1e-6 * weight * Mat<D>::Identity()).ldlt().solve(side) * (1.0 + 1e-6);
  }
};

}  // namespace

template <int D>
Lumen<D> offset(const Lumen<D>& lumen, double distance) {
  const auto& s = lumen.surface;
  std::vector<Corner<D>> corners(s.points.size());
  for (std::size_t f = 0; f < s.facets.size(); ++f) {
    const Vec<D> area = area_vector(s, static_cast<int>(f));
    if (s.label[f] >= 0 || !(area.norm() > 0)) continue;
    for (int v : s.facets[f]) {
      corners[v].weight += area.norm();
      corners[v].ask(area.normalized(), distance, area.norm());
    }
  }
  for (std::size_t f = 0; f < s.facets.size(); ++f)
    if (s.label[f] >= 0)
      for (int v : s.facets[f])
        corners[v].ask(lumen.openings[s.label[f]].normal, 0.0, 100.0 * corners[v].weight);
  Lumen<D> moved = lumen;
  for (std::size_t v = 0; v < corners.size(); ++v)
    if (corners[v].weight > 0) moved.surface.points[v] += corners[v].shift();
  moved.wall_area = area(moved.surface, -1);
  moved.volume = volume(moved.surface);
  return moved;
}

template Lumen<2> offset(const Lumen<2>&, double);
template Lumen<3> offset(const Lumen<3>&, double);

}  // namespace ostium::sph3d
