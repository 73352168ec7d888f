/// Tubes and bends: a polygon swept along a centreline.
#include <functional>

#include "core/error.hpp"
#include "sph3d/geometry/generate.hpp"
#include "sph3d/geometry/generate_checks.hpp"

namespace ostium::sph3d {
namespace {

/// A cross-section: its centre, the two directions that span it, the radius.
struct Section {
  Vec3 centre, across, up;
  double radius;
};

/// Circumradius of the regular polygon that has the area of the unit circle.
double equal_area(int around) {
  const double sector = 2 * pi / around;
  return std::sqrt(sector / std::sin(sector));
}

void add(Surface<3>& s, int a, int b, int c, int label) {
  s.facets.push_back({a, b, c});
  s.label.push_back(label);
}

Surface<3> sweep(const std::vector<Section>& sections, int around) {
  Surface<3> s;
  for (const auto& section : sections)
    for (int i = 0; i < around; ++i) {
      const double angle = 2 * pi * i / around, r = section.radius * equal_area(around);
      s.points.push_back(section.centre +
                         r * (std::cos(angle) * section.across + std::sin(angle) * section.up));
    }
  const int rings = int(sections.size()), bottom = int(s.points.size()), last = (rings - 1) * around;
  s.points.push_back(sections.front().centre), s.points.push_back(sections.back().centre);
  for (int i = 0; i < around; ++i) {
    const int j = (i + 1) % around;
    for (int k = 0; k + 1 < rings; ++k) {
      const int a = k * around + i, b = k * around + j;
      add(s, a, b, b + around, -1), add(s, a, b + around, a + around, -1);
    }
    add(s, bottom, j, i, 0), add(s, bottom + 1, last + i, last + j, 1);
  }
  return s;
}

/// Steps whose length is near the side of the polygon.
int steps(double length, double radius, int around) {
  return std::max(1, int(std::ceil(length * around / (2 * pi * radius))));
}

void check_around(int around) {
  if (around < 8 || around > 100000) user_error("around: between 8 and 100000 sides, found {}", around);
}

}  // namespace

Surface<3> generate(const TubeShape& shape) {
  check_positive("radius", shape.radius), check_positive("length", shape.length), check_around(shape.around);
  const double end = shape.outlet_radius == 0 ? shape.radius : shape.outlet_radius;
  check_positive("outlet_radius", end);
  const int n = steps(shape.length, std::min(end, shape.radius), shape.around);
  std::vector<Section> sections;
  for (int k = 0; k <= n; ++k) {
    const double t = double(k) / n;
    sections.push_back({t * shape.length * Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY(),
                        shape.radius + t * (end - shape.radius)});
  }
  return sweep(sections, shape.around);
}

Surface<3> generate(const BendShape& shape) {
  const double R = shape.bend_radius;
  check_positive("radius", shape.radius), check_positive("bend_radius", R),
      check_positive("angle", shape.angle);
  check_around(shape.around);
  if (shape.inlet_length < 0 || shape.outlet_length < 0)
    user_error("inlet_length, outlet_length: not negative, found {} m and {} m", shape.inlet_length,
               shape.outlet_length);
  if (R <= 1.01 * shape.radius)
    user_error("bend_radius: larger than the radius {} m, else the inner wall folds; found {} m",
               shape.radius, R);
  if (shape.angle > 1.5 * pi) user_error("angle: at most 270 degrees, found {:.4g}", shape.angle * 180 / pi);
  std::vector<Section> sections;
  const auto straight = [&](const Section& from, const Vec3& along, double length, bool first) {
    const int n = steps(length, shape.radius, shape.around);
    for (int k = first ? 0 : 1; length > 0 && k <= n; ++k) {
      sections.push_back(from);
      sections.back().centre += length * k / n * along;
    }
  };
  const auto on_arc = [&](double a) {
    return Section{Vec3(R * (1 - std::cos(a)), 0, R * std::sin(a)), Vec3(std::cos(a), 0, -std::sin(a)),
                   Vec3::UnitY(), shape.radius};
  };
  Section start = on_arc(0);
  start.centre.z() -= shape.inlet_length;
  straight(start, Vec3::UnitZ(), shape.inlet_length, true);
  // The outer wall is the longest: its steps set the number.
  const int n = steps((R + shape.radius) * shape.angle, shape.radius, shape.around);
  for (int k = sections.empty() ? 0 : 1; k <= n; ++k) sections.push_back(on_arc(shape.angle * k / n));
  const Vec3 out(std::sin(shape.angle), 0, std::cos(shape.angle));
  straight(on_arc(shape.angle), out, shape.outlet_length, false);
  return sweep(sections, shape.around);
}

}  // namespace ostium::sph3d
