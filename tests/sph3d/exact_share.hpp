/// What of a kernel's support lies in a wall, by integration along rays: exact but for rounding.
///
///   S = int d theta int_l W r dr,    dS/dn = int cos(theta) d theta int_l |W'| r dr,   l(theta): where a ray enters the wall
///
/// In 3D W is first summed up along the axis of the tube. Lengths in particle spacings.
#pragma once
#include <vector>

#include "sph3d/fluid/wendland.hpp"

namespace ostium::sph3d {

template <int D>
class ExactShare {
 public:
  explicit ExactShare(const Wendland<D>& kernel);

  struct Share {
    double filling, flux;  // flux: grad S along the normal
  };
  /// At distance s from the wall of a tube of radius R.
  Share tube(double R, double s) const;
  Share plane(double s) const { return tube(1e7, s); }
  /// S at x for a wall in a plane, between the angles pi - half and pi + half.
  double apex(const Vec2& x, double half_angle) const;

 private:
  static constexpr int n = 2000, rays = 2000;
  double at(const std::vector<double>& table, double r) const;

  double reach_;
  std::vector<double> beyond_, flux_beyond_;  // the inner integrals from r on
};

extern template class ExactShare<2>;
extern template class ExactShare<3>;

}  // namespace ostium::sph3d
