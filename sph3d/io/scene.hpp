/// The three-dimensional part of a preview. Internal to io/.
#pragma once
#include "sph3d/geometry/lumen.hpp"
#include "sph3d/io/overlay.hpp"

namespace ostium::sph3d {

Colour opening_colour(int k);

/// Vessel, caps and arrows along the outward normals.
void add_vessel(vtkRenderer& renderer, const Lumen<3>& lumen);

/// The tip of the arrow of an opening.
Vec3 arrow_tip(const Lumen<3>& lumen, const Opening<3>& opening);

/// Looks along the direction in which the vessel is thinnest, z up if possible, without perspective; vessel and
/// arrows fill a picture of `pixels` but for the margin (both width, height).
void aim_camera(vtkRenderer& renderer, const Lumen<3>& lumen, const Vec2& pixels, const Vec2& margin);

/// Pixel of a point of space in the window.
Vec2 pixel(vtkRenderer& renderer, const Vec3& x);

/// A plane lumen as a thin sheet in space.
Lumen<3> sheet(const Lumen<2>& lumen);

}  // namespace ostium::sph3d
