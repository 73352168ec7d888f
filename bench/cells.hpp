/// Points sorted into cells of one reach, to visit those near a place in a fixed order.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/vec.hpp"

namespace ostium::bench {

template <int D>
class Cells {
 public:
  /// At least one point; the points must outlive the cells.
  Cells(const std::vector<Vec<D>>& points, double reach) : points_(points), reach_(reach) {
    Vec<D> upper = points.front();
    lower_ = upper;
    for (const Vec<D>& x : points) lower_ = lower_.cwiseMin(x), upper = upper.cwiseMax(x);
    for (int d = 0; d < D; ++d) count_[d] = static_cast<int>((upper[d] - lower_[d]) / reach) + 1;
    members_.resize(D == 2 ? count_[0] * count_[1] : count_[0] * count_[1] * count_[D - 1]);
    for (int j = 0; j < int(points.size()); ++j) members_[number(cell(points[j]))].push_back(j);
  }

  /// Calls visit(j, x - x_j) for every point within the reach of x.
  template <class Visit>
  void near(const Vec<D>& x, Visit visit) const {
    const Cell centre = cell(x);
    for (int n = 0; n < (D == 2 ? 9 : 27); ++n) {
      const int offset[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
      Cell c;
      bool inside = true;
      for (int d = 0; d < D; ++d) {
        c[d] = centre[d] + offset[d];
        inside = inside && c[d] >= 0 && c[d] < count_[d];
      }
      if (!inside) continue;
      for (const int j : members_[number(c)])
        if (const Vec<D> r = x - points_[j]; r.squaredNorm() < reach_ * reach_) visit(j, r);
    }
  }

 private:
  using Cell = std::array<int, D>;

  Cell cell(const Vec<D>& x) const {
    Cell c;
    for (int d = 0; d < D; ++d) c[d] = static_cast<int>(std::floor((x[d] - lower_[d]) / reach_));
    return c;
  }
  std::size_t number(const Cell& c) const {
    std::size_t n = c[D - 1];
    for (int d = D - 2; d >= 0; --d) n = n * count_[d] + c[d];
    return n;
  }

  const std::vector<Vec<D>>& points_;
  double reach_;
  Vec<D> lower_;
  Cell count_;
  std::vector<std::vector<int>> members_;
};

}  // namespace ostium::bench
