#include "sph3d/vessel.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/large_pages.hpp"
#include "sph3d/openings/ports.hpp"
#include "sph3d/openings/renewal.hpp"
#include "sph3d/particles/fill.hpp"
#include "sph3d/step/disorder.hpp"
#include "sph3d/step/lane_access.hpp"
#include "sph3d/step/prepare.hpp"
#include "sph3d/step/shared_loops.hpp"

namespace ostium::sph3d {

template <int D>
Vessel<D>::Vessel(const Lumen<D>& lumen, const FluidOptions<D>& options, std::vector<OpeningRole> roles,
                  double pressure, const std::function<void(double)>& progress) {
  auto model = std::make_unique<Model<D>>(lumen, options, std::move(roles));
  state_.fluid = fill(*model, {.progress = progress});
  const double psi = pressure / (options.density * options.sound_speed * options.sound_speed);
  model->rest_volume = 1.0 / (1.0 + psi);
  for (std::size_t i = 0; i < state_.fluid.places(); ++i)
    if (state_.fluid.filled[i]) state_.fluid.psi(i) = static_cast<float>(psi);
  model->number_density = undisturbed_sum(*model, state_.fluid, work_, psi);
  model_ = std::move(model);
  state_.ports.resize(lumen.openings.size());
  for (auto& port : state_.ports) port.pressure = port.face_pressure = pressure;
  find_zones(*model_, state_.fluid, work_);
  count_ports(*model_, state_, work_);
  for (auto& port : state_.ports) port.counted_at_start = port.counted;
  state_.reference_content = content() * model_->rest_volume;
}

template <int D>
Vessel<D>::Vessel(const Lumen<D>& lumen, const FluidOptions<D>& options, std::vector<OpeningRole> roles,
                  SavedVessel<D> saved)
    : state_(std::move(saved.state)) {
  if (state_.ports.size() != lumen.openings.size())
    user_error("the saved state has {} openings, this vessel {}: it belongs to another case",
               state_.ports.size(), lumen.openings.size());
  move_to_large_pages(state_.fluid.position);
  move_to_large_pages(state_.fluid.clusters);
  auto model = std::make_unique<Model<D>>(lumen, options, std::move(roles));
  model->number_density = saved.number_density;
  model->rest_volume = saved.rest_volume;
  model_ = std::move(model);
}

template <int D>
void Vessel<D>::set_wall(std::unique_ptr<DeformableWall<D>> wall) {
  wall_ = std::move(wall);
  if (state_.wall.empty()) state_.wall = wall_->rest(state_.ports.front().pressure);
  wall_->check(state_.wall);
  work_.wall_motion = &wall_->motion();
}

template <int D>
void Vessel<D>::start_datum(const PressureDatum& datum) {
  state_.datum = datum;
  for (auto& port : state_.ports) {
    port.cap_pressure = port.face_pressure + datum.reference;
    port.pressure = port.cap_pressure;
  }
  if (wall_) state_.wall = wall_->rest(state_.ports.front().pressure);
}

template <int D>
StepReport Vessel<D>::advance(double dt_limit, std::span<const Drive> drives, double filter_time) {
  PhaseSeconds seconds;
  const auto [dt, bound] = time_step(dt_limit);
  const int n = std::max(1, static_cast<int>(std::ceil(dt / acoustic_time_step() - 1e-6)));
  prepare(dt, dt / n, seconds);
  for (int k = 1; k <= n; ++k) acoustic_step(dt / n, k == n, drives, filter_time, seconds);
  StepReport done;
  {
    const Stopwatch watch(seconds.advection);
    done = move();
  }
  {
    const Stopwatch watch(seconds.renewal);
    renew_ports(*model_, state_, work_);
  }
  ++state_.steps;
  state_.acoustic_steps += n;
  state_.travelled += state_.max_speed * dt;
  done.dt = dt;
  done.acoustic_steps = n;
  done.particles = state_.fluid.count();
  done.bound = bound;
  done.seconds = seconds;
  return done;
}

/// What is done once per advection step, with the positions it starts from.
template <int D>
void Vessel<D>::prepare(double dt, double acoustic_dt, PhaseSeconds& seconds) {
  if (state_.steps % model_->options.reorder_every == 0) {
    const Stopwatch watch(seconds.advection);
    state_.fluid.reorder(work_.spare);
  }
  if (wall_) {
    const Stopwatch watch(seconds.walls);
    wall_->attach(state_.wall, state_.fluid);
  }
  prepare_step(*model_, state_.fluid, work_, dt, acoustic_dt, seconds);
  if (!wall_) {
    const Stopwatch watch(seconds.advection);
    follow_content(*model_, state_, work_, dt);
  }
}

template <int D>
double Vessel<D>::acoustic_time_step() const {
  return model_->options.acoustic_cfl * model_->kernel.h / (model_->options.sound_speed + state_.max_speed);
}

/// Shortly before the limit the rest is divided evenly, so that no sliver of a step is left.
template <int D>
std::pair<double, StepBound> Vessel<D>::time_step(double dt_limit) const {
  using enum StepBound;
  const auto& o = model_->options;
  const double h = model_->kernel.h;
  const auto [fastest, bound] =
      std::max({std::pair(o.reference_speed, reference), std::pair(state_.max_speed, speed),
                std::pair(std::sqrt(4.0 * h * state_.max_acceleration), acceleration),
                std::pair(o.viscosity / h, viscosity)},
               [](const auto& a, const auto& b) { return a.first < b.first; });
  const double advection = o.advection_cfl * h / fastest, most = o.most_acoustic_steps * acoustic_time_step();
  const double dt = std::min(advection, most);
  if (dt_limit < 2.0 * dt) return {dt_limit / std::max(1.0, std::ceil(dt_limit / dt - 1e-9)), stop};
  return {dt, most < advection ? acoustic : bound};
}

template <int D>
void Vessel<D>::acoustic_step(double dt, bool last, std::span<const Drive> drives, double filter_time,
                              PhaseSeconds& seconds) {
  const auto& kernels = fluid_kernels<D>();
  const FluidConstants constants = constants_of(*model_);
  auto& clusters = state_.fluid.clusters;
  const WallVelocity<D>* wall_velocity = wall_ ? wall_->motion().velocity() : nullptr;
  {
    const Stopwatch watch(seconds.acoustic);
    for_batches(clusters.size(), [&](std::size_t begin, std::size_t end) {
      kernels.kick(begin, end, clusters.data(), work_.rows.data(), work_.place.data(), work_.velocity.data(),
                   wall_velocity, constants, static_cast<float>(dt));
    });
  }
  {
    const Stopwatch watch(seconds.driving);
    drive_ports(*model_, state_, work_, drives, dt, filter_time);
  }
  if (wall_) {  // under the pressure of this kick, and the density feels how it moves: nobody answers late
    const Stopwatch watch(seconds.walls);
    wall_->after_kick(*model_, state_.fluid);
    wall_->step(state_.wall, dt, state_.datum.reference);
  }
  {
    const Stopwatch watch(seconds.acoustic);
    for_batches(clusters.size(), [&](std::size_t begin, std::size_t end) {
      kernels.density(begin, end, clusters.data(), work_.rows.data(), work_.place.data(),
                      work_.velocity.data(), wall_velocity, constants, static_cast<float>(dt),
                      last ? 0.5f : 1.0f);
    });
  }
  if (wall_) {
    const Stopwatch watch(seconds.walls);
    wall_->after_density(*model_, state_.fluid);
    if (last) wall_->detach(state_.wall);
  }
  state_.time += dt;
}

namespace {

/// Beyond this filling a particle has gone through the wall, more than half a spacing deep.
constexpr double through = 0.8;

/// Positions take the displacement of the acoustic steps and the transport shift; who has slipped into the wall is put
/// back, who has gone through it returns to where it was and is told of. Returns how many slipped.
template <int D>
int move_cluster(const Model<D>& model, FluidState<D>& fluid, const Workspace<D>& work, std::size_t c,
                 std::vector<std::size_t>& gone) {
  const auto zeta_h2 = static_cast<float>(model.options.shift * model.kernel.h * model.kernel.h);
  const Cluster<D>& own = fluid.clusters[c];
  float way[D][8], expected[8];
  std::copy_n(work.around[c].filling, 8, expected);
  for (int d = 0; d < D; ++d)
    for (std::size_t lane = 0; lane < 8; ++lane) {
      way[d][lane] = own.moved[d][lane] - zeta_h2 * work.sums[c].imbalance[d][lane];
      expected[lane] += way[d][lane] * own.wall[d][lane];
    }
  const WallMotion<D>* motion = work.wall_motion;
  int mirrored = 0;
  for (std::size_t lane = 0; lane < 8; ++lane) {
    if (!fluid.filled[8 * c + lane]) continue;
    Vec<D>& position = fluid.position[8 * c + lane];
    const Vec<D> before = position;
    for (int d = 0; d < D; ++d) position[d] += way[d][lane];
    const Vec<D> with_wall = motion ? motion->moved(8 * c + lane) : Vec<D>(Vec<D>::Zero());
    if (expected[lane] - with_wall.dot(lane_vector<D>(own.wall, lane)) < 0.4) continue;
    const Vec<D> where = position - with_wall;
    const WallSample<D> wall = wall_at(model, work, 8 * c + lane, where);
    if (wall.filling < 0.52 || model.distance(where).phi < 0.0) continue;  // corners fill more than a half
    if (wall.filling > through) {
      gone.push_back(8 * c + lane);
      position = before;
      fluid.velocity(8 * c + lane, Vec<D>::Zero());
      continue;
    }
    const double inside = 0.25 * model.options.dp - model.half_space.distance(wall.filling);
    if (wall.flux.norm() > 0.0) position -= inside * wall.flux.normalized();
    ++mirrored;
  }
  return mirrored;
}

/// Largest values outside the ducts, squared where that is cheaper, and the sum of all v^2.
struct Motion {
  float speed2 = 0, acceleration2 = 0, psi = 0;
  double sum_speed2 = 0;
  bool finite = true;
};

template <int D>
Motion motion_of(const Cluster<D>& own, const std::uint8_t* filled, const std::int8_t* duct_of) {
  Motion motion;
  float speed2[8] = {};
  for (int d = 0; d < D; ++d)
    for (int lane = 0; lane < 8; ++lane) speed2[lane] += own.v[d][lane] * own.v[d][lane];
  for (int lane = 0; lane < 8; ++lane) {
    if (!filled[lane]) continue;
    motion.sum_speed2 += speed2[lane];
    motion.finite = motion.finite && std::isfinite(speed2[lane] + own.psi[lane]);
    if (duct_of[lane] >= 0) continue;
    motion.speed2 = std::max(motion.speed2, speed2[lane]);
    motion.acceleration2 = std::max(motion.acceleration2, own.acceleration[lane]);
    motion.psi = std::max(motion.psi, std::abs(own.psi[lane]));
  }
  return motion;
}

}  // namespace

/// Moves the particles; largest values are those outside the ducts.
template <int D>
StepReport Vessel<D>::move() {
  auto& fluid = state_.fluid;
  OSTIUM_ASSERT(work_.duct_of.size() == fluid.places(), "{} of {} places", work_.duct_of.size(),
                fluid.places());
  const double mass = model_->options.density * fluid.volume;
  float speed2 = 0, acceleration2 = 0, worst = 0;
  std::vector<double> energy(fluid.clusters.size());
  std::int64_t mirrored = 0;
  bool finite = true;
  std::vector<std::size_t> gone;
#pragma omp parallel for schedule(static) reduction(max : speed2, acceleration2, worst) \
    reduction(+ : mirrored) reduction(&& : finite)
  for (std::size_t c = 0; c < fluid.clusters.size(); ++c) {
    std::vector<std::size_t> of_cluster;
    mirrored += move_cluster(*model_, fluid, work_, c, of_cluster);
    if (!of_cluster.empty()) {
#pragma omp critical
      gone.insert(gone.end(), of_cluster.begin(), of_cluster.end());
    }
    const Motion motion = motion_of<D>(fluid.clusters[c], &fluid.filled[8 * c], &work_.duct_of[8 * c]);
    energy[c] = 0.5 * mass * motion.sum_speed2;
    finite = finite && motion.finite;
    speed2 = std::max(speed2, motion.speed2);
    acceleration2 = std::max(acceleration2, motion.acceleration2);
    worst = std::max(worst, motion.psi);
  }
  if (!finite)
    numerics_error("the flow has blown up: a particle has no finite velocity at t = {:.6g} s", state_.time);
  if (worst > 0.5)
    numerics_error(
        "the flow has blown up: density is {:.0f} % away from that of blood at t = {:.6g} s, the largest "
        "velocity is {:.3g} "
        "m/s at a sound speed of {:.3g} m/s",
        100 * worst, state_.time, std::sqrt(double(speed2)), model_->options.sound_speed);
  state_.mirrored += mirrored;
  stop_leak(gone);
  state_.max_speed = std::sqrt(double(speed2));
  state_.max_acceleration = std::sqrt(double(acceleration2));
  StepReport report{.max_speed = state_.max_speed,
                    .kinetic_energy = std::accumulate(energy.begin(), energy.end(), 0.0),
                    .max_density_error = worst};
  if (!gone.empty()) {
    const Vec<D>& x = fluid.position[*std::min_element(gone.begin(), gone.end())];
    std::copy_n(x.data(), D, report.leak.begin());
    report.leaked = static_cast<std::int64_t>(gone.size());
  }
  return report;
}

/// Single particles are put back and counted; many are a hole.
template <int D>
void Vessel<D>::stop_leak(const std::vector<std::size_t>& gone) {
  constexpr double most = 1e-3;  // of the particles, in the whole run
  state_.escaped += static_cast<std::int64_t>(gone.size());
  if (static_cast<double>(state_.escaped) <= std::max(10.0, most * static_cast<double>(state_.fluid.count())))
    return;
  const Vec<D>& x = state_.fluid.position[*std::min_element(gone.begin(), gone.end())];
  numerics_error("blood leaks through the wall: {} particles so far, the last at {} m at t = {:.6g} s",
                 state_.escaped, fmt::join(x.data(), x.data() + D, ", "), state_.time);
}

template <int D>
double Vessel<D>::content() const {
  return sph3d::content(state_);
}

template <int D>
double Vessel<D>::storage() const {
  const auto& o = model_->options;
  return static_cast<double>(state_.fluid.count()) * state_.fluid.volume /
         (o.density * o.sound_speed * o.sound_speed);
}

template <int D>
std::size_t Vessel<D>::bytes() const {
  const std::size_t places = state_.fluid.places();
  const std::size_t state = sizeof(Vec<D>) + 1 + sizeof(Cluster<D>) / 8;  // twice, for ordering
  const std::size_t per_place = 2 * state + (sizeof(ClusterSums<D>) + sizeof(ClusterSurroundings<D>)) / 8 +
                                sizeof(PlaceRecord) + sizeof(VelocityRecord) + sizeof(MatrixRecord) + 1;
  return places * per_place + work_.rows.bytes() + model_->wall.bytes();
}

template class Vessel<2>;
template class Vessel<3>;

}  // namespace ostium::sph3d
