// Walls that move with the blood.
#include <gtest/gtest.h>

#include <cstdio>

#include "tube_walls.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

/// Both walls of a channel as shells, clamped where the ducts begin; contact points on the channel's walls.
struct ChannelWalls {
  ShellCloud<2> cloud;
  std::vector<Vec2> contact;

  ChannelWalls(double length, double height, double spacing, double thickness) {
    for (const double side : {-1.0, 1.0})
      for (double x = 0.5 * spacing; x < length; x += spacing) {
        const Vec2 n(0, side);
        contact.emplace_back(x, 0.5 * (1 + side) * height);
        cloud.position.push_back(contact.back() + 0.5 * thickness * n);
        cloud.normal.push_back(n);
        cloud.area.push_back(spacing);
        cloud.thickness.push_back(thickness);
        cloud.support.push_back(std::min(x, length - x) < 4 * spacing ? Support::clamped : Support::free);
        cloud.axis.push_back(Vec2(1, 0));
      }
  }
};

constexpr double height = 0.010, length = 0.080, dp = 1e-3, pressure = 2000, stiffness = 4e6;

/// A channel of blood at rest under pressure, whose walls stand on springs.
struct ChannelOnSprings {
  ChannelWalls walls{length, height, dp, 1e-3};
  Vessel<2> vessel;

  ChannelOnSprings()
      : vessel(channel(length, height),
               {.dp = dp, .density = 1000, .viscosity = 1e-5, .sound_speed = 10, .reference_speed = 0.3},
               {{}, {}}, pressure) {
    ShellOptions options{
        .spacing = dp, .density = 1000, .material = SaintVenantKirchhoff({.E = 1e7, .nu = 0.3})};
    options.spring = stiffness, options.dashpot = 2e4;
    vessel.set_wall(std::make_unique<DeformableWall<2>>(ShellModel<2>(walls.cloud, options), walls.contact,
                                                        vessel.model().reach(), SurroundingsOfWall{}));
  }

  void advance() {
    std::vector<Drive> drives(2);
    for (auto& drive : drives)
      drive.law = {.p_star = pressure, .resistance = 4e5};  // about that of its waves
    vessel.advance(1, drives, 0.01);
  }

  /// Mean in the core of the middle part.
  double blood_pressure() const {
    const auto& fluid = vessel.state().fluid;
    double sum = 0;
    int n = 0;
    for (std::size_t i = 0; i < fluid.places(); ++i)
      if (fluid.filled[i] && std::abs(fluid.position[i][0] - length / 2) < 10.1 * dp &&
          std::abs(fluid.position[i][1] - height / 2) < 3.5 * dp)
        sum += fluid.psi(i), ++n;
    return 1000 * 10 * 10 * sum / n;
  }

  /// Mean over the middle of both walls.
  template <class F>
  double mean(F&& f) const {
    double sum = 0;
    int n = 0;
    for (std::size_t a = 0; a < walls.contact.size(); ++a)
      if (std::abs(walls.contact[a][0] - length / 2) < 10.1 * dp) sum += f(a), ++n;
    return sum / n;
  }
};

/// On springs a wall gives way by p / k, p being the pressure of the blood beside it; that is a little above what the
/// openings ask for, by less than 0.1 % of rho c^2.
TEST(MovingWalls, ChannelOnSpringsWidensUnderPressure) {
  ChannelOnSprings channel;
  const auto& walls = channel.walls;
  const auto& state = channel.vessel.state();
  while (channel.vessel.time() < 0.10) channel.advance();
  double displacement = 0, load = 0, blood = 0;
  int n = 0;
  for (; channel.vessel.time() < 0.20; ++n) {
    channel.advance();
    displacement += channel.mean(
        [&](std::size_t a) { return state.wall.shell.displacement(a).dot(walls.cloud.normal[a]); });
    load += channel.mean(
        [&](std::size_t a) { return channel.vessel.wall()->forces()[a].dot(walls.cloud.normal[a]) / dp; });
    blood += channel.blood_pressure();
  }
  displacement /= n, load /= n, blood /= n;
  EXPECT_NEAR(displacement * stiffness, load, 0.01 * load);
  EXPECT_NEAR(load, blood, 0.015 * blood);
  EXPECT_NEAR(blood, pressure, 1e-3 * 1000 * 10 * 10);
  EXPECT_EQ(state.escaped, 0);
}

/// A particle that is shot through a wall returns to where it was, and is counted with its place.
TEST(MovingWalls, WhoGoesThroughTheWallIsPutBack) {
  ChannelOnSprings channel;
  channel.advance();
  auto state = channel.vessel.save();
  std::size_t shot = 0;
  while (!state.fluid.filled[shot] || (state.fluid.position[shot] - Vec2(0.04, 0.0085)).norm() > 1.0 * dp)
    ++shot;
  const Vec2 before = state.fluid.position[shot];
  state.fluid.velocity(shot, Vec2(0, 60));
  channel.vessel.load(state);
  std::vector<Drive> drives(2);
  for (auto& drive : drives) drive.law = {.p_star = pressure, .resistance = 4e5};
  const StepReport report = channel.vessel.advance(1, drives, 0.01);
  EXPECT_EQ(report.leaked, 1);
  EXPECT_EQ(channel.vessel.state().escaped, 1);
  EXPECT_NEAR(report.leak[0], before[0], 1e-4);
  EXPECT_NEAR(report.leak[1], before[1], 1e-4);
}

