#include "sph3d/openings/duct.hpp"

#include <algorithm>

namespace ostium::sph3d {

template <int D>
Duct<D>::Duct(const Opening<D>& opening, double dp)
    : opening_(opening), dp_(dp), length_(layers * dp), radius_(0) {
  for (const Vec<D>& p : opening.outline) radius_ = std::max(radius_, (p - opening.centre).norm());
}

template <int D>
bool Duct<D>::holds(const Vec<D>& x) const {
  const Vec<D> r = x - opening_.centre;
  const double out = r.dot(opening_.normal);
  if (out < 0.0 || out > length_ + 3.0 * dp_) return false;
  return (r - out * opening_.normal).norm() < radius_ + 0.5 * dp_;
}

template <int D>
bool Duct<D>::before_cap(const Vec<D>& x) const {
  const Vec<D> r = x - opening_.centre;
  const double out = r.dot(opening_.normal);
  return out <= 0.0 && out > -2.0 * dp_ && (r - out * opening_.normal).norm() < radius_ + 0.5 * dp_;
}

template <int D>
bool Duct<D>::near(const Vec<D>& x, double distance) const {
  const Vec<D> r = x - opening_.centre;
  const double out = r.dot(opening_.normal);
  if (out < -2.0 * dp_ - distance || out > length_ + 3.0 * dp_ + distance) return false;
  return (r - out * opening_.normal).norm() < radius_ + 0.5 * dp_ + distance;
}

template <int D>
double Duct<D>::crossed(double depth) const {
  const double x = std::clamp((length_ - depth) / (4.0 * dp_), 0.0, 1.0);
  return x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
}

template class Duct<2>;
template class Duct<3>;

}  // namespace ostium::sph3d
