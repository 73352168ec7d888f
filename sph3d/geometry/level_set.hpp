/// Surfaces from level sets: tubes along lines and arcs, blended, polygonised and cut by planes. Internal to
/// geometry/; see generate.hpp for the equation.
#pragma once
#include <functional>

#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

/// Part of a centreline: a line, or an arc of the circle centre + R (cos a u + sin a v), 0 <= a <= angle.
struct Piece {
  Vec3 start, end;  ///< of a line
  Vec3 centre = {}, u = {}, v = {};
  double arc_radius = 0, angle = 0;  ///< arc_radius > 0 marks an arc
  double length() const;
};

Piece line(const Vec3& start, const Vec3& end);
Piece arc(const Vec3& centre, const Vec3& u, const Vec3& v, double radius, double angle);

/// A tube along its pieces; the radius changes linearly with the arc length from `first` to `last`.
struct TaperedTube {
  std::vector<Piece> pieces;
  double first, last;
};

using LevelSet = std::function<double(const Vec3&)>;

LevelSet blend(std::vector<TaperedTube> tubes, double fillet);

/// f = 0 inside the box: vertices one per crossed cell (surface nets), moved onto f = 0 and evened out.
Surface<3> polygonise(const LevelSet& f, const Bounds<3>& box, double cell);

/// Where a tube ends: everything beyond the plane within `reach` of its centre is cut away.
struct End {
  Vec3 centre, normal;
  double reach;
};

/// Cuts the surface and closes it by a flat cap that carries `label`.
void cut(Surface<3>& surface, const End& end, int label, double cell);

}  // namespace ostium::sph3d
