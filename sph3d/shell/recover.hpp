/// What a shell has in it: strains, stresses through the thickness, energies. Plain and slow, for output and tests.
///
///   cauchy          sigma at chi = zeta t/2, global axes; zeta = -1 inner face, 0 mid-surface, 1 outer face     Pa
///   von_mises       of it                                                                             Pa
///   surface_energy  of the strains, J per reference area (2D: per metre depth as well); with pre-stress its work too,
///                   so that it may be negative                                                        J/m2
///   energies        summed over the shell: strain, zigzags (hourglass), motion and rotation           J
///
/// Stresses are elastic, with those of the reference (prestress.hpp): viscous parts are left out. In 2D the stress out of the plane is returned as well. The transverse
/// shear is that of the model, constant through the thickness, 5/6 of the material's. Source: docs/theory/shell.md.
#pragma once
#include "sph3d/shell/state.hpp"
#include "sph3d/shell/strain.hpp"

namespace ostium::sph3d {

/// Current tangents and their strains at particle a.
template <int D>
struct ShellPoint {
  static constexpr int T = D - 1;
  Vec<D> x[T], dn[T], n, zigzag;  ///< dx/dxi_a, dn/dxi_a, pseudo-normal, hourglass displacement
  ShellStrains<T, double> strains;
  double curvature[T][T];

  ShellPoint(const ShellModel<D>& model, const ShellState<D>& state, std::size_t a);
  /// Unit normal of the deformed mid-surface.
  Vec<D> geometric_normal() const;
  /// Current over reference area of the mid-surface.
  double area_stretch() const;
};

template <int D>
struct WallStress {
  Eigen::Matrix3d cauchy;  ///< in 2D x, y and out of the plane
  double thickness_stretch;

  double von_mises() const;
};

template <int D>
WallStress<D> wall_stress(const ShellModel<D>& model, const ShellState<D>& state, std::size_t a, double zeta);

struct ShellEnergies {
  double strain = 0, zigzag = 0, motion = 0, rotation = 0;
  double total() const { return strain + zigzag + motion + rotation; }
};

template <int D>
double surface_energy(const ShellModel<D>& model, const ShellState<D>& state, std::size_t a);
template <int D>
ShellEnergies energies(const ShellModel<D>& model, const ShellState<D>& state);

}  // namespace ostium::sph3d
