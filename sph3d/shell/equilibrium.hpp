/// Equilibrium under a constant load, by dynamic relaxation: the shell moves through a medium whose resistance follows its
/// slowest mode.
///
///   c = 2 omega,   omega^2 = -sum dF.dx / sum m dx.dx      (over the last steps, rotations included)
///
///   dF, dx    changes of forces and positions
///   tolerance   what is left of the motion over the largest displacement, by its decay and by its speed over omega   -
///
/// Source: Underwood 1983, Dynamic relaxation; docs/theory/shell.md. NumericsError when the steps run out. Not checked: that
/// the equilibrium is stable.
#pragma once
#include "sph3d/shell/step.hpp"

namespace ostium::sph3d {

struct EquilibriumOptions {
  double tolerance = 1e-6;
  int most_steps = 400000;
  int check_every = 20;
};

struct EquilibriumReport {
  int steps = 0;
  double residual = 0;   ///< see tolerance
  double frequency = 0;  ///< omega of the slowest mode seen, 1/s
};

/// Moves the state to the equilibrium and leaves it at rest.
template <int D>
EquilibriumReport find_equilibrium(const ShellModel<D>& model, ShellState<D>& state,
                                   const std::vector<ShellLoad<D>>& load,
                                   const EquilibriumOptions& options = {});

}  // namespace ostium::sph3d
