// Wall fields: how they are sampled, smoothed, mapped and summed over a cycle.
#include <gtest/gtest.h>

#include <functional>

#include "sph3d/fields/near_wall.hpp"
#include "sph3d/fields/wall_cycle.hpp"
#include "sph3d/fields/wall_gradient.hpp"
#include "sph3d/fields/wall_loads.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

constexpr double radius = 0.005, length = 0.014, dp = 1e-3;

TEST(WallFields, TheTableFindsTheNearestPoint) {
  const auto wall = sample_wall(tube(radius, length), dp);
  const double reach = 2.6 * dp;
  const NearestWallPoint<3> nearest(wall, dp, reach);
  for (int k = 0; k < 2000; ++k) {
    const double r = radius - reach * (k % 97) / 97.0, angle = 0.37 * k, x = length * (k % 31) / 31.0;
    const Vec3 place(x, r * std::cos(angle), r * std::sin(angle));
    double least = 1e300;
    for (const auto& p : wall) least = std::min(least, (p.position - place).norm());
    const int found = nearest(place);
    ASSERT_GE(found, 0);
    EXPECT_LE((wall[found].position - place).norm(), least + std::sqrt(3.0) * 0.5 * dp);
  }
  EXPECT_EQ(nearest(Vec3(0.5 * length, 0, 0)), -1);  // in the middle of the tube
  EXPECT_EQ(nearest(Vec3(-1, 2, 3)), -1);
}

TEST(WallFields, SmoothingKeepsTheSumOfForces) {
  const auto wall = sample_wall(tube(radius, length), dp);
  const auto weights = smoothing_weights(wall, 1.3 * dp);
  std::vector<Vec3> force(wall.size());
  Vec3 given = Vec3::Zero(), received = Vec3::Zero();
  for (std::size_t a = 0; a < wall.size(); ++a) {
    force[a] = Vec3(1, std::sin(0.7 * double(a)), std::cos(1.3 * double(a)));
    given += force[a];
  }
  for (std::size_t a = 0; a < wall.size(); ++a) received += weights.at(a, force, Vec3(Vec3::Zero()));
  EXPECT_LT((given - received).norm(), 1e-6 * given.norm());
}

/// Fields that are linear along the wall arrive as they are, at the rims as well; walls that face each other do not mix.
TEST(WallFields, MappingIsExactForLinearFields) {
  const auto lumen = channel(0.03, 0.002);  // as narrow as the kernel
  const auto wall = sample_wall(lumen, dp);
  std::vector<double> field;
  for (const auto& p : wall) field.push_back(3 + 200 * p.position.x() + (p.normal.y() > 0 ? 10 : 0));
  std::vector<Vec2> points, normals;
  for (double x = 0; x < 0.0301; x += 0.00073)
    for (const double side : {-1.0, 1.0})
      points.emplace_back(x, side > 0 ? 0.002 : 0), normals.emplace_back(0, side);
  const auto weights = mapping_weights(wall, points, normals, 1.3 * dp);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(weights.at(i, field, 0.0), 3 + 200 * points[i].x() + (normals[i].y() > 0 ? 10 : 0), 1e-4);
}

TEST(WallFields, MappingToATubeFindsTheAxialCoordinate) {
  const auto lumen = tube(radius, length, 64, 5);
  const auto wall = sample_wall(lumen, dp);
  std::vector<double> field;
  for (const auto& p : wall) field.push_back(p.position.x());
  std::vector<Vec3> points, normals;
  for (const Vec3& x : lumen.surface.points)
    if (const Vec3 n(0, x.y(), x.z()); n.norm() > 0.5 * radius)
      points.push_back(x), normals.push_back(n.normalized());
  const auto weights = mapping_weights(wall, points, normals, 1.3 * dp);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(weights.at(i, field, 0.0), points[i].x(), 1e-5 * length);
}

