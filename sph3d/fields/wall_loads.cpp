#include "sph3d/fields/wall_loads.hpp"

#include <cmath>

#include "sph3d/fields/near_wall.hpp"

namespace ostium::sph3d {

template <int D>
WallSampler<D>::WallSampler(const Vessel<D>& vessel)
    : rest_(wall_points_at_rest(vessel)),
      now_(rest_),
      nearest_(rest_, vessel.model().options.dp, vessel.model().reach()),
      smoothing_(smoothing_weights(rest_, vessel.model().kernel.h)),
      received_(rest_.size()),
      loads_{std::vector<Vec<D>>(rest_.size()), std::vector<double>(rest_.size())} {}

template <int D>
void WallSampler<D>::sample(const Vessel<D>& vessel) {
  if (vessel.wall()) now_ = wall_points_now(vessel, rest_);
  if (vessel.wall() && vessel.wall()->motion().places() > 0)
    by_motion(vessel);
  else
    to_nearest(vessel);
  spread(vessel);
}

/// In parallel over batches of clusters, then added up in their order.
template <int D>
void WallSampler<D>::to_nearest(const Vessel<D>& vessel) {
  constexpr std::size_t batch = 128;
  const auto& fluid = vessel.state().fluid;
  const double mass = vessel.model().options.density * fluid.volume;
  given_.resize((fluid.clusters.size() + batch - 1) / batch);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t k = 0; k < given_.size(); ++k) {
    given_[k].clear();
    for_near_wall(vessel, k * batch, (k + 1) * batch, [&](std::size_t i, const Cluster<D>& own, float g) {
      const std::int32_t point = nearest_(fluid.position[i]);
      if (point < 0) return;
      Given given{.point = point, .force = {}, .weight = g, .psi = g * own.psi[i % 8]};
      for (int d = 0; d < D; ++d)
        given.force[d] = static_cast<float>(mass) * own.friction[i % 8] * own.v[d][i % 8];
      given_[k].push_back(given);
    });
  }
  received_.assign(rest_.size(), {});
  for (const auto& from_batch : given_)
    for (const Given& given : from_batch) {
      Received& received = received_[given.point];
      for (int d = 0; d < D; ++d) received.force[d] += given.force[d];
      received.weight += given.weight, received.psi += given.psi;
    }
}

template <int D>
void WallSampler<D>::by_motion(const Vessel<D>& vessel) {
  const auto& fluid = vessel.state().fluid;
  const auto& motion = vessel.wall()->motion();
  const double mass = vessel.model().options.density * fluid.volume;
  std::vector<Vec<D>> force(motion.places(), Vec<D>::Zero()), pressure = force;
  for_near_wall(vessel, 0, motion.places() / 8, [&](std::size_t i, const Cluster<D>& own, float g) {
    const Vec<D> slip = lane_vector<D>(own.v, i % 8) - lane_vector<D>(motion.velocity()[i / 8].v, i % 8);
    force[i] = mass * own.friction[i % 8] * slip;
    pressure[i][0] = g, pressure[i][1] = double(g) * own.psi[i % 8];
  });
  shared_.resize(rest_.size());
  motion.gather(shared_, [&](std::size_t i) { return force[i]; });
  for (std::size_t a = 0; a < rest_.size(); ++a) received_[a].force = shared_[a];
  motion.gather(shared_, [&](std::size_t i) { return pressure[i]; });
  for (std::size_t a = 0; a < rest_.size(); ++a)
    received_[a].weight = shared_[a][0], received_[a].psi = shared_[a][1];
}

template <int D>
void WallSampler<D>::spread(const Vessel<D>& vessel) {
  const auto& o = vessel.model().options;
  const double stiffness = o.density * o.sound_speed * o.sound_speed, datum = vessel.state().datum.reference;
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < rest_.size(); ++a) {
    Received sum;
    for (auto n = smoothing_.begin[a]; n < smoothing_.begin[a + 1]; ++n) {
      const auto [b, weight] = smoothing_.entry[n];
      const Received& from = received_[b];
      const double w = weight;
      sum.force += w * from.force, sum.weight += w * from.weight, sum.psi += w * from.psi;
    }
    const Vec<D>& n = now_[a].normal;
    loads_.shear_stress[a] = (sum.force - sum.force.dot(n) * n) / now_[a].area;
    loads_.pressure[a] = datum + (sum.weight > 0.0 ? stiffness * sum.psi / sum.weight : 0.0);
  }
}

template <int D>
Vec<D> WallSampler<D>::force() const {
  Vec<D> sum = Vec<D>::Zero();
  for (const Received& received : received_) sum += received.force;
  return sum;
}

template class WallSampler<2>;
template class WallSampler<3>;

}  // namespace ostium::sph3d
