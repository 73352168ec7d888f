#include "sph3d/geometry/polygon.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "sph3d/geometry/outline.hpp"

namespace ostium::sph3d {
namespace {

double side(const Vec2& a, const Vec2& b, const Vec2& x) {
  return (b - a).x() * (x - a).y() - (b - a).y() * (x - a).x();
}

bool crossing(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  const bool apart = (a.cwiseMax(b).array() < c.cwiseMin(d).array()).any() ||
                     (c.cwiseMax(d).array() < a.cwiseMin(b).array()).any();
  return !apart && side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

void check_simple(std::span<const Vec2> p) {
  const int n = int(p.size());
  if (n < 3) user_error("outline: a closed outline needs at least three corners, found {}", n);
  for (int i = 0; i < n; ++i) {
    if (!p[i].allFinite()) user_error("outline: the corner {} is not a finite point", i);
    if (p[i] == p[(i + 1) % n])
      user_error(
          "outline: the corners {} and {} coincide at ({:.6g}, {:.6g}) m; list each corner once (the last is "
          "joined to the first by itself)",
          i, (i + 1) % n, p[i].x(), p[i].y());
  }
  for (int i = 0; i < n; ++i)
    for (int j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && crossing(p[i], p[i + 1], p[j], p[(j + 1) % n]))
        user_error(
            "outline: the edges {} and {} cross near ({:.6g}, {:.6g}) m; list the corners in order around "
            "the vessel",
            i, j, 0.5 * (p[i] + p[i + 1]).x(), 0.5 * (p[i] + p[i + 1]).y());
}

int nearest_edge(std::span<const Vec2> p, const Vec2& x) {
  const int n = int(p.size());
  const auto distance = [&](int k) { return (0.5 * (p[k] + p[(k + 1) % n]) - x).norm(); };
  int best = 0;
  for (int k = 1; k < n; ++k)
    if (distance(k) < distance(best)) best = k;
  return best;
}

int edge_of(const OutlineOpening& opening, std::span<const Vec2> p) {
  if (opening.nearest) return nearest_edge(p, *opening.nearest);
  if (!opening.edge)
    user_error("opening '{}': say which edge of the outline it is, by `edge` or by `nearest`", opening.name);
  if (*opening.edge < 0 || *opening.edge >= int(p.size()))
    user_error("opening '{}': the outline has no edge {}; its edges are numbered 0 to {}", opening.name,
               *opening.edge, p.size() - 1);
  return *opening.edge;
}

Opening<2> make_opening(const std::string& name, const Vec2& a, const Vec2& b, int edge) {
  const Vec2 along = b - a;
  return {.name = name,
          .centre = 0.5 * (a + b),
          .normal = Vec2(along.y(), -along.x()).normalized(),
          .area = along.norm(),
          .outline = {a, b},
          .face_id = edge,
          .planarity = 0};
}

}  // namespace

Lumen<2> polygon_lumen(std::span<const Vec2> points, std::span<const OutlineOpening> openings) {
  check_simple(points);
  if (openings.empty()) user_error("outline: no opening; name at least one edge through which blood flows");
  const int n = int(points.size());
  const bool clockwise = signed_area(points) < 0;
  Lumen<2> lumen;
  lumen.surface.points.assign(points.begin(), points.end());
  for (int k = 0; k < n; ++k) {
    const int next = (k + 1) % n;
    lumen.surface.facets.push_back(clockwise ? std::array{next, k} : std::array{k, next});
  }
  lumen.surface.label.assign(n, -1);
  for (const auto& opening : openings) {
    const int edge = edge_of(opening, points);
    int& label = lumen.surface.label[edge];
    if (label >= 0)
      user_error("openings '{}' and '{}' name the same edge {} of the outline; give each its own",
                 lumen.openings[label].name, opening.name, edge);
    label = int(lumen.openings.size());
    const auto [a, b] = lumen.surface.facets[edge];
    lumen.openings.push_back(make_opening(opening.name, points[a], points[b], edge));
  }
  if (clockwise) lumen.repairs.push_back("the outline ran clockwise; its sense was turned");
  lumen.volume = volume(lumen.surface);
  lumen.wall_area = area(lumen.surface, -1);
  return lumen;
}

}  // namespace ostium::sph3d
