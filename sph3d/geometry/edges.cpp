#include "sph3d/geometry/edges.hpp"

#include <algorithm>
#include <tuple>

namespace ostium::sph3d {

std::vector<EdgeUse> edge_uses(std::span<const Triangle> facets) {
  std::vector<EdgeUse> uses;
  uses.reserve(3 * facets.size());
  for (int f = 0; f < int(facets.size()); ++f)
    for (int s = 0; s < 3; ++s) {
      const auto [lower, upper] = std::minmax({facets[f][s], facets[f][(s + 1) % 3]});
      uses.push_back({lower, upper, f, s});
    }
  std::sort(uses.begin(), uses.end(), [](const EdgeUse& a, const EdgeUse& b) {
    return std::tie(a.lower, a.upper, a.facet, a.slot) < std::tie(b.lower, b.upper, b.facet, b.slot);
  });
  return uses;
}

std::vector<Triangle> neighbours(std::span<const Triangle> facets) {
  std::vector<Triangle> beyond(facets.size(), {-1, -1, -1});
  for_each_edge(edge_uses(facets), [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 2) return;
    beyond[uses[0].facet][uses[0].slot] = uses[1].facet;
    beyond[uses[1].facet][uses[1].slot] = uses[0].facet;
  });
  return beyond;
}

std::vector<std::vector<int>> loops(std::vector<std::pair<int, int>> edges) {
  std::sort(edges.begin(), edges.end());
  std::vector<char> used(edges.size(), 0);
  const auto next_from = [&](int point) {
    auto i = std::lower_bound(edges.begin(), edges.end(), std::pair(point, -1)) - edges.begin();
    while (i < std::ssize(edges) && edges[i].first == point && used[i]) ++i;
    return i < std::ssize(edges) && edges[i].first == point ? i : std::ssize(edges);
  };
  std::vector<std::vector<int>> found;
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (used[start]) continue;
    std::vector<int> loop;
    for (auto i = std::ptrdiff_t(start); i < std::ssize(edges); i = next_from(edges[i].second)) {
      used[i] = 1;
      loop.push_back(edges[i].first);
      if (edges[i].second == loop.front()) break;
    }
    found.push_back(std::move(loop));
  }
  return found;
}

}  // namespace ostium::sph3d
