/// A thin wall around a round tube along the first axis: rings of shell particles, clamped where the tube ends.
#pragma once
#include <cmath>

#include "sph3d/walls/deformable_wall.hpp"

namespace ostium::sph3d {

struct TubeWall {
  ShellCloud<3> cloud;
  std::vector<Vec3> contact;

  TubeWall(double radius, double length, double spacing, double thickness) {
    const double middle = radius + 0.5 * thickness;
    const int around = static_cast<int>(std::lround(2 * pi * middle / spacing));
    for (double x = 0.5 * spacing; x < length; x += spacing)
      for (int i = 0; i < around; ++i) {
        const double angle = 2 * pi * i / around;
        const Vec3 n(0, std::cos(angle), std::sin(angle));
        contact.push_back(Vec3(x, 0, 0) + radius * n);
        cloud.position.push_back(Vec3(x, 0, 0) + middle * n);
        cloud.normal.push_back(n);
        cloud.area.push_back(2 * pi * middle / around * spacing);
        cloud.thickness.push_back(thickness);
        cloud.support.push_back(std::min(x, length - x) < 4 * spacing ? Support::clamped : Support::free);
        cloud.axis.push_back(Vec3(1, 0, 0));
        cloud.circumference.push_back(Vec3(0, -std::sin(angle), std::cos(angle)));
      }
  }
};

}  // namespace ostium::sph3d
