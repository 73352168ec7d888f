/// Wall shear stress from the velocity gradient: what the flow beside the wall says, independent of the wall's own friction.
///
///   u_i = gamma s_i + b s_i^2    least squares over the particles in front of the wall point, no slip at s = 0
///   tau = rho nu gamma
///
///   symbol   meaning                                                                              unit
///   s        distance from the wall, up to 3 h                                                    m
///   u        velocity relative to the wall's, along the wall                                      m/s
///   gamma    shear rate                                                                           1/s
///
/// Particles count with s and with the kernel of their distance along the wall: the layer next to the wall has the error of the
/// wall's own friction, 2 to 8 % of its velocity, and is to weigh little. Where fewer than two layers are seen the fit is linear. It
/// differs from the stress of the forces (wall_loads.hpp) where the boundary layer is not resolved. Source:
/// docs/theory/walls.md, "Wall shear stress". Not checked: that the flow near the wall is laminar.
#pragma once
#include "sph3d/fields/wall_points.hpp"

namespace ostium::sph3d {

/// At points that stand where the wall is now. Zero where no particle is near.
template <int D>
std::vector<Vec<D>> shear_stress_from_gradient(const Vessel<D>& vessel, const std::vector<WallPoint<D>>& now);

}  // namespace ostium::sph3d
