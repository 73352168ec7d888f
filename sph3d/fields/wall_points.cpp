#include "sph3d/fields/wall_points.hpp"

#include <cmath>

#include "sph3d/geometry/stretches.hpp"
#include "sph3d/shell/recover.hpp"

namespace ostium::sph3d {

namespace {

double length_or_area(const ShellPoint<2>& p, double depth) { return (p.x[0] - depth * p.dn[0]).norm(); }
double length_or_area(const ShellPoint<3>& p, double depth) {
  return (p.x[0] - depth * p.dn[0]).cross(p.x[1] - depth * p.dn[1]).norm();
}

template <int D>
std::vector<WallPoint<D>> contact_points(const DeformableWall<D>& wall, const ShellState<D>& state) {
  const auto& shell = wall.shell();
  const auto contact = wall.contacts(state);
  std::vector<WallPoint<D>> points(contact.size());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < points.size(); ++a) {
    const Vec<D> n = state.normal(a), middle = shell.cloud.position[a] + state.displacement(a);
    const double stretch = length_or_area(ShellPoint<D>(shell, state, a), (middle - contact[a]).dot(n));
    points[a] = {contact[a], n, stretch * shell.cloud.area[a]};
  }
  return points;
}

std::vector<WallPoint<2>> spread(const Lumen<2>& lumen, double dp) {
  return spread_evenly(lumen.surface, dp);
}
std::vector<WallPoint<3>> spread(const Lumen<3>& lumen, double dp) { return sample_wall(lumen, dp); }

}  // namespace

template <int D>
std::vector<WallPoint<D>> wall_points_at_rest(const Vessel<D>& vessel) {
  if (vessel.wall()) return contact_points(*vessel.wall(), rest(vessel.wall()->shell()));
  return spread(vessel.model().lumen, vessel.model().options.dp);
}

template <int D>
std::vector<WallPoint<D>> wall_points_now(const Vessel<D>& vessel, const std::vector<WallPoint<D>>& rest) {
  return vessel.wall() ? contact_points(*vessel.wall(), vessel.state().wall.shell) : rest;
}

#define OSTIUM_INSTANTIATE(D)                                               \
  template std::vector<WallPoint<D>> wall_points_at_rest(const Vessel<D>&); \
  template std::vector<WallPoint<D>> wall_points_now(const Vessel<D>&, const std::vector<WallPoint<D>>&);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
