/// One particle of a cluster as ordinary vectors: for everything that is not a kernel.
#pragma once
#include "core/vec.hpp"
#include "sph3d/fluid/cluster.hpp"

namespace ostium::sph3d {

template <int D>
Vec<D> lane_vector(const float (&field)[D][8], std::size_t lane) {
  Vec<D> v;
  for (int d = 0; d < D; ++d) v[d] = field[d][lane];
  return v;
}

template <int D>
void lane_assign(float (&field)[D][8], std::size_t lane, const Vec<D>& v) {
  for (int d = 0; d < D; ++d) field[d][lane] = static_cast<float>(v[d]);
}

/// A symmetric matrix from its upper triangle.
template <int D>
Mat<D> lane_matrix(const float (&field)[symmetric_size<D>][8], std::size_t lane) {
  Mat<D> m;
  for (int a = 0, k = 0; a < D; ++a)
    for (int b = a; b < D; ++b) m(a, b) = m(b, a) = field[k++][lane];
  return m;
}

}  // namespace ostium::sph3d
