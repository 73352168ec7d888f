/// The points at which a vessel's wall is looked at, at rest and as it stands now.
///
///   rigid wall   spread over the lateral surface at the spacing of the fluid; they stay
///   moving wall  its contact points; they move with it
///
///   position  m        on the surface that the blood touches
///   normal    -        unit, from the blood into the wall
///   area      m^(D-1)  share of that surface (walls/shell_body.hpp, walls/solid_body.hpp)
///
/// Source: docs/theory/walls.md, "Wall fields". Not checked: that a wall has not folded.
#pragma once
#include "sph3d/geometry/sample.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::sph3d {

template <int D>
std::vector<WallPoint<D>> wall_points_at_rest(const Vessel<D>& vessel);

/// `rest` is what wall_points_at_rest has returned, and what is returned for a rigid wall.
template <int D>
std::vector<WallPoint<D>> wall_points_now(const Vessel<D>& vessel, const std::vector<WallPoint<D>>& rest);

}  // namespace ostium::sph3d
