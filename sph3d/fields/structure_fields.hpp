/// Stress and energy of a wall that moves at all of its contact points, for output.
///
///   stress        Cauchy, elastic: xx yy zz xy yz xz                                                     Pa
///                   shell   at the inner face, the mid-surface and the outer face
///                   solid   of the nearest particles of the innermost, the middle and the outermost layer: half a spacing
///                           inside the faces
///   von_mises     of each of them                                                                        Pa
///   energy        of the strains through the thickness, per area of the reference                        J/m2
///
/// In 2D zz is the stress out of the plane. Source: shell/recover.hpp, solid/solid_report.hpp.
#pragma once
#include "sph3d/walls/deformable_wall.hpp"

namespace ostium::sph3d {

struct StructureFields {
  struct Depth {
    std::vector<Vec<6>> stress;
    std::vector<double> von_mises;
  };
  Depth inner, middle, outer;
  std::vector<double> energy;
};

template <int D>
StructureFields structure_fields(const ShellBody<D>& body, const ShellState<D>& state);
template <int D>
StructureFields structure_fields(const SolidBody<D>& body, const SolidState<D>& state);
template <int D>
StructureFields structure_fields(const DeformableWall<D>& wall, const DeformableWallState<D>& state);

/// Of the strains of the whole wall, J (2D: per metre of depth); with pre-stress the work of that too.
template <int D>
double strain_energy(const DeformableWall<D>& wall, const DeformableWallState<D>& state);

}  // namespace ostium::sph3d
