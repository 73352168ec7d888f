#include <algorithm>
#include <numeric>

#include "sph3d/geometry/point_grid.hpp"
#include "sph3d/geometry/repair.hpp"

namespace ostium::sph3d {
namespace {

/// Rewrites corners through `target` and drops points that nobody uses.
void renumber(Soup& soup, const std::vector<int>& target) {
  std::vector<int> number(soup.points.size(), -1);
  std::vector<Vec3> points;
  for (auto& facet : soup.facets)
    for (int& v : facet) {
      int& n = number[target[v]];
      if (n < 0) n = int(points.size()), points.push_back(soup.points[target[v]]);
      v = n;
    }
  soup.points = std::move(points);
}

std::vector<int> same_points(const std::vector<Vec3>& points) {
  std::vector<int> order(points.size()), target(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) { return std::tuple(points[i].x(), points[i].y(), points[i].z(), i); };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  for (std::size_t i = 0; i < order.size(); ++i)
    target[order[i]] = i > 0 && points[order[i]] == points[order[i - 1]] ? target[order[i - 1]] : order[i];
  return target;
}

int drop_degenerate(Soup& soup) {
  std::vector<char> keep(soup.facets.size());
  for (std::size_t f = 0; f < keep.size(); ++f) {
    const auto [a, b, c] = soup.facets[f];
    keep[f] = a != b && b != c && c != a;
  }
  keep_facets(soup, keep);
  return int(std::count(keep.begin(), keep.end(), 0));
}

int drop_doubled(Soup& soup) {
  std::vector<int> order(soup.facets.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<Triangle> sorted = soup.facets;
  for (auto& t : sorted) std::sort(t.begin(), t.end());
  std::sort(order.begin(), order.end(),
            [&](int a, int b) { return std::tie(sorted[a], a) < std::tie(sorted[b], b); });
  std::vector<char> keep(soup.facets.size(), 1);
  for (std::size_t i = 1; i < order.size(); ++i)
    if (sorted[order[i]] == sorted[order[i - 1]]) keep[order[i]] = 0;
  keep_facets(soup, keep);
  return int(std::count(keep.begin(), keep.end(), 0));
}

std::vector<int> points_on_open_edges(const Soup& soup) {
  std::vector<int> found;
  for_each_edge(edge_uses(soup.facets), [&](std::span<const EdgeUse> uses) {
    if (uses.size() == 1) found.push_back(uses[0].lower), found.push_back(uses[0].upper);
  });
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

/// Chains of corners closer than the reach, as union-find; the lexicographically smallest stands for all, so that neither
/// the order of the triangles nor that of the corners matters.
class Clusters {
 public:
  Clusters(const std::vector<Vec3>& points, double reach) : parent_(points.size()) {
    std::iota(parent_.begin(), parent_.end(), 0);
    const PointGrid<3> grid(points, reach);
    for (int i = 0; i < int(points.size()); ++i)
      grid.near(points[i], [&](int j, const Vec3&) { join(find(i), find(j)); });
  }
  int find(int i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

 private:
  void join(int a, int b) { parent_[std::max(a, b)] = std::min(a, b); }
  std::vector<int> parent_;
};

/// Slivers have true corners that lie close together: only open edges are joined by distance.
int weld_open_edges(Soup& soup, double share_of_size) {
  auto open = points_on_open_edges(soup);
  if (open.empty()) return 0;
  const auto key = [&](int i) {
    const Vec3& x = soup.points[i];
    return std::tuple(x.x(), x.y(), x.z());
  };
  std::sort(open.begin(), open.end(), [&](int a, int b) { return key(a) < key(b); });
  std::vector<Vec3> points;
  for (const int i : open) points.push_back(soup.points[i]);
  Clusters clusters(points, share_of_size * bounds(soup.points).extent().norm());
  std::vector<int> target(soup.points.size());
  std::iota(target.begin(), target.end(), 0);
  int joined = 0;
  for (int k = 0; k < int(open.size()); ++k)
    if (const int first = clusters.find(k); first != k) target[open[k]] = open[first], ++joined;
  if (joined > 0) renumber(soup, target);
  return joined;
}

void note(Soup& soup, int count, const char* what) {
  if (count > 0) soup.notes.push_back(std::to_string(count) + " " + what);
}

}  // namespace

void keep_facets(Soup& soup, const std::vector<char>& keep) {
  const auto filter = [&](auto& values) {
    std::size_t n = 0;
    for (std::size_t f = 0; f < values.size(); ++f)
      if (keep[f]) values[n++] = values[f];
    values.resize(n);
  };
  filter(soup.facets), filter(soup.face_id), filter(soup.cap);
}

void drop_unused_points(Soup& soup) {
  std::vector<int> itself(soup.points.size());
  std::iota(itself.begin(), itself.end(), 0);
  renumber(soup, itself);
}

void weld(Soup& soup) {
  renumber(soup, same_points(soup.points));
  note(soup, drop_degenerate(soup), "degenerate triangles dropped");
  note(soup, drop_doubled(soup), "doubled triangles dropped");
}

void join_open_edges(Soup& soup) {
  note(soup, weld_open_edges(soup, 1e-6),
       "corners of open edges joined to a neighbour within 1e-6 of the vessel's size");
  note(soup, drop_degenerate(soup), "triangles dropped that this left without area");
}

}  // namespace ostium::sph3d
