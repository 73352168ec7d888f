#include "sph3d/shell/eliminate.hpp"

#include <cmath>
#include <queue>

namespace ostium::sph3d {

namespace {

struct Crowded {
  double crowding;
  std::int32_t sample;

  /// The first of equals goes first.
  bool operator<(const Crowded& o) const {
    return crowding != o.crowding ? crowding < o.crowding : sample > o.sample;
  }
};

}  // namespace

std::vector<std::int32_t> eliminate(const std::vector<Vec3>& position, const std::vector<Vec3>& normal,
                                    const std::vector<Rim<3>>& rims, std::size_t keep, double area) {
  const double d = 2.0 * std::sqrt(area / (2.0 * std::sqrt(3.0) * static_cast<double>(keep)));
  const SurfacePairs<3> pairs(position, normal, rims, d);
  const auto push = [&](std::size_t a, const SurfacePair& pair) {
    return std::pow(std::max(1.0 - (position[a] - seen(pair, position, rims)).norm() / d, 0.0), 8);
  };
  std::vector<double> crowding(position.size(), 0.0);
  std::priority_queue<Crowded> queue;
  for (std::size_t a = 0; a < position.size(); ++a) {
    for (const auto& pair : pairs.of(a)) crowding[a] += push(a, pair);
    queue.push({crowding[a], static_cast<std::int32_t>(a)});
  }
  std::vector<char> gone(position.size(), 0);
  for (std::size_t left = position.size(); left > keep;) {
    const auto [was, a] = queue.top();
    queue.pop();
    if (gone[a] || was != crowding[a])
      continue;  // it has become less crowded and stands further back as well
    gone[a] = 1, --left;
    for (const auto& pair : pairs.of(a)) {
      if (gone[pair.other]) continue;
      crowding[pair.other] -= push(a, pair);
      queue.push({crowding[pair.other], pair.other});
    }
  }
  std::vector<std::int32_t> stay;
  for (std::size_t a = 0; a < position.size(); ++a)
    if (!gone[a]) stay.push_back(static_cast<std::int32_t>(a));
  return stay;
}

}  // namespace ostium::sph3d
