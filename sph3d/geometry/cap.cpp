#include <algorithm>

#include "core/error.hpp"
#include "sph3d/geometry/outline.hpp"
#include "sph3d/geometry/repair.hpp"

namespace ostium::sph3d {
namespace {

/// An open rim, in the sense in which a cap runs around it.
struct Rim {
  std::vector<int> loop;
  Vec3 centre = Vec3::Zero(), area_vector = Vec3::Zero();
  double unevenness = 0;  ///< largest distance to the mean plane, m

  double area() const { return area_vector.norm(); }
  double diameter() const { return std::sqrt(4 * area() / pi); }
};

Rim measure(const Soup& soup, std::vector<int> loop) {
  Rim rim{.loop = std::move(loop)};
  const int n = int(rim.loop.size());
  for (int v : rim.loop) rim.centre += soup.points[v] / n;
  for (int i = 0; i < n; ++i) {
    const Vec3 a = soup.points[rim.loop[i]] - rim.centre, b = soup.points[rim.loop[(i + 1) % n]] - rim.centre;
    rim.area_vector += 0.5 * a.cross(b);
  }
  const Vec3 normal = rim.area_vector.normalized();
  for (int v : rim.loop)
    rim.unevenness = std::max(rim.unevenness, std::abs((soup.points[v] - rim.centre).dot(normal)));
  return rim;
}

std::vector<Rim> open_rims(const Soup& soup) {
  std::vector<std::pair<int, int>> sides;
  for_each_edge(edge_uses(soup.facets), [&](std::span<const EdgeUse> uses) {
    if (uses.size() != 1) return;
    const auto [lower, upper, facet, slot] = uses[0];
    sides.push_back(forward(soup.facets, uses[0]) ? std::pair(upper, lower) : std::pair(lower, upper));
  });
  std::vector<Rim> rims;
  for (auto& loop : loops(std::move(sides))) rims.push_back(measure(soup, std::move(loop)));
  std::stable_sort(rims.begin(), rims.end(), [](const Rim& a, const Rim& b) { return a.area() > b.area(); });
  return rims;
}

/// Neighbouring parts that were written with different rounding leave slits without width.
std::string describe(const Soup& soup, const Rim& rim) {
  std::vector<Vec3> points;
  for (int v : rim.loop) points.push_back(soup.points[v]);
  const double length = bounds(points).extent().maxCoeff();
  const bool slit = rim.area() < 1e-4 * length * length;
  return fmt::format("at {}, {}, {} edges", place(rim.centre),
                     slit ? "a slit " + size(length) + " long" : size(rim.diameter()) + " across",
                     rim.loop.size());
}

[[noreturn]] void refuse(const Soup& soup, const std::vector<Rim>& rims) {
  std::string list;
  constexpr std::size_t most = 12;
  for (std::size_t i = 0; i < rims.size() && i < most; ++i) list += (i ? "; " : "") + describe(soup, rims[i]);
  if (rims.size() > most) list += fmt::format("; and {} more", rims.size() - most);
  user_error(
      "the surface is open: {} open end{} ({}); close it in the program that made it, or set "
      "`cap_open_ends: true` to close each with a flat cap that becomes an opening",
      rims.size(), rims.size() == 1 ? "" : "s", list);
}

Polygon seen_along_normal(const Soup& soup, const Rim& rim) {
  const auto t = plane_frame<3>(rim.area_vector.normalized());
  Polygon flat;
  for (int v : rim.loop) flat.push_back(t.transpose() * (soup.points[v] - rim.centre));
  return flat;
}

/// Whether the centre sees the whole rim.
bool star_shaped(const Polygon& rim) {
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const Vec2 &a = rim[i], &b = rim[(i + 1) % rim.size()];
    if (a.x() * b.y() - a.y() * b.x() <= 0) return false;
  }
  return true;
}

std::vector<Triangle> fill(Soup& soup, const Rim& rim) {
  const auto flat = seen_along_normal(soup, rim);
  const int n = int(rim.loop.size());
  std::vector<Triangle> cap;
  if (n > 4 && star_shaped(flat)) {
    const int middle = int(soup.points.size());
    soup.points.push_back(rim.centre);
    for (int i = 0; i < n; ++i) cap.push_back({rim.loop[i], rim.loop[(i + 1) % n], middle});
    return cap;
  }
  for (const auto& [a, b, c] : triangulate(flat)) cap.push_back({rim.loop[a], rim.loop[b], rim.loop[c]});
  return cap;
}

void close(Soup& soup, const Rim& rim, int cap) {
  for (const auto& facet : fill(soup, rim)) {
    soup.facets.push_back(facet);
    soup.cap.push_back(cap);
    if (!soup.face_id.empty()) soup.face_id.push_back(-1);
  }
}

void check_flat_enough(const Rim& rim) {
  constexpr double most = 0.25;  // of the diameter
  if (rim.unevenness > most * rim.diameter())
    user_error(
        "the open end at {}, {} across, is not plane: its rim leaves its mean plane by {}, {:.2g} % of its "
        "width; a flat "
        "cap allows {}; cut the vessel by a plane there",
        place(rim.centre), size(rim.diameter()), size(rim.unevenness), 100 * rim.unevenness / rim.diameter(),
        size(most * rim.diameter()));
}

}  // namespace

void close_open_ends(Soup& soup, bool cap_open_ends) {
  const auto rims = open_rims(soup);
  if (rims.empty()) return;
  if (!cap_open_ends) refuse(soup, rims);
  constexpr double hole = 0.01;  // of the area of the largest end
  soup.cap.assign(soup.facets.size(), -1);
  int holes = 0, ends = 0;
  for (const auto& rim : rims) {
    if (rim.area() < hole * rims.front().area()) {
      close(soup, rim, -1), ++holes;
      continue;
    }
    check_flat_enough(rim);
    close(soup, rim, ends++);
    soup.notes.push_back(
        fmt::format("the open end at {}, {} across, was capped", place(rim.centre), size(rim.diameter())));
  }
  if (holes > 0) soup.notes.push_back(fmt::format("{} small holes were closed with wall", holes));
}

}  // namespace ostium::sph3d
