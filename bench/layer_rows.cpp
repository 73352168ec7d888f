#include "bench/layer_rows.hpp"

#include <cstdlib>
#include <cstring>
#include <numeric>

namespace ostium::sph3d {
namespace baseline {
const bench::LayerKernels& layer_table();
}
namespace avx2 {
const bench::LayerKernels& layer_table();
}
}  // namespace ostium::sph3d

namespace ostium::bench {

using namespace sph3d;

const LayerKernels& layer_kernels() {
  return std::strcmp(fluid_kernels<3>().name, "AVX2 + FMA") == 0 ? avx2::layer_table()
                                                                 : baseline::layer_table();
}

namespace {

constexpr double half_reaches = 2;  // cells per reach

}  // namespace

LayerRows::LayerRows(const Prepared& from, std::vector<std::size_t> clusters, double spacing)
    : from_(from), clusters_(std::move(clusters)) {
  const auto& model = from.model;
  const double reach = model.reach(), R = std::sqrt(model.ducts[0].opening().area / pi);
  double lower = 1e9, upper = -1e9;
  for (const std::size_t c : clusters_)
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const std::size_t i = 8 * c + lane;
      if (from.fluid.filled[i])
        lower = std::min(lower, from.fluid.position[i][2]),
        upper = std::max(upper, from.fluid.position[i][2]);
    }
  for (const std::size_t c : clusters_) {
    auto& s = distance_.emplace_back();
    for (int lane = 0; lane < 8; ++lane)
      s.of[lane] = static_cast<float>(model.half_space.distance(from.work.around[c].filling[lane]));
  }
  const FluidConstants f = constants_of(model);
  constants_ = {.spacing = static_cast<float>(spacing),
                .closest = static_cast<float>(0.25 * model.options.dp),
                .reach = f.reach,
                .density_factor = f.density_factor,
                .limiter = f.limiter,
                .c = f.c};
  const double length = upper - lower + 2 * reach;
  bin(tube_shells<3>(R, spacing, lower - reach, upper + reach,
                     static_cast<int>(std::ceil(length / spacing))));
  set_records(spacing);
  find();
  sums_.resize(clusters_.size());
}

void LayerRows::bin(std::vector<Shell<3>> shells) {
  const double reach = from_.model.reach();
  std::vector<Vec3> local;
  Vec3 lower = Vec3::Constant(1e9), upper = -lower;
  for (const auto& shell : shells) {
    local.push_back((shell.x - from_.model.origin) / reach);
    lower = lower.cwiseMin(local.back()), upper = upper.cwiseMax(local.back());
  }
  for (int d = 0; d < 3; ++d) {
    lower_[d] = static_cast<float>(lower[d]);
    cells_[d] = static_cast<int>(half_reaches * (upper[d] - lower[d])) + 1;
  }
  const auto cell = [&](const Vec3& x) {
    std::size_t n = 0;
    for (int d = 2; d >= 0; --d) n = n * cells_[d] + static_cast<int>(half_reaches * (x[d] - lower[d]));
    return n;
  };
  std::vector<std::size_t> order(shells.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return cell(local[a]) < cell(local[b]); });
  first_.assign(std::size_t(cells_[0]) * cells_[1] * cells_[2] + 1, 0);
  for (const auto& x : local) ++first_[cell(x) + 1];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  for (const std::size_t a : order) shells_.push_back(shells[a]);
  index_.resize(shells_.size());
  std::iota(index_.begin(), index_.end(), 0);
}

void LayerRows::set_records(double spacing) {
  const auto& model = from_.model;
  const double k = 10.0 * model.kernel.normalisation() / model.kernel.h;
  for (const auto& a : shells_) {
    const Vec3 x = (a.x - model.origin) / model.reach();
    ShellRecord record{.kV = static_cast<float>(k * a.area * spacing),
                       .curvature = static_cast<float>(a.curvature[0] * spacing)};
    for (int d = 0; d < 3; ++d) record.x[d] = float(x[d]), record.n[d] = float(a.n[d]);
    records_.push_back(record);
    places_.push_back({record.x[0], record.x[1], record.x[2], record.kV});
  }
}

void LayerRows::find() {
  const auto within_reach = fluid_kernels<3>().within_reach;
  std::vector<Stretch> stretches;
  rows_.resize(clusters_.size() * 64);
  begin_.assign(1, 0);
  for (const std::size_t c : clusters_) {
    const Cluster<3>& own = from_.fluid.clusters[c];
    int low[3], high[3];
    for (int d = 0; d < 3; ++d) {
      float least = 1e6f, most = -1e6f;
      for (int lane = 0; lane < 8; ++lane)
        if (own.x[d][lane] < 1e5f)
          least = std::min(least, own.x[d][lane]), most = std::max(most, own.x[d][lane]);
      low[d] = std::max(0, static_cast<int>(std::floor(half_reaches * (least - 1 - lower_[d]))));
      high[d] = std::min(cells_[d] - 1, static_cast<int>(std::floor(half_reaches * (most + 1 - lower_[d]))));
    }
    stretches.clear();
    std::int32_t candidates = 0;
    for (int z = low[2]; z <= high[2]; ++z)
      for (int y = low[1]; y <= high[1] && low[0] <= high[0]; ++y) {
        const std::size_t row = (std::size_t(z) * cells_[1] + y) * cells_[0];
        const Stretch s{first_[row + low[0]], first_[row + high[0] + 1]};
        if (s.begin < s.end) stretches.push_back(s), candidates += s.end - s.begin;
      }
    if (rows_.size() < std::size_t(begin_.back() + candidates)) rows_.resize(2 * rows_.size() + candidates);
    begin_.push_back(begin_.back() + within_reach(own, places_.data(), index_.data(), stretches.data(),
                                                  static_cast<std::int32_t>(stretches.size()),
                                                  &rows_[begin_.back()]));
  }
  weights_.resize(begin_.back());
}

void LayerRows::sums() {
  const auto& kernels = layer_kernels();
  for (std::size_t k = 0; k < clusters_.size(); ++k)
    kernels.sums(from_.fluid.clusters[clusters_[k]], distance_[k],
                 {&rows_[begin_[k]], begin_[k + 1] - begin_[k]}, records_.data(), constants_, sums_[k],
                 &weights_[begin_[k]]);
}

void LayerRows::impact() {
  const auto& kernels = layer_kernels();
  for (std::size_t k = 0; k < clusters_.size(); ++k)
    kernels.impact(from_.fluid.clusters[clusters_[k]], {&rows_[begin_[k]], begin_[k + 1] - begin_[k]},
                   records_.data(), &weights_[begin_[k]], constants_, sums_[k].gradient);
}

double LayerRows::mean_length() const { return double(begin_.back()) / double(clusters_.size()); }

double LayerRows::error() const {
  const auto& model = from_.model;
  const Layers<3> layers(shells_, constants_.spacing, model.kernel, model.options.dp);
  double error = 0;
  for (std::size_t k = 0; k < clusters_.size(); ++k)
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const std::size_t i = 8 * clusters_[k] + lane;
      if (!from_.fluid.filled[i]) continue;
      const double exact = layers(from_.fluid.position[i], distance_[k].of[lane]).filling;
      error = std::max(error, std::abs(exact - sums_[k].filling[lane]));
    }
  return error;
}

}  // namespace ostium::bench
