#include "sph3d/walls/deformable_wall.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sph3d/step/lane_access.hpp"

namespace ostium::sph3d {

namespace {

/// What the tissue around the wall allows: its springs' period and its dashpots' decay.
template <int D>
double longest_step_of_support(const ShellModel<D>& model) {
  const ShellOptions& o = model.options;
  double longest = 1e300;
  for (const double t : model.cloud.thickness) {
    const double mass = o.density * t;
    if (o.spring > 0) longest = std::min(longest, 2.0 * std::sqrt(mass / o.spring));
    if (o.dashpot > 0) longest = std::min(longest, mass / o.dashpot);
  }
  return o.cfl * longest;
}

}  // namespace

template <int D>
DeformableWall<D>::DeformableWall(ShellModel<D> shell, std::vector<Vec<D>> contact, double reach,
                                  const SurroundingsOfWall& around)
    : model_(std::move(shell)),
      around_(around),
      longest_step_(std::min(stable_step(model_), longest_step_of_support(model_))),
      motion_(contact, model_.cloud.normal, model_.options.spacing, reach),
      work_(model_),
      load_(no_load(model_)),
      force_(model_.count(), Vec<D>::Zero()) {
  const ShellCloud<D>& cloud = model_.cloud;
  OSTIUM_ASSERT(contact.size() == cloud.count(), "{} contact points, {} shell particles", contact.size(),
                cloud.count());
  for (std::size_t a = 0; a < contact.size(); ++a)
    depth_.push_back((cloud.position[a] - contact[a]).dot(cloud.normal[a]));
}

template <int D>
DeformableWallState<D> DeformableWall<D>::rest(double pressure) const {
  const std::vector<Vec<D>> none(model_.count(), Vec<D>::Zero());
  return {sph3d::rest(model_), none, none, pressure - around_.rest_pressure};
}

template <int D>
std::vector<Vec<D>> DeformableWall<D>::normals(const ShellState<D>& shell) const {
  std::vector<Vec<D>> n(model_.count());
  for (std::size_t a = 0; a < n.size(); ++a) n[a] = shell.normal(a);
  return n;
}

template <int D>
std::vector<Vec<D>> DeformableWall<D>::contacts(const ShellState<D>& shell) const {
  std::vector<Vec<D>> x(model_.count());
  for (std::size_t a = 0; a < x.size(); ++a)
    x[a] = model_.cloud.position[a] + shell.displacement(a) - depth_[a] * shell.normal(a);
  return x;
}

template <int D>
void DeformableWall<D>::attach(const DeformableWallState<D>& state, const FluidState<D>& fluid) {
  motion_.attach(fluid, contacts(state.shell), normals(state.shell));
  motion_.set_velocities(state.velocity);
  on_wall_.assign(fluid.places(), Vec<D>::Zero());
  impact_.assign(fluid.places(), Vec<D>::Zero());
}

namespace {

/// f(cluster, lane, place) for every place that feels the wall's motion.
template <int D, class F>
void for_attached(const FluidState<D>& fluid, const WallMotion<D>& motion, F&& f) {
  for_clusters(fluid.clusters.size(), [&](std::size_t c) {
    for (std::size_t lane = 0; lane < 8; ++lane)
      if (motion.attached(8 * c + lane)) f(c, lane, 8 * c + lane);
  });
}

}  // namespace

template <int D>
void DeformableWall<D>::after_kick(const Model<D>& model, const FluidState<D>& fluid) {
  const double mass = model.options.density * fluid.volume, c = model.options.sound_speed;
  for_attached(fluid, motion_, [&](std::size_t cluster, std::size_t lane, std::size_t i) {
    const Cluster<D>& own = fluid.clusters[cluster];
    const Vec<D> slip = lane_vector<D>(own.v, lane) - lane_vector<D>(motion_.velocity()[cluster].v, lane);
    on_wall_[i] = impact_[i] + mass * (2.0 * c * c * own.psi[lane] *
                                           (lane_matrix<D>(own.B, lane) * lane_vector<D>(own.wall, lane)) +
                                       double(own.friction[lane]) * slip);
  });
}

template <int D>
void DeformableWall<D>::after_density(const Model<D>& model, const FluidState<D>& fluid) {
  const double mass = model.options.density * fluid.volume, c = model.options.sound_speed;
  for_attached(fluid, motion_, [&](std::size_t cluster, std::size_t lane, std::size_t i) {
    const Cluster<D>& own = fluid.clusters[cluster];
    const Vec<D> wall = lane_vector<D>(own.wall, lane),
                 slip = lane_vector<D>(own.v, lane) - lane_vector<D>(motion_.velocity()[cluster].v, lane);
    const double impact = 2.0 * std::max(0.0, slip.dot(wall)) / (wall.norm() + 1e-12);
    impact_[i] = mass * impact * std::min(model.options.limiter * impact, c) * wall;
  });
}

template <int D>
void DeformableWall<D>::step(DeformableWallState<D>& state, double dt, double reference_pressure) {
  motion_.gather(force_, [&](std::size_t i) { return on_wall_[i]; });
  const double t = around_.ramp > 0.0 ? std::min(state.shell.time / around_.ramp, 1.0) : 1.0;
  const double withheld = 0.5 * (1.0 + std::cos(pi * t)) * state.withheld;
  for (std::size_t a = 0; a < model_.count(); ++a) {
    force_[a] += state.impact[a];
    state.impact[a].setZero();
    for (int d = 0; d < D; ++d) load_[a / 8].force[d][a % 8] = force_[a][d];
    load_[a / 8].pressure[a % 8] = reference_pressure - around_.outside_pressure - withheld;
  }
  const std::vector<Vec<D>> before = contacts(state.shell);
  const double stable = std::min(longest_step_, stable_step(model_, state.shell, work_));
  const int count = std::max(1, static_cast<int>(std::ceil(dt / stable)));
  advance(model_, state.shell, load_, work_, {.dt = dt / count, .count = count});
  const std::vector<Vec<D>> after = contacts(state.shell);
  for (std::size_t a = 0; a < after.size(); ++a) state.velocity[a] = (after[a] - before[a]) / dt;
  motion_.set_velocities(state.velocity);
  motion_.drift(dt);
}

template <int D>
void DeformableWall<D>::detach(DeformableWallState<D>& state) const {
  motion_.gather(state.impact, [&](std::size_t i) { return impact_[i]; });
}

template class DeformableWall<2>;
template class DeformableWall<3>;

}  // namespace ostium::sph3d
