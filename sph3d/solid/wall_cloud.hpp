/// The particles of a vessel's wall, between its inner surface and the surface a thickness further out.
///
///   layers   n = round(thickness/spacing), layer k on the offset surface at (k + 1/2) thickness/n
///   volume   V = A thickness/n, A the particle's share of the area of its layer
///
///   depth    distance from the inner surface                          m
///   normal   out of the lumen, unit
///   layer    0 next to the lumen
///   inner    the inner surface, for the pressure of the blood: its area vectors point out of the wall, into the lumen
///   contact  its point next to each particle of the first layer, in the order of inner.particle                 m
///   column   above which of these points a particle stands
///
/// Each layer is spread over its own surface (geometry/sample.hpp), so that layers lie where they belong and the mass is that of
/// the wall: the sum over layers is exact but for t^3/12 of the Gauss curvature. Where the offset surface would cut itself, at
/// a crotch, what is nearer to the lumen than its layer is left out. The wall ends in the planes of the openings. Particles come in
/// bisection order. Refused: fewer than four layers, a thickness that is not positive. Source: docs/theory/solid.md.
#pragma once
#include "sph3d/geometry/lumen.hpp"
#include "sph3d/solid/solid_step.hpp"

namespace ostium::sph3d {

template <int D>
struct WallCloud {
  SolidCloud<D> solid;
  std::vector<double> depth;
  std::vector<Vec<D>> normal;
  std::vector<int> layer;
  PressurePatch<D> inner;
  std::vector<Vec<D>> contact;
  std::vector<std::int32_t> column;
};

template <int D>
WallCloud<D> wall_cloud(const Lumen<D>& lumen, double thickness, double spacing);

}  // namespace ostium::sph3d
