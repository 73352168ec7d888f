#include <algorithm>
#include <numeric>
#include <unordered_map>

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

/// Cells of the width of the tolerance: near points lie in neighbouring cells.
class Grid {
 public:
  Grid(const std::vector<Vec3>& points, double width) : points_(points), width_(width) {}
  void add(int i) { cells_[key(cell(i), 0)].push_back(i); }

  /// A point added before that lies within the width of i; -1 if there is none.
  int near(int i) const {
    for (int n = 0; n < 27; ++n) {
      const auto at = cells_.find(key(cell(i), n));
      if (at == cells_.end()) continue;
      for (int j : at->second)
        if ((points_[i] - points_[j]).norm() <= width_) return j;
    }
    return -1;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  Cell cell(int i) const {
    Cell c;
    for (int d = 0; d < 3; ++d) c[d] = std::int64_t(std::floor(points_[i][d] / width_));
    return c;
  }
  static std::uint64_t key(const Cell& c, int n) {  // n = 0 the cell itself, then its neighbours
    const int shift[3] = {(n + 1) % 3 - 1, (n / 3 + 1) % 3 - 1, (n / 9 + 1) % 3 - 1};
    std::uint64_t k = 0;
    for (int d = 0; d < 3; ++d) k = (k ^ std::uint64_t(c[d] + shift[d])) * 0x9E3779B97F4A7C15u;
    return k;
  }

  const std::vector<Vec3>& points_;
  double width_;
  std::unordered_map<std::uint64_t, std::vector<int>> cells_;
};

/// Slivers have true corners that lie close together: only open edges are joined by distance.
int weld_open_edges(Soup& soup) {
  const auto open = points_on_open_edges(soup);
  if (open.empty()) return 0;
  std::vector<int> target(soup.points.size());
  std::iota(target.begin(), target.end(), 0);
  Grid grid(soup.points, 1e-6 * bounds(soup.points).extent().norm());
  int joined = 0;
  for (int i : open) {
    const int j = grid.near(i);
    if (j < 0)
      grid.add(i);
    else
      target[i] = j, ++joined;
  }
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
  note(soup, weld_open_edges(soup),
       "corners of open edges joined to a neighbour within 1e-6 of the vessel's size");
  note(soup, drop_degenerate(soup), "triangles dropped that this left without area");
}

}  // namespace ostium::sph3d
