/// Vessels for shells to be generated on, and how evenly their particles stand.
#pragma once
#include <algorithm>
#include <cmath>

#include "sph3d/geometry/find_openings.hpp"
#include "sph3d/geometry/generate.hpp"
#include "sph3d/geometry/point_grid.hpp"
#include "sph3d/geometry/polygon.hpp"
#include "sph3d/shell/generate.hpp"

namespace ostium::sph3d {

inline Lumen<3> lumen_of(Surface<3> surface) {
  Lumen<3> lumen{.surface = std::move(surface)};
  lumen.openings = find_openings(lumen.surface, {});
  lumen.volume = volume(lumen.surface), lumen.wall_area = area(lumen.surface, -1);
  return lumen;
}

/// A carotid's wall: inner radius 3 mm along z, 0.6 mm thick.
struct Carotid {
  double radius = 3e-3, length = 12e-3, thickness = 0.6e-3, spacing = 0.45e-3;
  int around = 96;

  Lumen<3> lumen() const {
    return lumen_of(generate(TubeShape{.radius = radius, .length = length, .around = around}));
  }
  double middle() const { return radius + 0.5 * thickness; }
  ShellWallOptions options(WallEnds ends) const {
    return {.spacing = spacing, .fluid_spacing = spacing, .thickness = thickness, .ends = ends};
  }
};

/// A plane channel along x; then, with a bend radius, a quarter turn upward around (length, bend).
inline Lumen<2> plane_channel(double length, double width, double bend = 0, int arc = 200) {
  std::vector<Vec2> lower{{0, 0}, {length, 0}}, upper{{0, width}, {length, width}};
  const auto turn = [&](std::vector<Vec2>& side, double radius) {
    for (int k = 1; k <= arc; ++k) {
      const double phi = 0.5 * pi * k / arc;
      side.emplace_back(length + radius * std::sin(phi), bend - radius * std::cos(phi));
    }
  };
  if (bend > 0) turn(lower, bend), turn(upper, bend - width);
  std::vector<Vec2> points = lower;
  points.insert(points.end(), upper.rbegin(), upper.rend());
  const int out = static_cast<int>(lower.size()) - 1, in = static_cast<int>(points.size()) - 1;
  return polygon_lumen(points,
                       std::vector<OutlineOpening>{{.name = "in", .edge = in}, {.name = "out", .edge = out}});
}

/// Over all particles.
struct Evenness {
  double nearest = 0, spread = 0,
         least = 1e300;  ///< distance of the nearest other over the spacing: mean, deviation, least
  double areas = 0;      ///< largest contact area over the smallest
};

template <int D>
Evenness evenness(const WallShell<D>& shell, double spacing) {
  const PointGrid<D> grid(shell.contact, 3 * spacing);
  Evenness e;
  double squares = 0;
  for (std::size_t a = 0; a < shell.count(); ++a) {
    double nearest = 1e300;
    grid.near(shell.contact[a], [&](int b, const Vec<D>& apart) {
      if (std::size_t(b) != a) nearest = std::min(nearest, apart.norm() / spacing);
    });
    e.nearest += nearest, squares += nearest * nearest, e.least = std::min(e.least, nearest);
  }
  const double n = static_cast<double>(shell.count());
  e.nearest /= n, e.spread = std::sqrt(std::max(squares / n - e.nearest * e.nearest, 0.0));
  const auto [low, high] = std::minmax_element(shell.contact_area.begin(), shell.contact_area.end());
  e.areas = *high / *low;
  return e;
}

inline double sum_of(const std::vector<double>& values) {
  double sum = 0;
  for (double v : values) sum += v;
  return sum;
}

}  // namespace ostium::sph3d