template <int D>
Vessel<D> flowing(const Lumen<D>& lumen, double end) {
  Vessel<D> vessel(lumen,
                   {.dp = dp, .density = 1000, .viscosity = 1e-5, .sound_speed = 10, .reference_speed = 0.5},
                   {{true, Profile::parabolic}, {}}, 300.0);
  std::vector<Drive> drives(2);
  drives[0].flow_in = 0.3 * lumen.openings[0].area;
  drives[1].law.p_star = 300;
  while (vessel.time() < end) {
    drives[0].since = drives[1].since = vessel.time();
    vessel.advance(1, drives, 0.01);
  }
  return vessel;
}

template <int D>
void receives_all_friction(const Lumen<D>& lumen) {
  const auto vessel = flowing(lumen, 0.01);
  WallSampler<D> sampler(vessel);
  sampler.sample(vessel);
  Vec<D> felt = Vec<D>::Zero(), received = Vec<D>::Zero();
  const double mass = 1000 * vessel.state().fluid.volume;
  for_near_wall(vessel, 0, vessel.state().fluid.clusters.size(),
                [&](std::size_t i, const Cluster<D>& own, float) {
                  felt += mass * own.friction[i % 8] * vessel.state().fluid.velocity(i);
                });
  for (std::size_t a = 0; a < sampler.points().size(); ++a)
    received += sampler.points()[a].area * sampler.loads().shear_stress[a];
  EXPECT_GT(felt[0], 0);
  EXPECT_LT((sampler.force() - felt).norm(), 1e-6 * felt.norm());
  EXPECT_NEAR(received[0], felt[0], 1e-5 * felt[0]);
}
TEST(WallFields, TheWallReceivesAllFriction2d) { receives_all_friction(channel(0.03, 0.01)); }
TEST(WallFields, TheWallReceivesAllFriction3d) { receives_all_friction(tube(radius, length)); }

/// Particles where a flow has carried them, with the velocities of developed flow: gamma = 4 u_max / width.
template <int D, class Radius>
void finds_the_slope_of_a_parabola(const Lumen<D>& lumen, double half, Radius radius, double tolerance) {
  auto vessel = flowing(lumen, 0.01);
  auto state = vessel.save();
  for (std::size_t i = 0; i < state.fluid.places(); ++i) {
    const double xi = radius(state.fluid.position[i]) / half;
    state.fluid.velocity(i, (1 - xi * xi) * Vec<D>::Unit(0));
  }
  vessel.load(state);
  const auto wall = wall_points_at_rest(vessel);
  const auto stress = shear_stress_from_gradient(vessel, wall);
  const double exact = 1000 * 1e-5 * 2 / half, end = lumen.openings[1].centre[0];
  double mean = 0, worst = 0;
  int n = 0;
  for (std::size_t a = 0; a < wall.size(); ++a) {
    if (std::abs(wall[a].position[0] - 0.5 * end) > 0.5 * end - 3 * dp) continue;
    mean += stress[a][0] / exact, ++n;
    worst = std::max(worst, (stress[a] / exact - Vec<D>::Unit(0)).norm());
  }
  EXPECT_NEAR(mean / n, 1, tolerance);
  EXPECT_LT(worst, 5 * tolerance);
}
TEST(WallFields, GradientOfAParabola2d) {
  finds_the_slope_of_a_parabola(
      channel(0.03, 0.01), 0.005, [](const Vec2& x) { return x[1] - 0.005; }, 1e-6);
}
TEST(WallFields, GradientOfAParabola3d) {
  finds_the_slope_of_a_parabola(
      tube(0.007, 0.012, 256), 0.007, [](const Vec3& x) { return std::hypot(x[1], x[2]); }, 0.01);
}

TEST(WallFields, SameBitsForOneAndTwoThreads) {
  const auto vessel = flowing(tube(radius, length), 0.004);
  const auto loads = [&](int threads) {
    const Threads scope(threads);
    WallSampler<3> sampler(vessel);
    sampler.sample(vessel);
    return sampler.loads();
  };
  const auto one = loads(1), two = loads(2);
  EXPECT_EQ(one.shear_stress, two.shear_stress);
  EXPECT_EQ(one.pressure, two.pressure);
}

