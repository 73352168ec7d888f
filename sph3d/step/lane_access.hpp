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

/// f(cluster) for every cluster, in parallel, each by one thread.
template <class F>
void for_clusters(std::size_t n, F&& f) {
#pragma omp parallel for schedule(static)
  for (std::size_t c = 0; c < n; ++c) f(c);
}

/// f(begin, end) over batches of clusters, for the kernels.
template <class F>
void for_batches(std::size_t n, F&& f) {
#pragma omp parallel for schedule(static)
  for (std::size_t begin = 0; begin < n; begin += 16) f(begin, begin + 16 < n ? begin + 16 : n);
}

}  // namespace ostium::sph3d
