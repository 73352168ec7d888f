/// What a solid holds: energies and stresses, in plain double precision.
///
///   kinetic     sum m v^2 / 2                                                                   J  (2D: J/m)
///   strain      sum V Psi(E_a)                                                                  J
///   hourglass   sum_a V_a alpha mu / 2 sum_b V_b |W'|/r |u_ab - (F_a - I) X_ab|^2               J
///   cauchy      sigma = F S F^T / J, of one particle                                            Pa
///
/// Strain and hourglass energy together are the potential of the forces in solid_step. Source: docs/theory/solid.md.
#pragma once
#include "sph3d/solid/solid_state.hpp"

namespace ostium::sph3d {

struct SolidEnergy {
  double kinetic = 0, strain = 0, hourglass = 0;
  double total() const { return kinetic + strain + hourglass; }
};

template <int D>
SolidEnergy energy(const SolidModel<D>& model, const SolidState<D>& state);

/// V Psi(E_a) of one particle, J.
template <int D>
double strain_energy(const SolidModel<D>& model, const SolidState<D>& state, std::size_t a);

/// In 2D with the component out of the plane, zz.
template <int D>
Sym3<double> cauchy_stress(const SolidModel<D>& model, const SolidState<D>& state, std::size_t a);

}  // namespace ostium::sph3d
