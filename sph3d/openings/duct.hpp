/// The straight duct that continues the vessel beyond an opening, where particles are made and deleted.
///
///         cap                    outer face
///   vessel |   measuring plane    |  half-space: fluid at the port's pressure
///          |<------ length ------>|
///          s = length ....... s = 0         s: depth, inward from the outer face
///
///   symbol     meaning                                                        unit
///   depth      s                                                              m
///   length     of the duct, `layers` particle spacings                        m
///   crossed    share of a particle that has left the vessel, a smooth step     -
///              of half-width 2 dp around the plane 2 dp outside the cap
///
/// The smooth step makes the counted volume M = sum V crossed + V deleted - V inserted a smooth function of
/// time whose rate is the flow, and insertion and deletion (s < 2 dp) do not show in it. Source:
/// docs/theory/openings.md.
#pragma once
#include <vector>

#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

template <int D>
class Duct {
 public:
  static constexpr int layers = 6;

  Duct(const Opening<D>& opening, double dp);

  const Opening<D>& opening() const { return opening_; }
  double length() const { return length_; }
  double spacing() const { return dp_; }
  double depth(const Vec<D>& x) const { return length_ - (x - opening_.centre).dot(opening_.normal); }
  /// Whether x lies in the duct: beyond the cap, before the outer face (with three spacings to spare) and near
  /// the axis.
  bool holds(const Vec<D>& x) const;
  /// Whether x lies in the vessel within two spacings of the cap: where the pressure of the opening is read.
  bool before_cap(const Vec<D>& x) const;
  /// Whether anything within this distance of x can lie in one or the other.
  bool near(const Vec<D>& x, double distance) const;
  double crossed(double depth) const;
  /// The point of the duct at this depth, opposite to x in the plane of the opening.
  Vec<D> at_depth(const Vec<D>& x, double depth) const {
    return x + (this->depth(x) - depth) * opening_.normal;
  }

 private:
  Opening<D> opening_;
  double dp_, length_, radius_;
};

extern template class Duct<2>;
extern template class Duct<3>;

}  // namespace ostium::sph3d
