#include "sph3d/step/workspace.hpp"

#include <algorithm>
#include <cmath>

#include "core/large_pages.hpp"
#include "sph3d/step/lane_access.hpp"
#include "sph3d/step/shared_loops.hpp"

namespace ostium::sph3d {

namespace {

template <int D>
float kernel_volume(const Model<D>& model) {
  return static_cast<float>(10.0 * model.kernel.normalisation() / model.kernel.h * model.particle_volume);
}

}  // namespace

template <int D>
FluidConstants constants_of(const Model<D>& model) {
  const auto& o = model.options;
  const auto f = [](double x) { return static_cast<float>(x); };
  FluidConstants constants{.c = f(o.sound_speed),
                           .c2 = f(o.sound_speed * o.sound_speed),
                           .reach = f(model.kernel.reach()),
                           .kV = kernel_volume(model),
                           .density_factor = f(model.kernel.h / 10.0),
                           .viscosity = f(o.viscosity),
                           .limiter = f(o.limiter),
                           .damping = f(2.0 * o.viscosity / model.kernel.reach()),
                           .number_density = f(model.number_density),
                           .rest_volume = f(model.rest_volume)};
  for (int d = 0; d < D; ++d) constants.gravity[d] = f(o.gravity[d]);
  return constants;
}

namespace {

/// Corners of a box in local coordinates; an empty one has low above high.
template <int D>
std::pair<Vec<D>, Vec<D>> corners(const Model<D>& model, const Box<D>& box) {
  Vec<D> low, high;
  for (int d = 0; d < D; ++d) low[d] = box.low[d], high[d] = box.high[d];
  return {model.origin + model.reach() * low, model.origin + model.reach() * high};
}

/// Whether anything in this box may come to stand in the zone of a duct during this step.
template <int D>
bool near_duct(const Model<D>& model, const Duct<D>& duct, const Box<D>& box) {
  const auto [low, high] = corners(model, box);
  if (low[0] > high[0]) return false;
  return duct.near(0.5 * (low + high), 0.5 * (high - low).norm() + 3.0 * model.options.dp);
}

template <int D>
bool feels_wall(const Model<D>& model, const Box<D>& box) {
  const auto [low, high] = corners(model, box);
  return low[0] <= high[0] && model.wall.felt_in(low, high);
}

template <int D>
void find_clusters_near_ducts(const Model<D>& model, std::size_t clusters, Workspace<D>& work) {
  work.near_duct.assign(model.ducts.size(), {});
  for (std::size_t k = 0; k < model.ducts.size(); ++k)
    for (std::size_t c = 0; c < clusters; ++c) {
      if (c % 8 == 0 && !near_duct(model, model.ducts[k], work.rows.group_box(c / 8)))
        c += 7;  // none of the eight
      else if (near_duct(model, model.ducts[k], work.rows.box(c)))
        work.near_duct[k].push_back(static_cast<std::int32_t>(c));
    }
}

}  // namespace

template <int D>
void freeze(const Model<D>& model, FluidState<D>& state, Workspace<D>& work) {
  const std::size_t n = state.places();
  const double scale = 1.0 / model.kernel.reach();
  resize_in_large_pages(work.place, n + 1);
  resize_in_large_pages(work.velocity, n + 1);
  resize_in_large_pages(work.matrix, n + 1);
  for_clusters(state.clusters.size(), [&](std::size_t c) {
    Cluster<D>& own = state.clusters[c];
    for (int d = 0; d < D; ++d)
      for (std::size_t lane = 0; lane < 8; ++lane) {
        const auto x = static_cast<float>((state.position[8 * c + lane][d] - model.origin[d]) * scale);
        own.x[d][lane] = state.filled[8 * c + lane] ? x : far_away;
        own.moved[d][lane] = 0;
      }
    for (std::size_t lane = 0; lane < 8; ++lane) {
      PlaceRecord& place = work.place[8 * c + lane];
      VelocityRecord& velocity = work.velocity[8 * c + lane];
      for (int d = 0; d < D; ++d) (&place.x)[d] = own.x[d][lane], (&velocity.x)[d] = own.v[d][lane];
    }
  });
  work.place[n] = {far_away, far_away, far_away, 0};
  work.velocity[n] = {};
  work.matrix[n] = {};
  work.rows.build(state.clusters);
  find_clusters_near_ducts(model, state.clusters.size(), work);
}

template <int D>
void find_zones(const Model<D>& model, const FluidState<D>& state, Workspace<D>& work) {
  const auto before_cap = [](std::size_t k) { return static_cast<std::int8_t>(-2 - static_cast<int>(k)); };
  const auto for_near = [&](std::size_t k, auto&& f) {
    for (const std::int32_t c : work.near_duct[k])
      for (std::size_t i = 8 * c; i < std::size_t(8 * c + 8); ++i)
        if (state.filled[i]) f(i, state.position[i]);
  };
  work.duct_of.assign(state.places(), -1);
  for (std::size_t k = 0; k < model.ducts.size(); ++k)
    for_near(k, [&](std::size_t i, const Vec<D>& x) {
      if (model.ducts[k].holds(x)) work.duct_of[i] = static_cast<std::int8_t>(k);
      if (model.ducts[k].before_cap(x)) work.duct_of[i] = before_cap(k);
    });
  work.zones.resize(model.ducts.size());
  for (std::size_t k = 0; k < model.ducts.size(); ++k) {
    Zone<D>& zone = work.zones[k];
    zone.members.clear();
    zone.before_cap.clear();
    for_near(k, [&](std::size_t i, const Vec<D>& x) {
      const auto index = static_cast<std::int32_t>(i);
      if (work.duct_of[i] == static_cast<int>(k))
        zone.members.push_back({index, static_cast<float>(model.ducts[k].depth(x)), 0.0f});
      else if (work.duct_of[i] == before_cap(k))
        zone.before_cap.push_back(index);
    });
  }
}

template <int D>
WallSample<D> beyond_face(const Model<D>& model, int k, const Vec<D>& x, const WallSample<D>& wall) {
  const double s = model.ducts[k].depth(x);
  if (s >= model.reach()) return {};
  const double beyond = model.half_space.filling(s), left = 1.0 - wall.filling;
  return {beyond * left,
          model.half_space.flux(s) * left * model.ducts[k].opening().normal - beyond * wall.flux};
}

template <int D>
WallSample<D> wall_at(const Model<D>& model, const Workspace<D>& work, std::size_t i, const Vec<D>& x) {
  return work.wall_motion ? work.wall_motion->sample(model.wall, i, x) : model.wall(x);
}

template <int D>
void look_around(const Model<D>& model, FluidState<D>& state, Workspace<D>& work) {
  const HalfSpace<D>& space = model.half_space;
  resize_in_large_pages(work.around, state.clusters.size());
  for_clusters(state.clusters.size(), [&](std::size_t c) {
    ClusterSurroundings<D>& around = work.around[c];
    around = {};
    for (auto& row : state.clusters[c].wall) std::fill_n(row, 8, 0.0f);
    const bool walled = work.wall_motion || feels_wall(model, work.rows.box(c));
    const std::int8_t* duct = &work.duct_of[8 * c];
    if (!walled && std::all_of(duct, duct + 8, [](int k) { return k < 0; })) return;
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const std::size_t i = 8 * c + lane;
      const WallSample<D> wall =
          walled && state.filled[i] ? wall_at(model, work, i, state.position[i]) : WallSample<D>{};
      lane_assign<D>(state.clusters[c].wall, lane, wall.flux);
      if (wall.filling > 0.0) {
        around.filling[lane] = static_cast<float>(wall.filling);
        const auto share = space.share(around.filling[lane]);
        around.moment_n[lane] = share.moment_n;
        around.moment_t[lane] = share.moment_t;
        around.friction_n[lane] = share.friction_n;
        around.friction_t[lane] = share.friction_t;
      }
      if (const int k = work.duct_of[i]; k >= 0) {
        const WallSample<D> open = beyond_face(model, k, state.position[i], wall);
        around.open_filling[lane] = static_cast<float>(open.filling);
        lane_assign<D>(around.open_flux, lane, open.flux);
      }
    }
  });
}

template <int D>
void kernel_sums(const Model<D>& model, FluidState<D>& state, Workspace<D>& work) {
  const auto& kernels = fluid_kernels<D>();
  const FluidConstants constants = constants_of(model);
  resize_in_large_pages(work.sums, state.clusters.size());
  for_batches(state.clusters.size(), [&](std::size_t begin, std::size_t end) {
    kernels.sums(begin, end, state.clusters.data(), work.sums.data(), work.rows.data(), work.place.data(),
                 constants);
  });
}

#define OSTIUM_INSTANTIATE(D)                                                                       \
  template FluidConstants constants_of(const Model<D>&);                                            \
  template void freeze(const Model<D>&, FluidState<D>&, Workspace<D>&);                             \
  template void find_zones(const Model<D>&, const FluidState<D>&, Workspace<D>&);                   \
  template WallSample<D> beyond_face(const Model<D>&, int, const Vec<D>&, const WallSample<D>&);    \
  template WallSample<D> wall_at(const Model<D>&, const Workspace<D>&, std::size_t, const Vec<D>&); \
  template void look_around(const Model<D>&, FluidState<D>&, Workspace<D>&);                        \
  template void kernel_sums(const Model<D>&, FluidState<D>&, Workspace<D>&);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
