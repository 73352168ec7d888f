/// Plane polygons: the rim of an opening seen along its normal. Internal to geometry/.
#pragma once
#include <span>
#include <vector>

#include "core/vec.hpp"

namespace ostium::sph3d {

using Polygon = std::vector<Vec2>;

bool inside(std::span<const Vec2> polygon, const Vec2& x);

/// Distance to the polygon's boundary.
double boundary_distance(std::span<const Vec2> polygon, const Vec2& x);

/// Positive when counter-clockwise.
double signed_area(std::span<const Vec2> polygon);

/// Radius of the largest circle inside, to 0.1 %.
double inscribed_radius(std::span<const Vec2> polygon);

/// Triangles (indices) that fill a simple polygon by cutting ears; the polygon must be counter-clockwise.
std::vector<std::array<int, 3>> triangulate(std::span<const Vec2> polygon);

}  // namespace ostium::sph3d
