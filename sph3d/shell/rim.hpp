/// The rim in which a wall ends: how far away it is, and the wall as seen in the mirror of its plane. Internal to shell/.
///
///   depth       from the plane into the vessel                             m
///   distance    to the outline                                             m
///   mirrored    x + 2 depth o,  n - 2 (n.o) o,  o the normal of the opening
#pragma once
#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

template <int D>
class Rim {
 public:
  /// `beyond` the opening, in a straight duct.
  Rim(const Opening<D>& opening, double beyond);

  double depth(const Vec<D>& x) const { return (centre_ - x).dot(normal_); }
  double distance(const Vec<D>& x) const;
  /// Whether x lies within this depth of the plane, and near this rim rather than elsewhere on the plane. A wall may meet
  /// the plane at 30 degrees.
  bool near(const Vec<D>& x, double depth) const;
  Vec<D> mirrored(const Vec<D>& x) const { return x + 2.0 * depth(x) * normal_; }
  Vec<D> turned(const Vec<D>& n) const { return n - 2.0 * n.dot(normal_) * normal_; }
  const Vec<D>& normal() const { return normal_; }

 private:
  Vec<D> centre_, normal_;
  std::vector<Vec<D>> outline_;
  double radius_ = 0;  // of a ball around the centre that holds the outline
};

}  // namespace ostium::sph3d
