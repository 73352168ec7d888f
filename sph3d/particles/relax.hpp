/// Relaxation of a cloud of particles towards uniform number density.
///
///   dx_i = -0.4 h^2 (sum_j grad W V + grad S(x_i)),   at most dp/10 per iteration
///
///   points    m   the particles, moved in place
///   fixed     -   particles that only push
///   outside   -   filling and flux of what lies outside the fluid (walls, caps), from any thread
///   volume    m^D of one particle
///
/// Source: docs/theory/particles.md. The cloud settles where the kernel gradient sums vanish, which is also
/// the state the transport shift of the flow tends to. Returns the rms of h |sum| over the free particles at
/// the end.
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "sph3d/walls/wall_field.hpp"

namespace ostium::sph3d {

template <int D>
struct Relaxation {
  std::function<WallSample<D>(const Vec<D>&)> outside;
  Wendland<D> kernel;
  double volume;
  int iterations = 200;
  std::function<void(int)> progress = {};
};

template <int D>
double relax(std::vector<Vec<D>>& points, const std::vector<std::uint8_t>& fixed, const Relaxation<D>& how);

}  // namespace ostium::sph3d
