#include "sph3d/geometry/outline.hpp"

#include <numeric>
#include <queue>

#include "sph3d/geometry/closest_point.hpp"

namespace ostium::sph3d {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// A square that may still hold the centre of a larger circle.
struct Cell {
  Vec2 centre;
  double half, distance;  // distance to the boundary, negative outside
  double best_possible() const { return distance + half * std::sqrt(2.0); }
  bool operator<(const Cell& other) const { return best_possible() < other.best_possible(); }
};

Cell cell(std::span<const Vec2> polygon, const Vec2& centre, double half) {
  const double distance = boundary_distance(polygon, centre);
  return {centre, half, inside(polygon, centre) ? distance : -distance};
}

bool is_ear(std::span<const Vec2> polygon, std::span<const int> left, int a, int b, int c) {
  const Vec2 &p = polygon[a], &q = polygon[b], &r = polygon[c];
  if (cross(q - p, r - q) <= 0) return false;
  for (int i : left) {
    const Vec2& x = polygon[i];
    if (i == a || i == b || i == c || x == p || x == q || x == r) continue;
    if (cross(q - p, x - p) >= 0 && cross(r - q, x - q) >= 0 && cross(p - r, x - r) >= 0) return false;
  }
  return true;
}

/// Sine of the smallest angle, a measure of how well shaped the triangle is.
double quality(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double longest2 =
      std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm(), 1e-300});
  return cross(b - a, c - b) / longest2;
}

}  // namespace

bool inside(std::span<const Vec2> polygon, const Vec2& x) {
  bool odd = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const Vec2 &a = polygon[i], &b = polygon[j];
    if ((a.y() > x.y()) != (b.y() > x.y()) &&
        x.x() < (b.x() - a.x()) * (x.y() - a.y()) / (b.y() - a.y()) + a.x())
      odd = !odd;
  }
  return odd;
}

double boundary_distance(std::span<const Vec2> polygon, const Vec2& x) {
  double least2 = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    least2 = std::min(least2, (closest_on_facet({polygon[j], polygon[i]}, x).point - x).squaredNorm());
  return std::sqrt(least2);
}

double signed_area(std::span<const Vec2> polygon) {
  double twice = 0;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++)
    twice += cross(polygon[j] - polygon[0], polygon[i] - polygon[0]);
  return 0.5 * twice;
}

double inscribed_radius(std::span<const Vec2> polygon) {
  Vec2 lower = polygon[0], upper = polygon[0];
  for (const auto& x : polygon) lower = lower.cwiseMin(x), upper = upper.cwiseMax(x);
  const double half = 0.5 * (upper - lower).minCoeff();
  if (!(half > 0)) return 0;
  std::priority_queue<Cell> open;
  for (double x = lower.x(); x < upper.x(); x += 2 * half)
    for (double y = lower.y(); y < upper.y(); y += 2 * half)
      open.push(cell(polygon, Vec2(x + half, y + half), half));
  double best = 0;
  while (!open.empty()) {
    const Cell c = open.top();
    open.pop();
    best = std::max(best, c.distance);
    if (c.best_possible() <= best * 1.001) break;
    const double h = 0.5 * c.half;
    for (int k = 0; k < 4; ++k) open.push(cell(polygon, c.centre + Vec2(k & 1 ? h : -h, k & 2 ? h : -h), h));
  }
  return best;
}

std::vector<std::array<int, 3>> triangulate(std::span<const Vec2> polygon) {
  std::vector<int> left(polygon.size());
  std::iota(left.begin(), left.end(), 0);
  std::vector<std::array<int, 3>> triangles;
  while (left.size() > 3) {
    const int n = int(left.size());
    int best = -1;
    double best_quality = -1;
    for (int i = 0; i < n; ++i) {
      const int a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
      const double q = quality(polygon[a], polygon[b], polygon[c]);
      if (q > best_quality && is_ear(polygon, left, a, b, c)) best_quality = q, best = i;
    }
    // Only a polygon that touches itself has no ear; the flattest corner then loses nothing.
    if (best < 0) best = 0;
    triangles.push_back({left[(best + n - 1) % n], left[best], left[(best + 1) % n]});
    left.erase(left.begin() + best);
  }
  triangles.push_back({left[0], left[1], left[2]});
  return triangles;
}

}  // namespace ostium::sph3d
