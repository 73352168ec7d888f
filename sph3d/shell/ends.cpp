#include "sph3d/shell/ends.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sph3d/shell/lateral.hpp"
#include "sph3d/shell/surface_pairs.hpp"

namespace ostium::sph3d {

namespace {

constexpr int least_rows = 3;
constexpr double fluid_smoothing = 1.3;  // h of the fluid over its spacing
constexpr double row = 1.6;  // neighbours within this distance, over the spacing, are in the next row

/// Rows of free points from the end of `from`, through free points only, to the end of another opening.
struct Passage {
  int rows, to, point;
};

template <int D>
Passage shortest_passage(const SurfacePairs<D>& pairs, const std::vector<std::int32_t>& opening, int from) {
  std::vector<int> rows(opening.size(), -1), front;
  for (std::size_t a = 0; a < opening.size(); ++a)
    if (opening[a] == from) rows[a] = 0, front.push_back(static_cast<int>(a));
  for (int passed = 0; passed <= least_rows && !front.empty(); ++passed) {
    std::vector<int> next;
    for (int a : front)
      for (const auto [b, rim] : pairs.of(a)) {
        if (opening[b] >= 0 && opening[b] != from) return {passed, opening[b], a};
        if (opening[b] < 0 && rows[b] < 0) rows[b] = passed + 1, next.push_back(b);
      }
    front = std::move(next);
  }
  return {least_rows, -1, -1};
}

/// Points within this depth of a rim that are reached from it without leaving this depth: a neighbouring branch is not, near as it may be.
template <int D>
std::vector<int> within(const SurfacePoints<D>& points, const SurfacePairs<D>& pairs, const Rim<D>& rim,
                        double deep, double first_row) {
  std::vector<char> candidate(points.position.size());
  std::vector<int> reached;
  for (std::size_t a = 0; a < candidate.size(); ++a) {
    candidate[a] = rim.near(points.position[a], deep);
    if (candidate[a] && rim.distance(points.position[a]) < first_row)
      reached.push_back(static_cast<int>(a)), candidate[a] = 0;
  }
  for (std::size_t k = 0; k < reached.size(); ++k)
    for (const auto [b, image] : pairs.of(std::size_t(reached[k])))
      if (candidate[b]) reached.push_back(b), candidate[b] = 0;
  return reached;
}

}  // namespace

double end_length(const ShellWallOptions& o) {
  if (o.ends == WallEnds::free) return o.spacing;
  if (o.clamp_length > 0.0) return o.clamp_length;
  return std::max(2.0 * fluid_smoothing * o.fluid_spacing + o.spacing, least_rows * o.spacing);
}

template <int D>
void check_plane_ends(const Lumen<D>& lumen, double spacing) {
  const double tolerance = 0.25 * spacing;
  for (const auto& o : lumen.openings) {
    double deviation = 0.0;
    Vec<D> where = o.centre;
    for (const auto& x : o.outline)
      if (const double off = std::abs((x - o.centre).dot(o.normal)); off > deviation)
        deviation = off, where = x;
    if (deviation > tolerance)
      user_error(
          "the end of the wall at the opening '{}' is not plane: {} its rim lies {:.3g} mm beside the plane, "
          "{:.2g} % of the "
          "opening's width; a quarter of the wall's spacing, {:.3g} mm, is allowed. Cut the vessel there by "
          "a plane",
          o.name, place<D>(where), 1e3 * deviation, 100 * deviation / width(o), 1e3 * tolerance);
  }
}

template <int D>
std::vector<std::int32_t> ends_of(const SurfacePoints<D>& points, const Lumen<D>& lumen,
                                  const ShellWallOptions& options) {
  const double deep = end_length(options) + options.beyond;
  const SurfacePairs<D> pairs(points.position, points.normal, {}, row * options.spacing);
  std::vector<std::int32_t> opening(points.position.size(), -1);
  std::vector<double> away(points.position.size(), 1e300);
  for (int k = 0; k < static_cast<int>(lumen.openings.size()); ++k) {
    const Rim<D> rim(lumen.openings[k], options.beyond);
    for (const int a : within(points, pairs, rim, deep, row * options.spacing))
      if (const double d = rim.distance(points.position[a]); d < away[a]) away[a] = d, opening[a] = k;
  }
  return opening;
}

template <int D>
void check_free_rows(const SurfacePoints<D>& points, const std::vector<std::int32_t>& opening,
                     const Lumen<D>& lumen, const ShellWallOptions& options) {
  if (options.ends != WallEnds::clamped) return;
  const char* advice = "Make the vessel longer, the ends shorter or the shell spacing finer";
  if (std::none_of(opening.begin(), opening.end(), [](auto k) { return k < 0; }))
    user_error("the clamped ends of the wall, {:.3g} m long, hold all of it. {}", end_length(options),
               advice);
  const SurfacePairs<D> pairs(points.position, points.normal, {}, row * options.spacing);
  for (int k = 0; k < static_cast<int>(lumen.openings.size()); ++k) {
    const auto [rows, to, point] = shortest_passage(pairs, opening, k);
    if (to >= 0)
      user_error(
          "between the clamped ends of the wall at the openings '{}' and '{}' {} {} of particles {} free, "
          "{}; "
          "it takes {} or more. {}",
          lumen.openings[k].name, lumen.openings[to].name, rows, rows == 1 ? "row" : "rows",
          rows == 1 ? "is" : "are", place<D>(points.position[point]), least_rows, advice);
  }
}

template <int D>
void hold_ends(ShellCloud<D>& cloud, const std::vector<std::int32_t>& opening, const Lumen<D>& lumen,
               WallEnds ends) {
  const Support held = ends == WallEnds::clamped    ? Support::clamped
                       : ends == WallEnds::released ? Support::released
                                                    : Support::free;
  for (const auto k : opening) {
    cloud.support.push_back(k < 0 ? Support::free : held);
    cloud.axis.push_back(k < 0 ? Vec<D>::Unit(0) : lumen.openings[k].normal);
  }
}

template void check_plane_ends(const Lumen<2>&, double);
template void check_plane_ends(const Lumen<3>&, double);
template std::vector<std::int32_t> ends_of(const SurfacePoints<2>&, const Lumen<2>&, const ShellWallOptions&);
template std::vector<std::int32_t> ends_of(const SurfacePoints<3>&, const Lumen<3>&, const ShellWallOptions&);
template void check_free_rows(const SurfacePoints<2>&, const std::vector<std::int32_t>&, const Lumen<2>&,
                              const ShellWallOptions&);
template void check_free_rows(const SurfacePoints<3>&, const std::vector<std::int32_t>&, const Lumen<3>&,
                              const ShellWallOptions&);
template void hold_ends(ShellCloud<2>&, const std::vector<std::int32_t>&, const Lumen<2>&, WallEnds);
template void hold_ends(ShellCloud<3>&, const std::vector<std::int32_t>&, const Lumen<3>&, WallEnds);

}  // namespace ostium::sph3d
