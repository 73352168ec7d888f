/// Small vessels for the engine's tests: a plane channel and a round tube along the first axis, inlet first.
#pragma once
#include <omp.h>

#include <cmath>

#include "sph3d/geometry/polygon.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::sph3d {

inline Lumen<2> channel(double length, double width) {
  const std::vector<Vec2> points{{0, 0}, {length, 0}, {length, width}, {0, width}};
  const std::vector<OutlineOpening> openings{{"in", 3}, {"out", 1}};
  Lumen<2> lumen = polygon_lumen(points, openings);
  if (lumen.openings[0].name != "in") {
    std::swap(lumen.openings[0], lumen.openings[1]);
    for (int& label : lumen.surface.label)
      if (label >= 0) label = 1 - label;
  }
  return lumen;
}

/// A polygonal tube with `around` sides from x = 0 (opening 0) to x = length (opening 1).
inline Lumen<3> tube(double radius, double length, int around = 64, int along = 16) {
  Lumen<3> lumen;
  auto& s = lumen.surface;
  const auto add = [&](int a, int b, int c, int label) {
    s.facets.push_back({a, b, c});
    s.label.push_back(label);
  };
  for (int k = 0; k <= along; ++k)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * pi * i / around;
      s.points.push_back(Vec3(length * k / along, radius * std::cos(angle), radius * std::sin(angle)));
    }
  const auto at = [&](int k, int i) { return k * around + i % around; };
  const int first = static_cast<int>(s.points.size());
  s.points.push_back(Vec3(0, 0, 0));
  s.points.push_back(Vec3(length, 0, 0));
  for (int k = 0; k < along; ++k)
    for (int i = 0; i < around; ++i) {
      add(at(k, i), at(k, i + 1), at(k + 1, i), -1);
      add(at(k + 1, i), at(k, i + 1), at(k + 1, i + 1), -1);
    }
  for (int i = 0; i < around; ++i) {
    add(first, at(0, i + 1), at(0, i), 0);
    add(first + 1, at(along, i), at(along, i + 1), 1);
  }
  const double area = 0.5 * around * radius * radius * std::sin(2 * pi / around);
  lumen.volume = area * length;
  lumen.wall_area = 2 * around * radius * std::sin(pi / around) * length;
  for (int k = 0; k < 2; ++k) {
    Opening<3> opening;
    opening.name = k == 0 ? "in" : "out";
    opening.centre = Vec3(k * length, 0, 0);
    opening.normal = Vec3(k == 0 ? -1 : 1, 0, 0);
    opening.area = area;
    for (int i = 0; i < around; ++i)
      opening.outline.push_back(s.points[at(k * along, k == 0 ? around - 1 - i : i)]);
    lumen.openings.push_back(opening);
  }
  return lumen;
}

/// The number of threads within a scope.
class Threads {
 public:
  explicit Threads(int n) { omp_set_num_threads(n); }
  ~Threads() { omp_set_num_threads(before_); }
  Threads(const Threads&) = delete;
  Threads& operator=(const Threads&) = delete;

 private:
  int before_ = omp_get_max_threads();
};

/// Particles in the same places with the same velocities and densities, bit by bit.
template <int D>
bool same_bits(const FluidState<D>& a, const FluidState<D>& b) {
  if (a.position != b.position || a.filled != b.filled) return false;
  for (std::size_t i = 0; i < a.places(); ++i)
    if (a.velocity(i) != b.velocity(i) || a.psi(i) != b.psi(i)) return false;
  return true;
}

}  // namespace ostium::sph3d
