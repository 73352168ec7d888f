/// Points in an order in which neighbours are mostly near in memory, to find those within a distance of a place.
///
/// Eight consecutive points have a ball around them, eight such balls another one, and so on; any order is right, a nested
/// bisection is fast. Found in the order of memory.
#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"

namespace ostium::sph3d {

template <int D>
class BallTree {
 public:
  explicit BallTree(const std::vector<Vec<D>>& points) : points_(points) {
    std::vector<Ball> below;
    for (const auto& x : points) below.push_back({x, 0.0});
    while (below.size() > 1) {
      std::vector<Ball> level;
      for (std::size_t k = 0; k < below.size(); k += 8)
        level.push_back(around(&below[k], &below[0] + std::min(k + 8, below.size())));
      levels_.push_back(level);
      below = std::move(level);
    }
  }

  /// visit(index) for every point within a distance of x.
  template <class Visit>
  void near(const Vec<D>& x, double distance, Visit&& visit) const {
    if (!levels_.empty())
      descend(levels_.size(), 0, x, distance, visit);
    else if (!points_.empty() && (points_[0] - x).norm() < distance)
      visit(0);
  }

 private:
  struct Ball {
    Vec<D> middle;
    double radius;
  };
  static Ball around(const Ball* begin, const Ball* end) {
    Vec<D> low = begin->middle, high = low;
    for (const Ball* b = begin; b != end; ++b) low = low.cwiseMin(b->middle), high = high.cwiseMax(b->middle);
    Ball ball{0.5 * (low + high), 0.0};
    for (const Ball* b = begin; b != end; ++b)
      ball.radius = std::max(ball.radius, (b->middle - ball.middle).norm() + b->radius);
    return ball;
  }

  /// The points below ball k of a level; level 0 are the points themselves.
  template <class Visit>
  void descend(std::size_t level, std::size_t k, const Vec<D>& x, double distance, Visit& visit) const {
    if (level == 0) {
      if ((points_[k] - x).squaredNorm() < distance * distance) visit(static_cast<std::int32_t>(k));
      return;
    }
    const Ball& ball = levels_[level - 1][k];
    const double within = distance + ball.radius;
    if ((ball.middle - x).squaredNorm() >= within * within) return;
    const std::size_t count = level == 1 ? points_.size() : levels_[level - 2].size();
    for (std::size_t c = 8 * k; c < std::min(8 * k + 8, count); ++c)
      descend(level - 1, c, x, distance, visit);
  }

  const std::vector<Vec<D>>& points_;
  std::vector<std::vector<Ball>> levels_;
};

}  // namespace ostium::sph3d
