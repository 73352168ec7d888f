#include "sph3d/shell/rim.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::sph3d {

template <int D>
Rim<D>::Rim(const Opening<D>& opening, double beyond)
    : centre_(opening.centre + beyond * opening.normal), normal_(opening.normal) {
  for (const auto& x : opening.outline) {
    outline_.push_back(x + depth(x) * normal_);
    radius_ = std::max(radius_, (outline_.back() - centre_).norm());
  }
}

template <>
double Rim<2>::distance(const Vec2& x) const {
  double least = 1e300;
  for (const auto& end : outline_) least = std::min(least, (x - end).norm());
  return least;
}

template <>
double Rim<3>::distance(const Vec3& x) const {
  double least2 = 1e300;
  for (std::size_t k = 0; k < outline_.size(); ++k) {
    const Vec3 &a = outline_[k], &b = outline_[(k + 1) % outline_.size()];
    const double t = std::clamp((b - a).dot(x - a) / std::max((b - a).squaredNorm(), 1e-300), 0.0, 1.0);
    least2 = std::min(least2, (x - a - t * (b - a)).squaredNorm());
  }
  return std::sqrt(least2);
}

template <int D>
bool Rim<D>::near(const Vec<D>& x, double deep) const {
  if (depth(x) > deep || (x - centre_).norm() > radius_ + 2.0 * deep) return false;
  return distance(x) < 2.0 * deep;
}

template class Rim<2>;
template class Rim<3>;

}  // namespace ostium::sph3d
