#include <cmath>
#include <map>

#include "core/error.hpp"
#include "sph3d/geometry/edges.hpp"
#include "sph3d/geometry/level_set.hpp"

namespace ostium::sph3d {
namespace {

/// Height above the plane, for points that belong to this end; far below it for all others.
std::vector<double> heights(const Surface<3>& s, const End& end) {
  std::vector<double> h(s.points.size());
  for (std::size_t i = 0; i < h.size(); ++i) {
    const Vec3 x = s.points[i] - end.centre;
    h[i] = x.norm() < end.reach ? x.dot(end.normal) : -end.reach;
  }
  return h;
}

/// Points near the plane are moved into it along the wall, which is nearly normal to it: no slivers arise.
void snap(Surface<3>& s, std::vector<double>& h, const End& end, double tolerance) {
  for (std::size_t i = 0; i < h.size(); ++i)
    if (std::abs(h[i]) < tolerance) s.points[i] -= h[i] * end.normal, h[i] = 0;
}

/// The point where the edge crosses the plane, the same for both triangles of the edge.
int crossing(Surface<3>& s, const std::vector<double>& h, std::map<std::pair<int, int>, int>& made, int a,
             int b) {
  const auto [lower, upper] = std::minmax(a, b);
  const auto [at, is_new] = made.try_emplace({lower, upper}, int(s.points.size()));
  if (is_new) {
    const double t = h[lower] / (h[lower] - h[upper]);
    s.points.push_back(s.points[lower] + t * (s.points[upper] - s.points[lower]));
  }
  return at->second;
}

/// What of the triangle lies on or below the plane, as a polygon.
std::vector<int> below(Surface<3>& s, const std::vector<double>& h, std::map<std::pair<int, int>, int>& made,
                       const Triangle& t) {
  std::vector<int> polygon;
  for (int k = 0; k < 3; ++k) {
    const int a = t[k], b = t[(k + 1) % 3];
    if (h[a] <= 0) polygon.push_back(a);
    if ((h[a] < 0 && h[b] > 0) || (h[a] > 0 && h[b] < 0)) polygon.push_back(crossing(s, h, made, a, b));
  }
  return polygon;
}

void add_cap(Surface<3>& s, const End& end, int label) {
  std::vector<std::pair<int, int>> sides;
  for_each_edge(edge_uses(s.facets), [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 1) return;
    const bool along = forward(s.facets, uses[0]);
    sides.emplace_back(along ? uses[0].upper : uses[0].lower, along ? uses[0].lower : uses[0].upper);
  });
  const auto rims = loops(std::move(sides));
  if (rims.size() != 1)
    user_error(
        "the end at ({:.4g}, {:.4g}, {:.4g}) m cannot be cut cleanly: branches touch or are too short for "
        "their fillet; make them longer, thinner, or the fillet smaller",
        end.centre.x(), end.centre.y(), end.centre.z());
  const int middle = int(s.points.size());
  s.points.push_back(end.centre);
  for (std::size_t i = 0; i < rims[0].size(); ++i) {
    s.facets.push_back({rims[0][i], rims[0][(i + 1) % rims[0].size()], middle});
    s.label.push_back(label);
  }
}

}  // namespace

void cut(Surface<3>& surface, const End& end, int label, double cell) {
  auto h = heights(surface, end);
  snap(surface, h, end, 0.3 * cell);
  std::map<std::pair<int, int>, int> made;
  Surface<3> kept;
  kept.points = std::move(surface.points);
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    const auto& t = surface.facets[f];
    if (h[t[0]] >= 0 && h[t[1]] >= 0 && h[t[2]] >= 0) continue;
    const auto polygon = below(kept, h, made, t);
    for (std::size_t k = 2; k < polygon.size(); ++k) {
      kept.facets.push_back({polygon[0], polygon[k - 1], polygon[k]});
      kept.label.push_back(surface.label[f]);
    }
  }
  add_cap(kept, end, label);
  surface = std::move(kept);
}

}  // namespace ostium::sph3d
