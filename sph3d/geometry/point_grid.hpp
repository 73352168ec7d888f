/// Points sorted into cubes, to find those near a place. Internal to geometry/.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/vec.hpp"

namespace ostium::sph3d {

class PointGrid {
 public:
  PointGrid(const std::vector<Vec3>& points, double reach) : points_(points), reach_(reach) {
    for (int i = 0; i < int(points.size()); ++i) cubes_[key(cube(points[i]))].push_back(i);
  }

  /// Calls visit(j, x - x_j) for every point within the reach of x, in a fixed order.
  template <class Visit>
  void near(const Vec3& x, Visit visit) const {
    const Cube c = cube(x);
    for (int n = 0; n < 27; ++n) {
      const auto at = cubes_.find(key({c[0] + n % 3 - 1, c[1] + n / 3 % 3 - 1, c[2] + n / 9 - 1}));
      if (at == cubes_.end()) continue;
      for (int j : at->second) {
        const Vec3 apart = x - points_[j];
        // Two cubes may share a key: the cube of the point decides which visit finds it.
        if (apart.squaredNorm() < reach_ * reach_ && within(c, cube(points_[j]), n)) visit(j, apart);
      }
    }
  }

 private:
  using Cube = std::array<std::int64_t, 3>;
  static bool within(const Cube& c, const Cube& p, int n) {
    return p[0] == c[0] + n % 3 - 1 && p[1] == c[1] + n / 3 % 3 - 1 && p[2] == c[2] + n / 9 - 1;
  }
  Cube cube(const Vec3& x) const {
    Cube c;
    for (int d = 0; d < 3; ++d) c[d] = std::int64_t(std::floor(x[d] / reach_));
    return c;
  }
  static std::uint64_t key(const Cube& c) {
    std::uint64_t k = 0;
    for (auto v : c) k = (k ^ std::uint64_t(v)) * 0x9E3779B97F4A7C15u;
    return k;
  }

  const std::vector<Vec3>& points_;
  double reach_;
  std::unordered_map<std::uint64_t, std::vector<int>> cubes_;
};

}  // namespace ostium::sph3d
