#include "sph3d/fields/wall_sums.hpp"

#include "sph3d/step/lane_access.hpp"

namespace ostium::sph3d {

namespace {

template <int D>
Vec<D> area_of(const std::vector<WallPoint<D>>& points) {
  Vec<D> sum = Vec<D>::Zero();
  for (const auto& p : points) sum += p.area * p.normal;
  return sum;
}

template <int D>
Vec<D> wall_area_of(const Surface<D>& surface) {
  Vec<D> sum = Vec<D>::Zero();
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
    if (surface.label[f] < 0) sum += area_vector(surface, static_cast<int>(f));
  return sum;
}

template <int D>
Vec<D> sampled_pressure(const Vessel<D>& vessel, const WallSampler<D>& sampled) {
  const auto& points = sampled.points();
  const auto& pressure = sampled.loads().pressure;
  double area = 0, mean = 0;
  for (std::size_t a = 0; a < points.size(); ++a)
    area += points[a].area, mean += points[a].area * pressure[a];
  mean /= area;
  Vec<D> force = mean * (vessel.wall() ? area_of(points) : wall_area_of(vessel.model().lumen.surface));
  for (std::size_t a = 0; a < points.size(); ++a)
    force += (pressure[a] - mean) * points[a].area * points[a].normal;
  return force;
}

/// Of all particles that give their forces to a wall that moves.
template <int D>
Vec<D> friction_on(const DeformableWall<D>& wall, const Vessel<D>& vessel) {
  const auto& fluid = vessel.state().fluid;
  const auto& motion = wall.motion();
  const double mass = vessel.model().options.density * fluid.volume;
  Vec<D> sum = Vec<D>::Zero();
  for (std::size_t i = 0; i < motion.places(); ++i) {
    if (!fluid.filled[i] || !motion.attached(i)) continue;
    const Vec<D> slip = fluid.velocity(i) - lane_vector<D>(motion.velocity()[i / 8].v, i % 8);
    sum += mass * double(fluid.clusters[i / 8].friction[i % 8]) * slip;
  }
  return sum;
}

template <int D>
WallForce<D> exchanged(const DeformableWall<D>& wall, const Vessel<D>& vessel,
                       const std::vector<WallPoint<D>>& points) {
  Vec<D> whole = vessel.state().datum.reference * area_of(points);
  for (const auto& force : wall.forces()) whole += force;
  const Vec<D> friction = friction_on(wall, vessel);
  return {whole - friction, friction};
}

}  // namespace

template <int D>
WallForce<D> wall_force(const Vessel<D>& vessel, const WallSampler<D>& sampled) {
  if (vessel.wall() && vessel.wall()->motion().places() > 0)
    return exchanged(*vessel.wall(), vessel, sampled.points());
  return {sampled_pressure(vessel, sampled), sampled.force()};
}

template <int D>
Furthest<D> furthest_displaced(const std::vector<WallPoint<D>>& rest, const std::vector<WallPoint<D>>& now) {
  Furthest<D> furthest{-1.0};
  for (std::size_t a = 0; a < now.size(); ++a)
    if (const double u = (now[a].position - rest[a].position).norm(); u > furthest.displacement)
      furthest = {u, now[a].position};
  return furthest;
}

#define OSTIUM_INSTANTIATE(D)                                                \
  template WallForce<D> wall_force(const Vessel<D>&, const WallSampler<D>&); \
  template Furthest<D> furthest_displaced(const std::vector<WallPoint<D>>&, const std::vector<WallPoint<D>>&);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
