/// Vessels made from a few numbers: closed, capped by exact planes, with rounded junctions.
///
///   tube         straight, from z = 0 to length, optionally tapered
///   bend         straight, then an arc in the x-z plane, then straight
///   bifurcation  a parent that divides in two
///   arch         ascending part, half circle, descending part, and branches that leave the half circle upward
///
/// Lengths in m, angles in rad. Labels: 0 the inlet, 1 the outlet (of the arch: the descending end), then the
/// branches in order of distance from the inlet (bifurcation: 1, 2 the daughters).
///
/// tube and bend sweep a regular polygon whose area is that of the circle. bifurcation and arch are level sets of
///
///   f(x) = smin_k( |x - c_t| - r_t(c_t) ),   smin_k(a, b) = min(a, b) - max(k - |a - b|, 0)^2 / (4 k)
///
/// over tubes t with centrelines c_t and radii r_t; k is the fillet. Refused: sizes that are not positive, bends
/// tighter than their radius, branches that do not fit.
#pragma once
#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

struct TubeShape {
  double radius = 0.010, length = 0.100;
  double outlet_radius = 0;  ///< 0: like the inlet
  int around = 96;           ///< sides of the polygon
};

struct BendShape {
  double radius = 0.010, bend_radius = 0.030, angle = pi / 2;
  double inlet_length = 0.020, outlet_length = 0.020;
  int around = 96;
};

struct BifurcationShape {
  double parent_radius = 0.006, parent_length = 0.040;
  double daughter_radius = 0.0045, second_daughter_radius = 0;  ///< 0: like the first
  double daughter_length = 0.040;
  double angle = pi / 3;  ///< between the daughters
  double fillet = 0.004;
  double edge = 0;  ///< of the triangles; 0: a quarter of the smallest radius
};

/// The aortic arch. Its five branches are those that leave the arch itself; with the ascending inlet and the
/// descending outlet it has seven openings.
struct ArchShape {
  double ascending_radius = 0.0125, descending_radius = 0.0095, arch_radius = 0.030;
  double ascending_length = 0.030, descending_length = 0.060;
  std::vector<double> branch_radii = {0.0040, 0.0035, 0.0035, 0.0030, 0.0040};
  double branch_length = 0.035;  ///< beyond the wall of the arch
  double fillet = 0.003;
  double edge = 0;  ///< of the triangles; 0: a quarter of the smallest radius
};

Surface<3> generate(const TubeShape& shape);
Surface<3> generate(const BendShape& shape);
Surface<3> generate(const BifurcationShape& shape);
Surface<3> generate(const ArchShape& shape);

}  // namespace ostium::sph3d
