/// The space inside a vessel: its closed surface and the openings where blood enters and leaves.
///
///   name       -     opening1, opening2, ... by falling area unless the case names them
///   centre     m     area centroid of the opening
///   normal     -     unit normal, out of the vessel
///   area       m2    (2D: width, m)
///   outline    m     the rim as an ordered loop, counter-clockwise seen from outside (2D: its two ends)
///   face_id    -     ModelFaceID of the file (or number of the named solid), -1 if the file has none
///   planarity  m     largest distance of a point of the opening to its plane
///   volume     m3    of the lumen (2D: m2);   wall_area  m2  without the openings (2D: m)
///
/// Not checked: that the openings are wide enough for a particle spacing (width() tells), self-intersection.
#pragma once
#include <string>

#include "sph3d/geometry/surface.hpp"

namespace ostium::sph3d {

/// What was found or mended while reading, one readable sentence each.
using Notes = std::vector<std::string>;

template <int D>
struct Opening {
  std::string name = {};
  Vec<D> centre = Vec<D>::Zero(), normal = Vec<D>::Zero();
  double area = 0;
  std::vector<Vec<D>> outline = {};
  int face_id = -1;
  double planarity = 0;
  std::string face_name = {};
};

template <int D>
struct Lumen {
  Surface<D> surface = {};
  std::vector<Opening<D>> openings = {};
  double volume = 0, wall_area = 0;
  Notes repairs = {};
};

/// The lumen with every opening moved outward along its normal by `length` (m): straight ducts whose walls
/// carry the label -1 and whose ends are exactly planar. The openings keep their original planes.
template <int D>
Lumen<D> extended(const Lumen<D>& lumen, double length);

/// Whether the projection of x on the plane of the opening lies inside its outline.
template <int D>
bool inside_outline(const Opening<D>& opening, const Vec<D>& x);

/// Diameter of the largest circle that fits in the opening, m (2D: its length).
template <int D>
double width(const Opening<D>& opening);

/// The longest straight way between two openings, or from a single one to the wall, m: the length of the vessel where one number must do.
template <int D>
double length_between_openings(const Lumen<D>& lumen);

/// Two unit tangents that make (tangent 0, tangent 1, normal) a right-handed frame (2D: the first one only).
template <int D>
Eigen::Matrix<double, D, D - 1> plane_frame(const Vec<D>& normal);

}  // namespace ostium::sph3d
