/// Fields of the wall points on the corners of the input surface, and where those corners are when the wall has moved.
///
///   f_i = sum_b w_ib f_b,   x_i = X_i + sum_b w_ib (x_b - X_b)      w: mapping in point_weights.hpp, of the wall at rest
///
/// Corners that no wall point is near, those inside the openings, get zero and stay. Source: docs/theory/walls.md, "Wall
/// fields". Not checked: that the triangles of the surface resolve the fields.
#pragma once
#include "sph3d/fields/point_weights.hpp"
#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

template <int D>
class SurfaceMap {
 public:
  /// h: smoothing length of the weights, m.
  SurfaceMap(const Surface<D>& surface, const std::vector<WallPoint<D>>& rest, double h);

  template <class T>
  std::vector<T> operator()(const std::vector<T>& on_wall) const {
    std::vector<T> mapped(weights_.count());
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < mapped.size(); ++i) mapped[i] = weights_.at(i, on_wall, zero<T>());
    return mapped;
  }
  /// The surface with its wall where it is now.
  Surface<D> moved(const std::vector<WallPoint<D>>& rest, const std::vector<WallPoint<D>>& now) const;

 private:
  template <class T>
  static T zero() {
    if constexpr (std::is_arithmetic_v<T>)
      return T(0);
    else
      return T::Zero();
  }
  Surface<D> surface_;
  PointWeights weights_;
};

extern template class SurfaceMap<2>;
extern template class SurfaceMap<3>;

}  // namespace ostium::sph3d
