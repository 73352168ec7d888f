/// What laws ask for and give besides strain and stress.
///
///   Fibres           two families of fibres: unit vectors in the reference configuration, in the axes of the strain
///   ThicknessStress  a positive multiple of the stress S_zz across a sheet whose normal is z, and its derivative by E_zz, Pa;
///                    each law takes the multiple that is nearly linear in E_zz
///
/// In a shell or a wall the fibres lie in the tangent plane, at +-angle to the circumference: fibres_at_angle().
/// Not checked: that the vectors have length one.
#pragma once
#include "core/vec.hpp"

namespace ostium::sph3d {

template <class T>
struct Fibres {
  T first[3] = {T(1.0), T(0.0), T(0.0)};
  T second[3] = {T(1.0), T(0.0), T(0.0)};
};

template <class T>
struct ThicknessStress {
  T value, slope;
};

/// cos(angle) circumferential +- sin(angle) (normal x circumferential); both arguments unit and perpendicular.
inline Fibres<double> fibres_at_angle(const Vec3& circumferential, const Vec3& normal, double angle) {
  const Vec3 axial = normal.cross(circumferential);
  Fibres<double> fibres;
  for (int d = 0; d < 3; ++d) {
    fibres.first[d] = std::cos(angle) * circumferential[d] + std::sin(angle) * axial[d];
    fibres.second[d] = std::cos(angle) * circumferential[d] - std::sin(angle) * axial[d];
  }
  return fibres;
}

}  // namespace ostium::sph3d
