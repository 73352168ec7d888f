// The whole force of the blood on the wall against balances of forces, for rigid walls and walls that move.
#include "sph3d/fields/wall_sums.hpp"

#include <gtest/gtest.h>

#include "sph3d/fields/structure_fields.hpp"
#include "sph3d/shell/recover.hpp"
#include "vessels.hpp"
#include "wall_shells.hpp"

namespace ostium::sph3d {
namespace {

constexpr double rho = 1000, dp = 1e-3;

template <int D>
FluidOptions<D> fluid(double viscosity) {
  return {.dp = dp, .density = rho, .viscosity = viscosity, .sound_speed = 10, .reference_speed = 0.3};
}

template <int D>
WallForce<D> force_on(const Vessel<D>& vessel) {
  WallSampler<D> sampler(vessel);
  sampler.sample(vessel);
  return wall_force(vessel, sampler);
}

/// int n dA over the wall: what the openings lack to a closed surface.
template <int D>
Vec<D> area_of_wall(const Lumen<D>& lumen) {
  Vec<D> sum = Vec<D>::Zero();
  for (const auto& o : lumen.openings) sum -= o.area * o.normal;
  return sum;
}

template <int D>
void uniform_pressure_pushes_against_the_openings(const Lumen<D>& lumen) {
  Vessel<D> vessel(lumen, fluid<D>(1e-5), {{true, Profile::parabolic}, {}}, 300.0);
  PressureDatum datum;
  datum.reference = 12000;
  vessel.start_datum(datum);
  const auto force = force_on(vessel);
  const Vec<D> exact = 12300 * area_of_wall(lumen);
  EXPECT_LT((force.pressure - exact).norm(), 1e-5 * 12300 * lumen.openings[0].area);
  EXPECT_EQ(force.friction.norm(), 0);
}
TEST(WallSums, UniformPressure2d) {
  uniform_pressure_pushes_against_the_openings(channel(0.03, 0.01));
  uniform_pressure_pushes_against_the_openings(plane_channel(0.01, 0.008, 0.014));
}
TEST(WallSums, UniformPressure3d) {
  uniform_pressure_pushes_against_the_openings(lumen_of(generate(BendShape{
      .radius = 4e-3, .bend_radius = 9e-3, .inlet_length = 3e-3, .outlet_length = 3e-3, .around = 48})));
}

/// p = p_0 + g . x, given to the particles: int p n dA over the wall is V g less what stands at the openings.
TEST(WallSums, PressureThatRisesAcross) {
  const double length = 0.03, width = 0.012, slope = 5e4;
  Vessel<2> vessel(channel(length, width), fluid<2>(1e-5), {{true, Profile::parabolic}, {}});
  auto state = vessel.save();
  for (std::size_t i = 0; i < state.fluid.places(); ++i)
    state.fluid.psi(i) = static_cast<float>(slope * state.fluid.position[i][1] / (rho * 100));
  vessel.load(state);
  const double exact = slope * width * length;
  EXPECT_NEAR(force_on(vessel).pressure[1], exact, 0.15 * exact);  // read half a spacing from the walls
}

template <int D>
void step(Vessel<D>& vessel, double end, const std::vector<Drive>& drives) {
  auto now = drives;
  while (vessel.time() < end) {
    for (auto& drive : now) drive.since = vessel.time();
    vessel.advance(1, now, 0.01);
  }
}

constexpr double speed = 0.2, viscosity = 1e-3;  // mean; kinematic

/// Developed flow: what the wall takes is what the openings push, whose pressures are read a little inside.
template <int D>
void friction_balances_the_drop(const Lumen<D>& lumen, double exact, double settled) {
  Vessel<D> vessel(lumen, fluid<D>(viscosity), {{true, Profile::parabolic}, {}}, 400.0);
  std::vector<Drive> drives(2);
  drives[0].flow_in = speed * lumen.openings[0].area;
  drives[1].law.p_star = 400;
  step(vessel, settled, drives);
  Vec<D> friction = Vec<D>::Zero(), pressure = Vec<D>::Zero();
  double drop = 0;
  constexpr int samples = 40;
  WallSampler<D> sampler(vessel);
  for (int k = 0; k < samples; ++k) {
    step(vessel, settled + 1e-3 * (k + 1), drives);
    sampler.sample(vessel);
    const auto force = wall_force(vessel, sampler);
    friction += force.friction / samples, pressure += force.pressure / samples;
    drop += (vessel.port(0).pressure - vessel.port(1).pressure) / samples;
  }
  EXPECT_NEAR(friction[0], exact, 0.05 * exact);
  EXPECT_NEAR(drop * lumen.openings[0].area, exact, 0.15 * exact);
  EXPECT_LT(friction.template tail<D - 1>().norm(), 0.05 * exact);
  EXPECT_LT(std::abs(pressure[0]), 0.01 * exact);
}
TEST(WallSums, FrictionIsThePressureDrop2d) {
  friction_balances_the_drop(channel(0.03, 0.01), 12 * rho * viscosity * speed * 0.03 / 0.01, 0.06);
}
TEST(WallSums, FrictionIsThePressureDrop3d) {
  friction_balances_the_drop(tube(0.005, 0.014), 8 * pi * rho * viscosity * speed * 0.014, 0.02);
}

TEST(WallSums, WhoHasGoneFurthest) {
  std::vector<WallPoint<2>> rest{{{0, 0}, {0, 1}, 1}, {{1, 0}, {0, 1}, 1}, {{2, 0}, {0, 1}, 1}}, now = rest;
  EXPECT_EQ(furthest_displaced(rest, now).displacement, 0);
  now[1].position = {1.3, 0.4}, now[2].position = {2, 0.4};
  EXPECT_NEAR(furthest_displaced(rest, now).displacement, 0.5, 1e-15);
  EXPECT_EQ(furthest_displaced(rest, now).position, Vec2(1.3, 0.4));
}

/// A bent channel with a shell around it, before blood of this pressure.
Vessel<2> bend_with_shell(const Lumen<2>& lumen, double pressure) {
  Vessel<2> vessel(lumen, fluid<2>(1e-5), {{true, Profile::parabolic}, {}}, pressure);
  const ShellWallOptions wall{.spacing = dp, .fluid_spacing = dp, .thickness = 1e-3};
  const auto shell = shell_of(lumen, wall);
  ShellOptions options{
      .spacing = dp, .density = rho, .material = SaintVenantKirchhoff({.E = 1e6, .nu = 0.45})};
  options.spring = 4e6, options.dashpot = 2e4;
  vessel.set_wall(std::make_unique<DeformableWall<2>>(ShellModel<2>(shell.cloud, options), shell.contact,
                                                      vessel.model().reach(), SurroundingsOfWall{}));
  return vessel;
}

/// Blood at rest beside a wall that has given way: on average it is pushed as the pressure tells.
TEST(WallSums, AWallThatMovesFeelsTheSumOfItsForces) {
  const double pressure = 1000, reference = 1500;
  const auto lumen = plane_channel(0.01, 0.01, 0.018);
  auto vessel = bend_with_shell(lumen, pressure);
  PressureDatum datum;
  datum.reference = reference;
  vessel.start_datum(datum);
  const Vec2 exact = (pressure + reference) * area_of_wall(lumen);
  EXPECT_LT((force_on(vessel).pressure - exact).norm(), 0.01 * exact.norm());  // before the first step

  std::vector<Drive> drives(2);
  drives[1].law = {.p_star = pressure + reference, .resistance = 1e4};
  step(vessel, 0.05, drives);
  WallSampler<2> sampler(vessel);
  WallForce<2> force;
  Vec2 mean = Vec2::Zero();
  constexpr int samples = 50;  // a single one is that of one acoustic step
  for (int k = 0; k < samples; ++k) {
    step(vessel, 0.05 + 1e-3 * (k + 1), drives);
    sampler.sample(vessel);
    force = wall_force(vessel, sampler);
    mean += force.pressure / samples;
  }
  Vec2 given = Vec2::Zero();
  for (const auto& f : vessel.wall()->forces()) given += f;
  for (const auto& p : sampler.points()) given += vessel.state().datum.reference * p.area * p.normal;
  EXPECT_LT((force.pressure + force.friction - given).norm(), 1e-12 * given.norm());
  EXPECT_LT((mean - exact).norm(), 0.02 * exact.norm());
  EXPECT_LT(force.friction.norm(), 0.01 * exact.norm());
  EXPECT_GT(furthest_displaced(sampler.at_rest(), sampler.points()).displacement, 0.1 * dp);
  const double energy = energies(vessel.wall()->shell(), vessel.state().wall.shell).strain;
  EXPECT_GT(energy, 0);
  EXPECT_NEAR(strain_energy(*vessel.wall(), vessel.state().wall), energy, 1e-12 * energy);
}

}  // namespace
}  // namespace ostium::sph3d
