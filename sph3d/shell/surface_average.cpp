#include "sph3d/shell/surface_average.hpp"

namespace ostium::sph3d {

namespace {

constexpr double smoothing = 1.15;  // h over the spacing, that of the shell

}  // namespace

template <int D>
SurfaceAverage<D>::SurfaceAverage(const SurfacePoints<D>& p, double spacing)
    : kernel_{smoothing * spacing}, pairs_(p.position, p.normal, {}, kernel_.reach()) {
  for (std::size_t a = 0; a < p.position.size(); ++a) {
    begin_.push_back(weight_.size());
    double sum = kernel_.value(0.0) * p.area[a];
    own_.push_back(sum);
    for (const auto [b, rim] : pairs_.of(a)) {
      weight_.push_back(kernel_.value((p.position[a] - p.position[b]).norm()) * p.area[b]);
      sum += weight_.back();
    }
    own_[a] /= sum;
    for (auto k = begin_[a]; k < weight_.size(); ++k) weight_[k] /= sum;
  }
}

template <int D>
void smooth(std::vector<Vec<D>>& normal, const SurfaceAverage<D>& average, const std::vector<double>& share,
            int passes) {
  std::vector<Vec<D>> next(normal.size());
  for (int pass = 0; pass < passes; ++pass) {
#pragma omp parallel for schedule(static)
    for (std::size_t a = 0; a < normal.size(); ++a)
      next[a] = ((1.0 - share[a]) * normal[a] + share[a] * average(normal, a)).normalized();
    normal.swap(next);
  }
}

template class SurfaceAverage<2>;
template class SurfaceAverage<3>;
template void smooth(std::vector<Vec<2>>&, const SurfaceAverage<2>&, const std::vector<double>&, int);
template void smooth(std::vector<Vec<3>>&, const SurfaceAverage<3>&, const std::vector<double>&, int);

}  // namespace ostium::sph3d
