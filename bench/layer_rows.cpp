#include "bench/layer_rows.hpp"

#include "sph3d/fluid/instruction_set.hpp"
#include "sph3d/neighbours/order.hpp"

namespace ostium::sph3d {
OSTIUM_DECLARE_PER_ISA(const bench::LayerKernels& layer_table())
static const bench::LayerKernels& chosen() { return OSTIUM_FOR_THIS_PROCESSOR(layer_table()); }
}  // namespace ostium::sph3d

namespace ostium::bench {

using namespace sph3d;

const LayerKernels& layer_kernels() { return chosen(); }

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
  sort(tube_shells<3>(R, spacing, lower - reach, upper + reach,
                      static_cast<int>(std::ceil(length / spacing))));
  set_records();
  find();
  sums_.resize(clusters_.size());
}

void LayerRows::sort(const std::vector<Shell<3>>& shells) {
  std::vector<Vec3> positions;
  for (const auto& shell : shells) positions.push_back(shell.x);
  for (const std::int32_t a : bisection_order<3>(positions)) shells_.push_back(shells[a]);
}

/// Eights of points or boxes, each with a box in the level above, up to one eight.
void LayerRows::set_records() {
  constexpr float nowhere = -2e6f, largest = 1e30f;
  const auto& model = from_.model;
  const double k = 10.0 * model.kernel.normalisation() / model.kernel.h * constants_.spacing;
  Points<3> empty;
  std::fill_n(&empty.x[0][0], 24, nowhere);
  points_.assign((shells_.size() + 7) / 8, empty);
  Boxes<3> none;
  std::fill_n(&none.low[0][0], 24, largest), std::fill_n(&none.high[0][0], 24, -largest);
  for (std::size_t n = points_.size(); levels_.empty() || n > 1;) levels_.emplace_back(n = (n + 7) / 8, none);
  for (std::size_t a = 0; a < shells_.size(); ++a) {
    const Shell<3>& shell = shells_[a];
    const Vec3 x = (shell.x - model.origin) / model.reach();
    auto& record = records_.emplace_back();
    record.kV = static_cast<float>(k * shell.area);
    record.curvature = static_cast<float>(shell.curvature[0] * constants_.spacing);
    for (int d = 0; d < 3; ++d) {
      record.x[d] = points_[a / 8].x[d][a % 8] = float(x[d]), record.n[d] = float(shell.n[d]);
      std::size_t n = a / 8;
      for (auto& level : levels_) {
        float &low = level[n / 8].low[d][n % 8], &high = level[n / 8].high[d][n % 8];
        low = std::min(low, record.x[d]), high = std::max(high, record.x[d]);
        n /= 8;
      }
    }
  }
}

void LayerRows::find() {
  const auto& kernels = fluid_kernels<3>();
  std::vector<std::int32_t> near, next;
  begin_.assign(1, 0);
  for (const std::size_t c : clusters_) {
    near.assign(1, 0);
    for (std::size_t level = levels_.size(); level-- > 0; near.swap(next)) {
      next.resize(8 * near.size());
      next.resize(kernels.boxes_within_reach(from_.work.rows.box(c), levels_[level].data(), near.data(),
                                             static_cast<std::int32_t>(near.size()), next.data()));
    }
    const std::size_t most = begin_.back() + 8 * near.size();
    if (rows_.size() < most) rows_.resize(2 * most);
    begin_.push_back(begin_.back() + kernels.within_reach(from_.fluid.clusters[c], from_.work.rows.box(c),
                                                          points_.data(), near.data(),
                                                          static_cast<std::int32_t>(near.size()),
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
