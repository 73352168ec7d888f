/// What the blood does to the whole wall between the caps, and how far that has gone from where it was.
///
///   symbol     meaning                                                                        unit
///   pressure   force of the physical pressure on the wall, out of the blood: int p n dA       N
///                rigid     p_0 A + sum_a (p_a - p_0) A_a n_a     sampled pressures, p_0 their mean
///                moving    p_ref sum_a A_a n_a + sum_a F_a - friction
///   friction   force of the blood's friction along the wall, all that particles have lost     N
///   A          area vector of the wall as read, so that a uniform pressure is exact           m^(D-1)
///   F_a        what the blood has done in the last acoustic step (DeformableWall)             N
///   p_ref      part of the pressure that the fluid does not carry (PressureDatum)             Pa
///
/// In 2D forces are per metre of depth. They are those of the blood alone: neither the pressure of the tissue
/// around the vessel nor what is withheld from a moving wall at the start is taken off. On a moving wall
/// pressure and friction together are the force that moves it, of the particles beyond the caps as well that
/// its last points feel. Before the first step it is sampled as on a rigid wall. Source:
/// docs/theory/walls.md, "The whole wall".
#pragma once
#include "sph3d/fields/wall_loads.hpp"

namespace ostium::sph3d {

template <int D>
struct WallForce {
  Vec<D> pressure = Vec<D>::Zero(), friction = Vec<D>::Zero();
};

/// The sampler has sampled this vessel, now.
template <int D>
WallForce<D> wall_force(const Vessel<D>& vessel, const WallSampler<D>& sampled);

/// The wall point that has gone furthest, where it is now.
template <int D>
struct Furthest {
  double displacement = 0;  ///< m
  Vec<D> position = Vec<D>::Zero();
};

template <int D>
Furthest<D> furthest_displaced(const std::vector<WallPoint<D>>& rest, const std::vector<WallPoint<D>>& now);

}  // namespace ostium::sph3d
