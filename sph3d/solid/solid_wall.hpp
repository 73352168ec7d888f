/// The wall of a vessel in its full thickness, clamped where the openings are.
///
///   symbol          meaning                                                                                unit
///   spacing         dp_s of its particles; at least four layers of them fit into the thickness                 m
///   fluid_spacing   dp of the fluid; the wall's may not be coarser                                         m
///   thickness       t, the same everywhere                                                                 m
///   clamp_length    how far inside its opening an end is held, in all of its thickness; 0: 2 h of the fluid and one row, three
///                   rows at least                                                                           m
///
/// Source: docs/theory/solid.md, "Walls". Refused: what wall_cloud refuses, a spacing coarser than the fluid's, ends that are not
/// plane, ends so near each other that they hold the whole wall. Not checked: that layers bent more tightly than the thickness
/// still cover each other.
#pragma once
#include "sph3d/solid/wall_cloud.hpp"

namespace ostium::sph3d {

struct SolidWallOptions {
  double spacing = 0, fluid_spacing = 0, thickness = 0, clamp_length = 0;
};

template <int D>
WallCloud<D> solid_of(const Lumen<D>& lumen, const SolidWallOptions& options);

}  // namespace ostium::sph3d
