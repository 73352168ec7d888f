/// Stress and energy of a shell at all of its particles, for output.
///
///   stress        Cauchy, elastic, at the inner face, the mid-surface and the outer face: xx yy zz xy yz xz        Pa
///   von_mises     of each of them                                                                        Pa
///   energy        of the strains, per area of the reference                                              J/m2
///
/// In 2D zz is the stress out of the plane. Source: shell/recover.hpp.
#pragma once
#include "sph3d/shell/recover.hpp"

namespace ostium::sph3d {

struct ShellFields {
  struct Depth {
    std::vector<Vec<6>> stress;
    std::vector<double> von_mises;
  };
  Depth inner, middle, outer;
  std::vector<double> energy;
};

template <int D>
ShellFields shell_fields(const ShellModel<D>& model, const ShellState<D>& state);

}  // namespace ostium::sph3d
