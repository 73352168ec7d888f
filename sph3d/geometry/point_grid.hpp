/// Points sorted into cubes (squares), to find those near a place.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/vec.hpp"

namespace ostium::sph3d {

template <int D>
class PointGrid {
 public:
  PointGrid(const std::vector<Vec<D>>& points, double reach) : points_(points), reach_(reach) {
    for (int i = 0; i < int(points.size()); ++i) cubes_[key(cube(points[i]))].push_back(i);
  }

  /// Calls visit(j, x - x_j) for every point within the reach of x, in a fixed order.
  template <class Visit>
  void near(const Vec<D>& x, Visit visit) const {
    const Cube own = cube(x);
    for (int n = 0; n < (D == 3 ? 27 : 9); ++n) {
      const Cube c = beside(own, n);
      const auto at = cubes_.find(key(c));
      if (at == cubes_.end()) continue;
      for (int j : at->second) {
        const Vec<D> apart = x - points_[j];
        // Two cubes may share a key: the cube of the point decides which visit finds it.
        if (apart.squaredNorm() < reach_ * reach_ && cube(points_[j]) == c) visit(j, apart);
      }
    }
  }

 private:
  using Cube = std::array<std::int64_t, D>;
  static Cube beside(Cube c, int n) {
    for (int d = 0; d < D; ++d, n /= 3) c[d] += n % 3 - 1;
    return c;
  }
  Cube cube(const Vec<D>& x) const {
    Cube c;
    for (int d = 0; d < D; ++d) c[d] = std::int64_t(std::floor(x[d] / reach_));
    return c;
  }
  static std::uint64_t key(const Cube& c) {
    std::uint64_t k = 0;
    for (auto v : c) k = (k ^ std::uint64_t(v)) * 0x9E3779B97F4A7C15u;
    return k;
  }

  const std::vector<Vec<D>>& points_;
  double reach_;
  std::unordered_map<std::uint64_t, std::vector<int>> cubes_;
};

}  // namespace ostium::sph3d
