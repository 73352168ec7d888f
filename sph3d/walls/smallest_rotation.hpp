/// The smallest rotation from one unit vector to another: what a normal's change says of how the wall has turned.
///
/// The identity where they are nearly opposite.
#pragma once
#include "core/vec.hpp"

namespace ostium::sph3d {

template <int D>
Mat<D> smallest_rotation(const Vec<D>& from, const Vec<D>& to) {
  const double c = from.dot(to);
  if (c < -0.9) return Mat<D>::Identity();
  const Mat<D> K = to * from.transpose() - from * to.transpose();  // K u = axis x u, times the sine
  return Mat<D>::Identity() + K + K * K / (1.0 + c);
}

}  // namespace ostium::sph3d
