/// Steps of a shell in time, under loads that stay the same during one call.
///
///   r, n by dt/2;  [ stress, balance, v and w by dt, supports, r, n by dt ] n times, the last drift by dt/2
///
/// Forces are the exact derivatives of the discrete energy, so that without damping energy stays as well as the second
/// order of the scheme allows, and linear and angular momentum to rounding. Accelerations of the last kick remain in the
/// workspace. Same bits for any number of threads. Source: docs/theory/shell.md, section "One step".
/// NumericsError where a particle is no longer where numbers are.
#pragma once
#include "sph3d/shell/kernels.hpp"
#include "sph3d/shell/state.hpp"

namespace ostium::sph3d {

/// What a step derives from the state and forgets again.
template <int D>
struct ShellWorkspace {
  std::vector<ShellMotion> motion;
  std::vector<ShellStress<D>> stress;
  std::vector<ShellForce<D>> force;  // after a step: accelerations of position and normal

  explicit ShellWorkspace(const ShellModel<D>& model)
      : motion(8 * model.blocks()), stress(8 * model.blocks()), force(model.blocks()) {}

  Vec<D> acceleration(std::size_t a) const;
};

struct ShellSteps {
  double dt = 0;
  int count = 1;
  double mass_damping = 0;  ///< rate at which velocities decay, 1/s: for equilibria
};

template <int D>
void advance(const ShellModel<D>& model, ShellState<D>& state, const std::vector<ShellLoad<D>>& load,
             ShellWorkspace<D>& work, const ShellSteps& steps);

/// Copies the motion into the workspace and leaves in work.force the accelerations, moving nothing.
template <int D>
void accelerate(const ShellModel<D>& model, ShellState<D>& state, const std::vector<ShellLoad<D>>& load,
                ShellWorkspace<D>& work);

}  // namespace ostium::sph3d
