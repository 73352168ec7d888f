/// Surfaces with known volume, area and distance, made on the spot.
#pragma once
#include <cmath>
#include <vector>

#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d::shapes {

/// A straight tube along z from 0 to length: `around` facets around, capped by fans; caps labelled 0 (z = 0)
/// and 1.
inline Surface<3> tube(double radius, double length, int around = 64, int along = 20) {
  Surface<3> s;
  for (int k = 0; k <= along; ++k)
    for (int i = 0; i < around; ++i) {
      const double a = 2 * pi * i / around;
      s.points.emplace_back(radius * std::cos(a), radius * std::sin(a), length * k / along);
    }
  const int bottom = int(s.points.size()), top = bottom + 1;
  s.points.emplace_back(0, 0, 0), s.points.emplace_back(0, 0, length);
  const auto add = [&](int a, int b, int c, int label) {
    s.facets.push_back({a, b, c}), s.label.push_back(label);
  };
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around, last = along * around;
    for (int k = 0; k < along; ++k) {
      const int a = k * around + i, b = k * around + j;
      add(a, b, b + around, -1), add(a, b + around, a + around, -1);
    }
    add(bottom, j, i, 0), add(top, last + i, last + j, 1);
  }
  return s;
}

/// An octahedron refined and blown up to a sphere.
inline Surface<3> sphere(double radius, int refinements) {
  Surface<3> s;
  for (int d = 0; d < 3; ++d)
    for (double sign : {1.0, -1.0}) s.points.push_back(sign * Vec3::Unit(d));
  s.facets = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int r = 0; r < refinements; ++r) {
    std::vector<std::array<int, 3>> finer;
    std::vector<std::vector<std::pair<int, int>>> middle(s.points.size());
    const auto mid = [&](int a, int b) {
      if (a > b) std::swap(a, b);
      for (auto [other, m] : middle[a])
        if (other == b) return m;
      s.points.push_back((s.points[a] + s.points[b]).normalized());
      middle[a].emplace_back(b, int(s.points.size()) - 1);
      return int(s.points.size()) - 1;
    };
    for (auto [a, b, c] : s.facets) {
      const int ab = mid(a, b), bc = mid(b, c), ca = mid(c, a);
      for (auto t : {std::array{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}}) finer.push_back(t);
    }
    s.facets = std::move(finer);
  }
  for (auto& x : s.points) x *= radius;
  s.label.assign(s.facets.size(), -1);
  return s;
}

/// The lumen of tube(), its openings in place.
inline Lumen<3> tube_lumen(double radius, double length, int around = 64, int along = 20) {
  Lumen<3> lumen{.surface = tube(radius, length, around, along)};
  for (int end = 0; end < 2; ++end) {
    Opening<3> o{.name = end ? "outlet" : "inlet",
                 .centre = Vec3(0, 0, end * length),
                 .normal = Vec3(0, 0, end ? 1 : -1),
                 .area = area(lumen.surface, end)};
    for (int i = 0; i < around; ++i)
      o.outline.push_back(lumen.surface.points[end ? along * around + i : (around - i) % around]);
    lumen.openings.push_back(o);
  }
  lumen.volume = volume(lumen.surface), lumen.wall_area = area(lumen.surface, -1);
  return lumen;
}

}  // namespace ostium::sph3d::shapes
