/// The lumen of a 2D vessel from its outline, a closed polygon some of whose edges are openings.
///
///   points   m   corners in order, either sense, the last one joined to the first
///   edge     -   the edge k runs from points[k] to points[k + 1]
///   nearest  m   instead of `edge`: the edge whose midpoint is nearest to this point
///
/// Refused: fewer than three corners, coinciding neighbours, an outline that crosses itself, no opening,
/// two names on one edge, an edge number out of range.
#pragma once
#include <optional>
#include <span>

#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

struct OutlineOpening {
  std::string name;
  std::optional<int> edge = {};
  std::optional<Vec2> nearest = {};
};

Lumen<2> polygon_lumen(std::span<const Vec2> points, std::span<const OutlineOpening> openings);

}  // namespace ostium::sph3d
