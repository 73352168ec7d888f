/// Walls that are compared with each other, on shapes with an exact solution. Lengths in particle spacings, h = 1.3.
#pragma once
#include <memory>
#include <string>

#include "frozen_fluid.hpp"

namespace ostium::sph3d {

template <int D>
struct WallShape {
  std::function<double(const Vec<D>&)> distance;  // to the wall, positive in the fluid
  std::function<std::vector<bench::Shell<D>>(double spacing)> shells;
  Vec<D> lower, upper;                                     // bounds of the fluid
  double area = 0;                                         // of the wall in a period of the fluid
  std::function<double(const Vec<D>&)> velocity = {};      // steady flow at unit force and viscosity
  FrozenFluid<D> fluid = {};                               // as many particles as belong there, in disorder
  mutable std::shared_ptr<const WallField<D>> table = {};  // of the field, made when first asked for
};

/// Between x_D = 0 and height, periodic.
template <int D>
WallShape<D> channel_shape(int height, int length);
/// Around x_3, periodic along it (2D: a disc, with the flow across it). R or length adapt to a whole number of particles.
template <int D>
WallShape<D> tube_shape(double R, double length);
/// A wall between the angles pi - half and pi + half; without a fluid. The curvature of its shells is that of their normals,
/// limited so that layers end before they meet.
WallShape<2> apex_shape(double half_angle);

template <int D>
struct Rival {
  std::string name;
  Wall<D> wall;
};

/// Virtual layers.
template <int D>
Rival<D> layers(const WallShape<D>& shape, double spacing, const bench::LayerFriction& friction = {});
/// The program's wall; most: see HalfSpace. Its half-space stands where it fills as much; otherwise at the true distance.
template <int D>
Rival<D> field(const WallShape<D>& shape, double most = 2, bool true_distance = false);

}  // namespace ostium::sph3d
