/// The velocity profile of a flow-driven opening: v_n(x, t) = (Q(t) / A) shape(x), shape with mean 1 over the
/// opening.
///
///   plug        shape = 1
///   parabolic   shape = Phi / <Phi>,  laplace Phi = -1 inside the outline, Phi = 0 on it: developed laminar
///   flow for any
///               outline; the parabola of a circle (2: centre over mean) or of a plane channel (3/2)
///
/// The Poisson problem is solved once on a lattice with irregular legs at the outline (Shortley & Weller
/// 1938), which is exact for a circle. Source: docs/theory/openings.md, section "Profiles".
#pragma once
#include <memory>

#include "sph3d/geometry/lumen.hpp"

namespace ostium::sph3d {

enum class Profile { plug, parabolic };

template <int D>
class FlowShape {
 public:
  FlowShape(Profile profile, const Opening<D>& opening);
  double operator()(const Vec<D>& x) const;

 private:
  Profile profile_;
  Vec<D> centre_;
  Eigen::Matrix<double, D, D - 1> frame_;
  double half_width_ = 0;       // 2D
  Vec2 origin_ = Vec2::Zero();  // 3D: lattice of values over the outline
  double spacing_ = 1;
  int size_ = 0;
  std::vector<double> values_;
};

extern template class FlowShape<2>;
extern template class FlowShape<3>;

}  // namespace ostium::sph3d
