#include "sph3d/step/disorder.hpp"

#include <cmath>
#include <numeric>

#include "sph3d/step/shared_loops.hpp"

namespace ostium::sph3d {
namespace {

/// In spacings: what particles travel until rows along the walls have found their places.
constexpr double settling_path = 20;

}  // namespace

template <int D>
double mean_sum(const Model<D>& model, const FluidState<D>& fluid, const Workspace<D>& work,
                double otherwise) {
  std::vector<double> sum((fluid.clusters.size() + batch - 1) / batch);
  std::vector<int> count(sum.size());
  for_batches(fluid.clusters.size(), [&](std::size_t begin, std::size_t end) {
    double in_lane[8] = {};  // without a branch, so that eight are added at a time
    int counted[8] = {};
    for (std::size_t c = begin; c < end; ++c) {
      const auto &sums = work.sums[c].density, &filling = work.around[c].filling,
                 &psi = fluid.clusters[c].psi;
      for (std::size_t lane = 0; lane < 8; ++lane) {
        const bool counts = fluid.filled[8 * c + lane] && work.duct_of[8 * c + lane] < 0;
        const double own = sums[lane] + model.density_ratio(psi[lane]) * filling[lane];
        in_lane[lane] += counts ? own : 0.0;
        counted[lane] += counts;
      }
    }
    sum[begin / batch] = std::accumulate(in_lane, in_lane + 8, 0.0);
    count[begin / batch] = std::accumulate(counted, counted + 8, 0);
  });
  const int particles = std::accumulate(count.begin(), count.end(), 0);
  return particles > 0 ? std::accumulate(sum.begin(), sum.end(), 0.0) / particles : otherwise;
}

template <int D>
double undisturbed_sum(const Model<D>& model, FluidState<D>& fluid, Workspace<D>& work, double psi) {
  freeze(model, fluid, work);
  find_zones(model, fluid, work);
  look_around(model, fluid, work);
  kernel_sums(model, fluid, work);
  return mean_sum(model, fluid, work, model.number_density * (1.0 + psi)) / (1.0 + psi);
}

template <int D>
double content(const VesselState<D>& state) {
  double volume = static_cast<double>(state.fluid.count()) * state.fluid.volume;
  for (const auto& port : state.ports) volume -= port.counted - port.deleted + port.inserted;
  return volume;
}

template <int D>
void follow_content(const Model<D>& model, VesselState<D>& state, const Workspace<D>& work, double dt) {
  if (!(state.reference_content > 0.0)) return;
  const double inside = content(state), counted = inside / state.reference_content;
  const double sigma = model.number_density * (1.0 + state.fluid.disorder);
  const double summed = mean_sum(model, state.fluid, work, sigma * counted) / sigma;
  const double share = -std::expm1(-dt / model.settling_time);
  if (state.travelled < settling_path * model.options.dp)
    state.reference_content += share * (inside / summed - state.reference_content);
  else
    state.fluid.disorder += share * (summed - counted);
}

#define OSTIUM_INSTANTIATE(D)                                                                   \
  template double mean_sum(const Model<D>&, const FluidState<D>&, const Workspace<D>&, double); \
  template double undisturbed_sum(const Model<D>&, FluidState<D>&, Workspace<D>&, double);      \
  template double content(const VesselState<D>&);                                               \
  template void follow_content(const Model<D>&, VesselState<D>&, const Workspace<D>&, double);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
