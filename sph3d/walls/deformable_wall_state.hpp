/// A moving wall as plain data.
#pragma once
#include <vector>

#include "sph3d/shell/state.hpp"
#include "sph3d/solid/solid_state.hpp"

namespace ostium::sph3d {

template <int D>
struct DeformableWallState {
  ShellState<D> shell = {};  ///< of the two bodies the one that the wall is made of; the other is empty
  SolidState<D> solid = {};
  std::vector<Vec<D>> velocity;  ///< of the contact points during the last acoustic step, m/s
  std::vector<Vec<D>> impact;    ///< force on them that the next kick brings, N
  double withheld = 0;           ///< part of the load at the start that comes by and by, Pa

  bool empty() const { return velocity.empty(); }
};

}  // namespace ostium::sph3d
