// Wall fields of walls that move: areas, displaced surfaces, stresses, and forces of blood in motion.
#include <gtest/gtest.h>

#include "sph3d/fields/near_wall.hpp"
#include "sph3d/fields/structure_fields.hpp"
#include "sph3d/fields/surface_map.hpp"
#include "sph3d/fields/wall_loads.hpp"
#include "sph3d/shell/recover.hpp"
#include "wall_shells.hpp"

namespace ostium::sph3d {
namespace {

constexpr double E = 1e6, nu = 0.45, rho = 1000;

template <int D>
Vessel<D> vessel_with_shell(const Lumen<D>& lumen, const ShellWallOptions& wall, double pressure) {
  Vessel<D> vessel(lumen,
                   {.dp = wall.fluid_spacing,
                    .density = rho,
                    .viscosity = 1e-5,
                    .sound_speed = 10,
                    .reference_speed = 0.3},
                   {{true, Profile::parabolic}, {}}, pressure);
  const auto shell = shell_of(lumen, wall);
  ShellOptions options{
      .spacing = wall.spacing, .density = rho, .material = SaintVenantKirchhoff({.E = E, .nu = nu})};
  options.spring = 4e6, options.dashpot = 2e4;
  vessel.set_wall(std::make_unique<DeformableWall<D>>(ShellModel<D>(shell.cloud, options), shell.contact,
                                                      vessel.model().reach(), SurroundingsOfWall{}));
  return vessel;
}

/// A tube whose wall is displaced by a twentieth of its radius, everywhere along its normals.
TEST(MovingWallFields, AWidenedTube) {
  const Carotid carotid{.radius = 3e-3, .length = 9e-3, .thickness = 0.6e-3, .spacing = 0.6e-3};
  const auto lumen = carotid.lumen();
  auto vessel = vessel_with_shell(lumen, carotid.options(WallEnds::released), 0.0);
  const double u = 0.05 * carotid.radius;
  auto state = vessel.save();
  const auto& cloud = vessel.wall()->shell().cloud;
  for (std::size_t a = 0; a < cloud.count(); ++a) state.wall.shell.displacement(a, u * cloud.normal[a]);
  vessel.load(state);

  const auto rest = wall_points_at_rest(vessel), now = wall_points_now(vessel, rest);
  double area_at_rest = 0, area = 0;
  for (const auto& p : rest) area_at_rest += p.area;
  for (const auto& p : now) area += p.area;
  EXPECT_NEAR(area_at_rest, lumen.wall_area, 0.01 * lumen.wall_area);
  EXPECT_NEAR(area / area_at_rest, 1 + u / carotid.radius, 0.002);

  const SurfaceMap<3> map(lumen.surface, rest, vessel.model().kernel.h);
  const auto moved = map.moved(rest, now);
  for (std::size_t i = 0; i < moved.points.size(); ++i) {
    const Vec3 &before = lumen.surface.points[i], &after = moved.points[i];
    if (std::hypot(before.x(), before.y()) < 0.9 * carotid.radius) continue;
    EXPECT_NEAR(std::hypot(after.x(), after.y()) - std::hypot(before.x(), before.y()), u, 0.03 * u);
    EXPECT_NEAR(after.z(), before.z(), 0.03 * u);
  }

  // plane strain along the axis, S = E / (1 - nu^2) (lambda^2 - 1) / 2 around, sigma = lambda^2 S / J; single particles scatter
  const auto fields = structure_fields(*vessel.wall(), vessel.state().wall);
  const double lambda = 1 + u / carotid.middle(), S = E / (1 - nu * nu) * (lambda * lambda - 1) / 2;
  double stress = 0, energy = 0, inner = 0, outer = 0;
  int n_points = 0;
  for (std::size_t a = 0; a < cloud.count(); ++a) {
    if (std::abs(cloud.position[a].z() - 0.5 * carotid.length) > 1.5e-3) continue;
    const Vec3 n = cloud.normal[a], around(-n.y(), n.x(), 0);
    const auto& s = fields.middle.stress[a];
    const auto at = wall_stress(vessel.wall()->shell(), vessel.state().wall.shell, a, 0.0);
    stress += (s[0] * around.x() * around.x() + s[1] * around.y() * around.y() +
               2 * s[3] * around.x() * around.y()) /
              (lambda * S / at.thickness_stretch);
    energy += fields.energy[a] / (carotid.thickness * S * (lambda * lambda - 1) / 4);
    inner += fields.inner.von_mises[a], outer += fields.outer.von_mises[a], ++n_points;
  }
  EXPECT_NEAR(stress / n_points, 1, 0.02);
  EXPECT_NEAR(energy / n_points, 1, 0.04);
  EXPECT_GT(inner, outer);
}

/// Blood flows between walls on springs: what friction has taken arrives at the contact points.
TEST(MovingWallFields, BloodBetweenWallsThatMove) {
  const double dp = 1e-3, pressure = 2000;
  const auto lumen = plane_channel(0.03, 0.012);
  auto vessel = vessel_with_shell(
      lumen, {.spacing = dp, .fluid_spacing = dp, .thickness = 1e-3, .ends = WallEnds::clamped}, pressure);
  std::vector<Drive> drives(2);
  drives[0].flow_in = 0.2 * 0.012;
  drives[1].law = {.p_star = pressure, .resistance = 1e4};
  WallSampler<2> sampler(vessel);
  sampler.sample(vessel);  // before the first step
  EXPECT_NEAR(sampler.loads().pressure[0], pressure, 1e-3 * pressure);
  while (vessel.time() < 0.03) {
    drives[0].since = drives[1].since = vessel.time();
    vessel.advance(1, drives, 0.01);
  }
  sampler.sample(vessel);
  const auto& fluid = vessel.state().fluid;
  const auto& motion = vessel.wall()->motion();
  Vec2 felt = Vec2::Zero(), received = Vec2::Zero();
  for_near_wall(vessel, 0, fluid.clusters.size(), [&](std::size_t i, const Cluster<2>& own, float) {
    if (motion.attached(i))
      felt += rho * fluid.volume * own.friction[i % 8] *
              (fluid.velocity(i) - lane_vector<2>(motion.velocity()[i / 8].v, i % 8));
  });
  double largest = 0;
  for (std::size_t a = 0; a < sampler.points().size(); ++a) {
    received += sampler.points()[a].area * sampler.loads().shear_stress[a];
    largest = std::max(largest, (sampler.points()[a].position - sampler.at_rest()[a].position).norm());
  }
  EXPECT_GT(largest, 0.1 * dp);
  EXPECT_GT(felt[0], 0);
  EXPECT_LT((sampler.force() - felt).norm(), 1e-5 * felt.norm());
  EXPECT_NEAR(received[0], felt[0], 0.02 * felt[0]);  // what points along turned normals is left out
}

}  // namespace
}  // namespace ostium::sph3d