/// What the walls receive the blood has lost: the sum over the wall points is the sum over the particles.
TEST(MovingWalls, ForcesAreSharedOutWithoutLoss) {
  ChannelOnSprings channel;
  while (channel.vessel.time() < 0.01) channel.advance();
  const auto& motion = channel.vessel.wall()->motion();
  std::vector<Vec2> received(channel.walls.contact.size());
  const auto force = [](std::size_t i) { return Vec2(std::sin(0.7 * i), std::cos(1.3 * i)); };
  motion.gather(received, force);
  Vec2 given = Vec2::Zero(), sum = Vec2::Zero();
  int attached = 0;
  for (std::size_t i = 0; i < motion.places(); ++i)
    if (motion.attached(i)) given += force(i), ++attached;
  for (const Vec2& f : received) sum += f;
  EXPECT_GT(attached, 200);
  EXPECT_LT((sum - given).norm(), 1e-5 * attached);
}

/// A straight tube of rings of shell particles around a tube of blood, clamped where the ducts begin.
struct InflatedTube {
  static constexpr double tube_length = 0.040, thickness = 0.001, E = 1e6, nu = 0.45, tube_pressure = 4000,
                          c = 20, rho = 1000;
  const double radius, middle = radius + 0.5 * thickness;
  TubeWall wall;
  Vessel<3> vessel;

  explicit InflatedTube(double inner_radius)
      : radius(inner_radius),
        wall(radius, tube_length, dp, thickness),
        vessel(tube(radius, tube_length),
               {.dp = dp, .density = rho, .viscosity = 4e-6, .sound_speed = c, .reference_speed = 0.3},
               {{}, {}}, tube_pressure) {
    ShellOptions options{.spacing = dp, .density = rho, .material = SaintVenantKirchhoff({.E = E, .nu = nu})};
    options.dashpot = 1e4;
    vessel.set_wall(std::make_unique<DeformableWall<3>>(ShellModel<3>(wall.cloud, options), wall.contact,
                                                        vessel.model().reach(), SurroundingsOfWall{}));
  }

  void advance() {
    std::vector<Drive> drives(2);
    for (auto& drive : drives) drive.law = {.p_star = tube_pressure, .resistance = 9e7};
    vessel.advance(1, drives, 0.01);
  }

  bool in_middle(double x) const { return std::abs(x - tube_length / 2) < 8.1 * dp; }

  double widening() const {
    double sum = 0;
    int n = 0;
    for (std::size_t a = 0; a < wall.contact.size(); ++a)
      if (in_middle(wall.contact[a][0]))
        sum += vessel.state().wall.shell.displacement(a).dot(wall.cloud.normal[a]), ++n;
    return sum / n;
  }
  double blood_pressure() const {
    const auto& fluid = vessel.state().fluid;
    double sum = 0;
    int n = 0;
    for (std::size_t i = 0; i < fluid.places(); ++i)
      if (fluid.filled[i] && in_middle(fluid.position[i][0]) &&
          std::hypot(fluid.position[i][1], fluid.position[i][2]) < 3.5 * dp)
        sum += fluid.psi(i), ++n;
    return rho * c * c * sum / n;
  }

  /// p (R_i + u) = t E' lambda (lambda^2 - 1) / 2, held along the axis.
  double exact(double p) const {
    double u = 0;
    for (int k = 0; k < 50; ++k) {
      const double lambda = 1 + u / middle;
      u = middle * (std::sqrt(1 + 2 * p * (radius + u) * (1 - nu * nu) / (thickness * E * lambda)) - 1);
    }
    return u;
  }
};

/// An elastic tube under the pressure of the blood in it widens as a thin cylinder does.
void widens(double radius, double tolerance) {
  InflatedTube tube(radius);
  while (tube.vessel.time() < 0.03) tube.advance();
  double u = 0, p = 0;
  int n = 0;
  for (; tube.vessel.time() < 0.05; ++n) {
    tube.advance();
    u += tube.widening(), p += tube.blood_pressure();
  }
  std::printf("R = %.0f dp: widening %.4f of exact, largest speed %.3f m/s\n", radius / dp,
              u / n / tube.exact(p / n), tube.vessel.state().max_speed);
  EXPECT_NEAR(u / n, tube.exact(p / n), tolerance * tube.exact(p / n));
  EXPECT_EQ(tube.vessel.state().mirrored, 0);
}
TEST(FullMovingWalls, InflatedTube6) { widens(0.006, 0.04); }
TEST(FullMovingWalls, InflatedTube9) { widens(0.009, 0.02); }
TEST(FullMovingWalls, InflatedTube12) { widens(0.012, 0.02); }

}  // namespace
}  // namespace ostium::sph3d
