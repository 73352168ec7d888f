#include "sph3d/geometry/stretches.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::sph3d {

namespace {

/// The facet that follows on each point, and whether one ends there.
struct Chain {
  std::vector<int> next;
  std::vector<char> reached;

  explicit Chain(const Surface<2>& s) : next(s.points.size(), -1), reached(s.points.size(), 0) {
    for (int f = 0; f < static_cast<int>(s.facets.size()); ++f)
      if (s.label[f] < 0) next[s.facets[f][0]] = f, reached[s.facets[f][1]] = 1;
  }
};

double length_of(const Surface<2>& s, const std::vector<int>& stretch) {
  double length = 0;
  for (int f : stretch) length += area_vector(s, f).norm();
  return length;
}

}  // namespace

std::vector<std::vector<int>> stretches(const Surface<2>& s) {
  const Chain chain(s);
  std::vector<char> taken(s.facets.size(), 0);
  std::vector<std::vector<int>> found;
  const auto follow = [&](int start) {
    std::vector<int> stretch;
    for (int f = start; f >= 0 && !taken[f]; f = chain.next[s.facets[f][1]])
      taken[f] = 1, stretch.push_back(f);
    found.push_back(std::move(stretch));
  };
  const int n = static_cast<int>(s.facets.size());
  for (int f = 0; f < n; ++f)
    if (s.label[f] < 0 && !chain.reached[s.facets[f][0]]) follow(f);
  for (int f = 0; f < n; ++f)
    if (s.label[f] < 0 && !taken[f]) follow(f);  // closed
  return found;
}

std::vector<WallPoint<2>> spread_evenly(const Surface<2>& s, double spacing) {
  std::vector<WallPoint<2>> points;
  for (const auto& stretch : stretches(s)) {
    const double length = length_of(s, stretch);
    const int count = std::max(1, static_cast<int>(std::lround(length / spacing)));
    double passed = 0;
    int k = 0;
    for (int f : stretch) {
      const Vec2 a = s.points[s.facets[f][0]], along = s.points[s.facets[f][1]] - a;
      for (; k < count && (k + 0.5) * length / count <= passed + along.norm(); ++k)
        points.push_back({a + along.normalized() * ((k + 0.5) * length / count - passed),
                          area_vector(s, f).normalized(), length / count});
      passed += along.norm();
    }
  }
  return points;
}

}  // namespace ostium::sph3d
