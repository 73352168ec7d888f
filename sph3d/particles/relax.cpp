#include "sph3d/particles/relax.hpp"

#include <algorithm>
#include <cmath>

#include "sph3d/neighbours/order.hpp"
#include "sph3d/neighbours/row_lists.hpp"

namespace ostium::sph3d {

namespace {

template <int D>
struct Cloud {
  std::vector<Cluster<D>> clusters;
  std::vector<ClusterSums<D>> sums;
  std::vector<PlaceRecord> place;
  RowLists<D> rows;

  void freeze(const std::vector<Vec<D>>& points, const std::vector<std::int32_t>& order, double reach) {
    const std::size_t places = (points.size() + 7) / 8 * 8;
    clusters.resize(places / 8);
    sums.resize(places / 8);
    place.assign(places + 1, {far_away, far_away, far_away, 0.0f});
    for (auto& cluster : clusters)
      for (int d = 0; d < D; ++d) std::fill(cluster.x[d], cluster.x[d] + 8, far_away);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const Vec<D> x = (points[order[k]] - points[0]) / reach;
      float* p = &place[k].x;
      for (int d = 0; d < D; ++d) p[d] = clusters[k / 8].x[d][k % 8] = static_cast<float>(x[d]);
    }
    rows.build(clusters);
  }
};

}  // namespace

template <int D>
double relax(std::vector<Vec<D>>& points, const std::vector<std::uint8_t>& fixed, const Relaxation<D>& how) {
  if (points.empty()) return 0.0;
  const double h = how.kernel.h, largest = 0.1 * std::pow(how.volume, 1.0 / D);
  FluidConstants constants;
  constants.reach = static_cast<float>(how.kernel.reach());
  constants.kV = static_cast<float>(10.0 * how.kernel.normalisation() / h * how.volume);
  const auto& kernels = fluid_kernels<D>();
  Cloud<D> cloud;
  std::vector<std::int32_t> order;
  double rms = 0;
  for (int iteration = 0; iteration < how.iterations; ++iteration) {
    if (iteration % 50 == 0) order = bisection_order<D>(points);
    cloud.freeze(points, order, how.kernel.reach());
    const auto n = static_cast<std::int64_t>(cloud.clusters.size());
    std::vector<double> squares(n, 0.0);
#pragma omp parallel for schedule(static)
    for (std::int64_t c = 0; c < n; ++c) {
      kernels.sums(c, c + 1, cloud.clusters.data(), cloud.sums.data(), cloud.rows.data(), cloud.place.data(),
                   constants);
      for (std::size_t k = 8 * c; k < std::min<std::size_t>(8 * c + 8, points.size()); ++k) {
        if (fixed[order[k]]) continue;
        Vec<D>& x = points[order[k]];
        const WallSample<D> outside = how.outside(x);
        if (outside.filling > 0.5 &&
            outside.flux.squaredNorm() > 0.0) {  // it has slipped out: back by a fifth of dp
          x -= 2.0 * largest * outside.flux.normalized();
          continue;
        }
        Vec<D> push = outside.flux;
        for (int d = 0; d < D; ++d) push[d] += cloud.sums[c].gradient[d][k % 8];
        squares[c] += h * h * push.squaredNorm();
        Vec<D> step = -0.4 * h * h * push;
        if (step.norm() > largest) step *= largest / step.norm();
        x += step;
      }
    }
    rms = 0;
    for (const double s : squares) rms += s;
    rms = std::sqrt(rms / static_cast<double>(points.size()));
    if (how.progress) how.progress(iteration);
  }
  return rms;
}

template double relax<2>(std::vector<Vec<2>>&, const std::vector<std::uint8_t>&, const Relaxation<2>&);
template double relax<3>(std::vector<Vec<3>>&, const std::vector<std::uint8_t>&, const Relaxation<3>&);

}  // namespace ostium::sph3d
