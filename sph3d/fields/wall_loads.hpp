/// What the blood does to the wall: pressure and wall shear stress at the wall points.
///
///   tau_a = (I - n n^T) sum_i w_ia F_i / A_a,   F_i = rho V f_i (v_i - v_wall),   sum_a w_ia = 1
///   p_a   = sum_i w_ia p_i / sum_i w_ia
///
///   tau   Pa   wall shear stress, the force of the friction of the particles near the wall: its integral over the wall is
///              exactly the force the fluid has felt, so the mean is right however rough the single value
///   p     Pa   physical pressure
///   f_i   1/s  friction rate of the particle (see step/prepare.hpp)
///
/// Particles in the ducts do not count. Source: docs/theory/walls.md, "Wall shear stress". Not checked: resolution of the
/// boundary layer; at least five particles per layer are needed for a pulsatile flow.
#pragma once
#include "sph3d/geometry/sample.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::sph3d {

template <int D>
struct WallLoads {
  std::vector<Vec<D>> shear_stress;
  std::vector<double> pressure;
};

/// The loads at the corners of the input surface: mean over the wall points within reach that face the same way, weighted
/// with the kernel; zero at corners without any.
template <int D>
WallLoads<D> mapped_to_surface(const Model<D>& model, const std::vector<WallPoint<D>>& wall,
                               const WallLoads<D>& loads);

template <int D>
WallLoads<D> wall_loads(const Vessel<D>& vessel, const std::vector<WallPoint<D>>& wall);

}  // namespace ostium::sph3d
