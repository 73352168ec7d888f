/// Averages over the near points of a surface, time and again: what is left is smooth over a length. Internal to shell/.
///
///   <f>_a = sum_b W_ab A_b f_b / sum_b W_ab A_b,    b = a included, W the reduced kernel of the shell
///
///   variance   of one average, along each direction: 5/18 h^2 on a surface, 2/7 h^2 on a line     m2
///   length     l: n averages spread a point over l^2 = n variance, along each direction             m
///
/// Repeated short averages follow the surface and do not reach across a gap to a neighbouring branch, as one long one would.
/// Not corrected at rims: a field that is even along the axis stays what it is there.
#pragma once
#include "sph3d/shell/reduced_kernel.hpp"
#include "sph3d/shell/surface_pairs.hpp"
#include "sph3d/shell/surface_points.hpp"

namespace ostium::sph3d {

template <int D>
class SurfaceAverage {
 public:
  SurfaceAverage(const SurfacePoints<D>& points, double spacing);

  double variance() const { return (D == 3 ? 5.0 / 18.0 : 2.0 / 7.0) * kernel_.h * kernel_.h; }
  const SurfacePairs<D>& pairs() const { return pairs_; }

  /// <f> at a.
  template <class Field>
  Field operator()(const std::vector<Field>& f, std::size_t a) const {
    Field sum = own_[a] * f[a];
    const double* w = &weight_[begin_[a]];
    for (const auto [b, rim] : pairs_.of(a)) sum += *w++ * f[b];
    return sum;
  }

 private:
  ReducedKernel<D> kernel_;
  SurfacePairs<D> pairs_;
  std::vector<std::size_t> begin_;
  std::vector<double> own_, weight_;
};

/// Normals averaged so often, one row per pass; each by its own share of a pass, between 0 and 1.
template <int D>
void smooth(std::vector<Vec<D>>& normal, const SurfaceAverage<D>& average, const std::vector<double>& share,
            int passes);

extern template class SurfaceAverage<2>;
extern template class SurfaceAverage<3>;

}  // namespace ostium::sph3d
