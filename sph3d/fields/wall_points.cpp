#include "sph3d/fields/wall_points.hpp"

#include "sph3d/geometry/stretches.hpp"

namespace ostium::sph3d {

namespace {

std::vector<WallPoint<2>> spread(const Lumen<2>& lumen, double dp) {
  return spread_evenly(lumen.surface, dp);
}
std::vector<WallPoint<3>> spread(const Lumen<3>& lumen, double dp) { return sample_wall(lumen, dp); }

}  // namespace

template <int D>
std::vector<WallPoint<D>> wall_points_at_rest(const Vessel<D>& vessel) {
  if (vessel.wall()) return vessel.wall()->points_at_rest();
  return spread(vessel.model().lumen, vessel.model().options.dp);
}

template <int D>
std::vector<WallPoint<D>> wall_points_now(const Vessel<D>& vessel, const std::vector<WallPoint<D>>& rest) {
  return vessel.wall() ? vessel.wall()->points(vessel.state().wall) : rest;
}

#define OSTIUM_INSTANTIATE(D)                                               \
  template std::vector<WallPoint<D>> wall_points_at_rest(const Vessel<D>&); \
  template std::vector<WallPoint<D>> wall_points_now(const Vessel<D>&, const std::vector<WallPoint<D>>&);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
