#include "sph3d/shell/surface_pairs.hpp"

#include "sph3d/geometry/point_grid.hpp"

namespace ostium::sph3d {

namespace {

/// The two sides of a right angle see each other, whatever rounding says.
constexpr double opposed = -1e-6;

}  // namespace

template <int D>
SurfacePairs<D>::SurfacePairs(const std::vector<Vec<D>>& position, const std::vector<Vec<D>>& normal,
                              const std::vector<Rim<D>>& rims, double reach) {
  const PointGrid<D> grid(position, reach);
  const auto n = static_cast<std::int64_t>(position.size());
  std::vector<std::vector<SurfacePair>> of(position.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t a = 0; a < n; ++a) {
    grid.near(position[a], [&](int b, const Vec<D>&) {
      if (b != a && normal[a].dot(normal[b]) > opposed) of[a].push_back({b, -1});
    });
    for (int k = 0; k < static_cast<int>(rims.size()); ++k) {
      if (!rims[k].near(position[a], reach)) continue;
      // The distance to an image is that of the own image to the other.
      const Vec<D> turned = rims[k].turned(normal[a]);
      grid.near(rims[k].mirrored(position[a]), [&](int b, const Vec<D>&) {
        if (turned.dot(normal[b]) > opposed) of[a].push_back({b, k});
      });
    }
  }
  begin_.assign(1, 0);
  for (const auto& row : of) {
    pairs_.insert(pairs_.end(), row.begin(), row.end());
    begin_.push_back(pairs_.size());
  }
}

template class SurfacePairs<2>;
template class SurfacePairs<3>;

}  // namespace ostium::sph3d