/// Samples of one wall point: steps that do not divide the period, no filter unless asked for.
std::vector<CycleFields<2>> cycles_of(const std::function<Vec2(double)>& stress, double period, int cycles,
                                      double filter = 0) {
  WallCycle<2> cycle;
  std::vector<CycleFields<2>> ended;
  for (double t = 0; t < (cycles + 0.01) * period; t += period / 997.3) {
    auto fields = take(cycle, t, {stress(t)}, {100 + 10 * t}, period, filter);
    if (fields.number >= 0) ended.push_back(fields);
  }
  return ended;
}

TEST(WallCycle, SteadyStressDoesNotOscillate) {
  const auto cycles = cycles_of([](double) { return Vec2(3, 4); }, 0.8, 2);
  ASSERT_EQ(cycles.size(), 2u);
  for (int k = 0; k < 2; ++k) {
    EXPECT_EQ(cycles[k].number, k);
    EXPECT_NEAR(cycles[k].duration, 0.8, 1e-12);
    EXPECT_NEAR(cycles[k].tawss[0], 5, 1e-12);
    EXPECT_NEAR(cycles[k].osi(0), 0, 1e-12);
    EXPECT_NEAR(cycles[k].rrt(0), 0.2, 1e-12);
    EXPECT_NEAR(cycles[k].mean_pressure[0], 100 + 10 * 0.8 * (k + 0.5), 1e-9);
  }
}

/// A run that stops with its last cycle has a sample there, however soon after the one before.
TEST(WallCycle, EndsWithItsPeriod) {
  WallCycle<2> cycle;
  const std::vector<Vec2> stress{{1, 0}};
  EXPECT_FALSE(ends(cycle, 1.0, 0.5));  // nothing has begun
  take(cycle, 0.0, stress, {0.0}, 0.5, 0.01);
  take(cycle, 0.499, stress, {0.0}, 0.5, 0.01);
  EXPECT_FALSE(ends(cycle, 0.4995, 0.5));
  EXPECT_FALSE(ends(cycle, 0.5, 0.0));
  EXPECT_TRUE(ends(cycle, 0.5, 0.5));
  EXPECT_EQ(take(cycle, 0.5, stress, {0.0}, 0.5, 0.01).number, 0);
}

TEST(WallCycle, SwingingStressHasHalf) {
  const double period = 0.8, omega = 2 * pi / period;
  const auto cycles = cycles_of([&](double t) { return Vec2(0, 2 * std::sin(omega * t + 0.4)); }, period, 2);
  EXPECT_NEAR(cycles[1].tawss[0], 4 / pi, 1e-4);
  EXPECT_NEAR(cycles[1].osi(0), 0.5, 1e-4);
}

/// tau = 1 + 2 sin: int |tau| = T (1/3 + 2 sqrt(3) / pi), int tau = T.
TEST(WallCycle, AStressThatTurnsBackForAThirdOfTheCycle) {
  const double period = 1, omega = 2 * pi;
  const auto cycles = cycles_of([&](double t) { return Vec2(1 + 2 * std::sin(omega * t), 0); }, period, 2);
  const double tawss = 1.0 / 3 + 2 * std::sqrt(3.0) / pi;
  EXPECT_NEAR(cycles[1].tawss[0], tawss, 1e-5);
  EXPECT_NEAR(cycles[1].osi(0), 0.5 * (1 - 1 / tawss), 1e-5);
  EXPECT_NEAR(cycles[1].rrt(0), 1.0, 1e-5);
}

/// The filter takes noise away that would count as oscillation, and leaves the first harmonic.
TEST(WallCycle, NoiseIsFilteredBeforeMagnitudesAreTaken) {
  const double period = 1, theta = period / (2 * pi * 20);
  const auto noisy = [&](double t) { return Vec2(1, 1.5 * std::sin(2 * pi * 311 * t)); };
  EXPECT_GT(cycles_of(noisy, period, 2)[1].osi(0), 0.1);
  EXPECT_LT(cycles_of(noisy, period, 2, theta)[1].osi(0), 0.003);
  const auto harmonic = [&](double t) { return Vec2(0, std::sin(2 * pi * t)); };
  EXPECT_NEAR(cycles_of(harmonic, period, 3, theta)[2].tawss[0], 2 / pi / std::hypot(1, 0.05), 2e-4);
}

}  // namespace
}  // namespace ostium::sph3d
