/// A shell as it is handed to the mechanics: particles on the mid-surface of a thin wall, stress-free.
///
///   position    on the mid-surface                                             m
///   normal      unit, from the blood into the wall                             -
///   area        of the mid-surface that belongs to the particle; in 2D a length per unit depth    m^(D-1)
///   thickness   of the wall                                                    m
///   stiffness   factor on the stress of the material; empty: 1 everywhere      -
///   support     what holds the particle; empty: all free                       -
///   axis        unit, the direction that `support` speaks of; empty: unused    -
///   circumference   tangent that fibre angles are measured from; empty: unused   -
///
/// A particle stands in the middle of its patch: a free edge runs half a spacing beyond the last row. Neighbours are
/// consecutive in memory after in_memory_order(), which makes the steps faster but changes no result beyond rounding.
/// Not checked: that positions lie on one smooth surface, that normals are perpendicular to it.
#pragma once
#include <vector>

#include "core/vec.hpp"

namespace ostium::sph3d {

/// What holds a shell particle.
///
///   free           nothing
///   clamped        neither moves nor turns
///   hinged         does not move, turns freely: a simply supported edge
///   roller         does not move along `axis`, turns freely
///   released       does not move along `axis` and does not turn: an end that may widen
///   diaphragm      moves along `axis` only, turns freely: an end plate that is stiff in its plane
///   symmetric      neither moves nor leans along `axis`: on a plane of symmetry
enum class Support { free, clamped, hinged, roller, released, diaphragm, symmetric };

template <int D>
struct ShellCloud {
  std::vector<Vec<D>> position, normal;
  std::vector<double> area, thickness;
  std::vector<double> stiffness;
  std::vector<Support> support;
  std::vector<Vec<D>> axis;
  std::vector<Vec<D>> circumference;

  std::size_t count() const { return position.size(); }
};

/// The same particles, sorted so that neighbours are near in memory.
template <int D>
ShellCloud<D> in_memory_order(const ShellCloud<D>& cloud);

/// UserError where an array is of another length, an area or a thickness not positive, a normal not a unit vector.
template <int D>
void check(const ShellCloud<D>& cloud);

}  // namespace ostium::sph3d
