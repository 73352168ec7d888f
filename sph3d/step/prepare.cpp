#include "sph3d/step/prepare.hpp"

#include <algorithm>

#include "sph3d/step/lane_access.hpp"
#include "sph3d/step/shared_loops.hpp"

namespace ostium::sph3d {

namespace {

/// Where part of the support lies beyond an outer face, its moments complete those of the particles there.
template <int D>
void complete_moments(const Model<D>& model, const FluidState<D>& fluid, Workspace<D>& work) {
  for (std::size_t k = 0; k < work.zones.size(); ++k) {
    const Vec<D>& n = model.ducts[k].opening().normal;
    for (const auto& member : work.zones[k].members) {
      const std::size_t c = member.index / 8, lane = member.index % 8;
      if (!(work.around[c].open_filling[lane] > 0.0f)) continue;
      const double s = model.ducts[k].depth(fluid.position[member.index]);
      const double across = model.half_space.moment_t(s), along = model.half_space.moment_n(s) - across;
      const Mat<D> outside = along * n * n.transpose() + across * Mat<D>::Identity();
      const double left =
          model.density_ratio(fluid.clusters[c].psi[lane]) * (1.0 - work.around[c].filling[lane]);
      for (int a = 0, m = 0; a < D; ++a)
        for (int b = a; b < D; ++b, ++m)
          work.sums[c].moment[m][lane] += static_cast<float>(left * outside(a, b));
    }
  }
}

/// Conveyors carry what they are given, and the fluid near an outer face takes its pressure: no correction of density, nothing
/// completed along the wall.
template <int D>
void spare_ducts(const Model<D>& model, FluidState<D>& fluid, const Workspace<D>& work) {
  for (std::size_t k = 0; k < work.zones.size(); ++k)
    for (const auto& member : work.zones[k].members)
      if (model.roles[k].flow_driven || member.depth < model.reach()) {
        auto& cluster = fluid.clusters[member.index / 8];
        cluster.source[member.index % 8] = cluster.along[member.index % 8] = 0.0f;
      }
}

}  // namespace

template <int D>
void correct(const Model<D>& model, FluidState<D>& fluid, Workspace<D>& work, double dt, double acoustic_dt) {
  complete_moments(model, fluid, work);
  FluidConstants constants = constants_of(model);
  constants.correction = static_cast<float>(model.options.density_relaxation / dt);
  constants.number_density = static_cast<float>(model.number_density * (1.0 + fluid.disorder));
  for_batches(fluid.clusters.size(), [&](std::size_t begin, std::size_t end) {
    fluid_kernels<D>().corrections(begin, end, fluid.clusters.data(), work.sums.data(), work.around.data(),
                                   work.matrix.data(), work.place.data(), constants,
                                   static_cast<float>(acoustic_dt));
  });
  spare_ducts(model, fluid, work);
}

namespace {

/// The shape of the profile at each particle, divided by its mean over the duct in a smooth window: Q = sum V v_n w / int w.
template <int D>
void prepare_profile(const Model<D>& model, const FluidState<D>& fluid, Zone<D>& zone, std::size_t k) {
  const Duct<D>& duct = model.ducts[k];
  double carried = 0;
  for (auto& member : zone.members) {
    member.drive = static_cast<float>(model.shapes[k](fluid.position[member.index]));
    const double u = member.depth / duct.length();
    if (u > 0.0 && u < 1.0) carried += member.drive * (1.0 - std::cos(2.0 * pi * u));
  }
  const double mean = carried * fluid.volume / (duct.length() * duct.opening().area);
  if (mean < 0.5) return;  // hardly a particle there
  for (auto& member : zone.members) member.drive /= static_cast<float>(mean);
}

template <int D>
void prepare_zones(const Model<D>& model, const FluidState<D>& fluid, Workspace<D>& work) {
  for (std::size_t k = 0; k < work.zones.size(); ++k) {
    const Vec<D>& normal = model.ducts[k].opening().normal;
    if (model.roles[k].flow_driven) prepare_profile(model, fluid, work.zones[k], k);
    for (auto& member : work.zones[k].members) {
      const std::size_t c = member.index / 8, lane = member.index % 8;
      Vec<D> imbalance = lane_vector<D>(work.sums[c].imbalance, lane);
      if (!model.roles[k].flow_driven && member.depth < model.reach())
        member.drive = static_cast<float>(-imbalance.dot(normal));
      // along the duct the layers arrive in phase with the flow, not with the outer face: no shift that way
      // near it
      const double free = model.roles[k].flow_driven
                              ? 0.0
                              : std::clamp((member.depth - model.reach()) / model.options.dp, 0.0, 1.0);
      imbalance +=
          2.0 * lane_matrix<D>(fluid.clusters[c].B, lane) * lane_vector<D>(work.around[c].open_flux, lane);
      imbalance -= (1.0 - free) * imbalance.dot(normal) * normal;
      lane_assign<D>(work.sums[c].imbalance, lane, imbalance);
    }
  }
}

}  // namespace

template <int D>
void prepare_forces(const Model<D>& model, FluidState<D>& fluid, Workspace<D>& work) {
  const FluidConstants constants = constants_of(model);
  for_batches(fluid.clusters.size(), [&](std::size_t begin, std::size_t end) {
    fluid_kernels<D>().corrected_sums(begin, end, fluid.clusters.data(), work.sums.data(), work.rows.data(),
                                      work.place.data(), work.velocity.data(), work.matrix.data(), constants);
  });
  prepare_zones(model, fluid, work);
}

template <int D>
void prepare_step(const Model<D>& model, FluidState<D>& fluid, Workspace<D>& work, double dt,
                  double acoustic_dt, PhaseSeconds& seconds) {
  {
    const Stopwatch watch(seconds.advection);
    freeze(model, fluid, work);
    find_zones(model, fluid, work);
  }
  {
    const Stopwatch watch(seconds.walls);
    look_around(model, fluid, work);
  }
  const Stopwatch watch(seconds.advection);
  kernel_sums(model, fluid, work);
  correct(model, fluid, work, dt, acoustic_dt);
  prepare_forces(model, fluid, work);
}

#define OSTIUM_INSTANTIATE(D)                                                            \
  template void correct(const Model<D>&, FluidState<D>&, Workspace<D>&, double, double); \
  template void prepare_forces(const Model<D>&, FluidState<D>&, Workspace<D>&);          \
  template void prepare_step(const Model<D>&, FluidState<D>&, Workspace<D>&, double, double, PhaseSeconds&);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
