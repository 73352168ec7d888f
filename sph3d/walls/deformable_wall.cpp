#include "sph3d/walls/deformable_wall.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sph3d/step/lane_access.hpp"
#include "sph3d/step/shared_loops.hpp"

namespace ostium::sph3d {

namespace {

/// f(body, its part of the state).
template <class Body, class State, class F>
decltype(auto) on_body(Body& body, State& state, F&& f) {
  return std::visit([&](auto& one) -> decltype(auto) { return f(one, state.*one.state); }, body);
}

}  // namespace

template <int D>
DeformableWall<D>::DeformableWall(WallBody<D> body, double reach, const SurroundingsOfWall& around)
    : body_(std::move(body)),
      around_(around),
      motion_(std::visit(
          [&](const auto& b) {
            return WallMotion<D>(b.reference(), b.reference_normals(), b.spacing(), reach);
          },
          body_)),
      force_(std::visit([](const auto& b) { return b.count(); }, body_), Vec<D>::Zero()) {}

template <int D>
DeformableWallState<D> DeformableWall<D>::rest(double pressure) const {
  const std::vector<Vec<D>> none(count(), Vec<D>::Zero());
  DeformableWallState<D> state{
      .velocity = none, .impact = none, .withheld = pressure - around_.rest_pressure};
  on_body(body_, state, [](const auto& body, auto& own) { own = body.at_rest(); });
  return state;
}

template <int D>
void DeformableWall<D>::check(const DeformableWallState<D>& state) const {
  OSTIUM_ASSERT(state.velocity.size() == count(), "a state of {} wall points for {}", state.velocity.size(),
                count());
  OSTIUM_ASSERT(state.shell.blocks.empty() == std::holds_alternative<SolidBody<D>>(body_),
                "the state of a {} for another kind of wall", state.shell.blocks.empty() ? "solid" : "shell");
}

template <int D>
std::vector<WallPoint<D>> DeformableWall<D>::points_at_rest() const {
  return std::visit([](const auto& body) { return body.points(body.at_rest()); }, body_);
}

template <int D>
std::vector<WallPoint<D>> DeformableWall<D>::points(const DeformableWallState<D>& state) const {
  return on_body(body_, state, [](const auto& body, const auto& own) { return body.points(own); });
}

template <int D>
void DeformableWall<D>::attach(const DeformableWallState<D>& state, const FluidState<D>& fluid) {
  on_body(body_, state, [&](const auto& body, const auto& own) {
    motion_.attach(fluid, body.contacts(own), body.normals(own));
  });
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
    const Vec<D> wall = lane_vector<D>(own.wall, lane), n = wall.normalized();
    const double push = n.dot(lane_matrix<D>(own.B, lane) * wall);
    on_wall_[i] =
        impact_[i] + mass * (2.0 * c * c * own.psi[lane] * push * n + double(own.friction[lane]) * slip);
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

/// Of the load at the start, what has not come yet.
template <int D>
double DeformableWall<D>::withheld(const DeformableWallState<D>& state, double time) const {
  const double t = around_.ramp > 0.0 ? std::min(time / around_.ramp, 1.0) : 1.0;
  return 0.5 * (1.0 + std::cos(pi * t)) * state.withheld;
}

template <int D>
void DeformableWall<D>::step(DeformableWallState<D>& state, double dt, double reference_pressure) {
  motion_.gather(force_, [&](std::size_t i) { return on_wall_[i]; });
  for (std::size_t a = 0; a < count(); ++a) {
    force_[a] += state.impact[a];
    state.impact[a].setZero();
  }
  on_body(body_, state, [&](auto& body, auto& own) {
    const std::vector<Vec<D>> before = body.contacts(own);
    const double pressure = reference_pressure - around_.outside_pressure - withheld(state, own.time);
    body.step(own, dt, force_, pressure);
    const std::vector<Vec<D>> after = body.contacts(own);
    for (std::size_t a = 0; a < after.size(); ++a) state.velocity[a] = (after[a] - before[a]) / dt;
  });
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
