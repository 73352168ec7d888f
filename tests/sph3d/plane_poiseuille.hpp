/// Plane Poiseuille flow, fluid of the literature's case: d = 1 mm, Re = 50, exact u = 4 u_max y (d - y) / d^2.
#pragma once
#include <functional>
#include <memory>

#include "sph3d/vessel.hpp"

namespace ostium::sph3d {

struct Poiseuille {
  double profile_error = 0;  // rms over u_max
  double peak_error = 0;     // of the middle of the channel
  double shear_stress = 0;   // over the exact one
};

/// Of a channel, its particles' spacing, and the fluid's kernel's reach.
using MakeChannelWall =
    std::function<std::unique_ptr<DeformableWall<2>>(double length, double width, double dp, double reach)>;

/// Means over the last 0.4 of the time until `end`, s. Without a wall of its own the channel is rigid.
Poiseuille plane_poiseuille(int across, double end, const MakeChannelWall& wall = {});

}  // namespace ostium::sph3d
