// Walls that are under pressure in the shape they are given: they stay there, with the stress that statics asks for, and
// answer to more pressure with the stiffness of the loaded wall.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include <cstring>

#include "core/error.hpp"
#include "shell_clouds.hpp"
#include "sph3d/shell/equilibrium.hpp"
#include "sph3d/shell/linear_shell.hpp"
#include "sph3d/shell/prestress.hpp"
#include "sph3d/shell/recover.hpp"
#include "sph3d/shell/stable_step.hpp"
#include "sph3d/walls/deformable_wall.hpp"
#include "wall_shells.hpp"

namespace ostium::sph3d {
namespace {

/// A tube's wall, or in the plane that of a tube that cannot grow longer.
struct Loaded {
  double R = 3e-3, t = 0.6e-3, E = 1e6, nu = 0.45, p = 10e3;  // R of the mid-surface, p on the inner face

  double inner() const { return R - 0.5 * t; }
  double outer() const { return R + 0.5 * t; }
  double plate() const { return E / (1 - nu * nu); }

  ShellOptions options(double dp) const {
    auto o = static_options(dp, E, nu);
    o.face = -1;
    return o;
  }
  ShellModel<2> ring(int n) const { return {sph3d::ring(R, n, t), options(2 * pi * R / n)}; }
  /// A tube of n particles around and as many rows, the last four of both ends held.
  ShellModel<3> tube(int n, Support ends) const {
    const double dp = 2 * pi * R / n;
    auto cloud = cylinder(R, n, n, dp, t);
    for (int i = 0; i < 4 * n; ++i) cloud.support[i] = cloud.support[cloud.count() - 1 - i] = ends;
    return {cloud, options(dp)};
  }
  /// Growth of a tube of constant length that carries p in its shape and gets more. Virtual work of a radial growth u, with
  /// the hoop strain u/r + (u/r)^2/2 at the radius r and hoop stress S0 + plate (u/r), S0 = p a/(r log(b/a)) between the
  /// radii a and b of the faces (the linear solution of the ring):
  ///   [ plate log(b/a) + p t/(b log(b/a)) - p ] u = dp a
  double growth(double more) const {
    const double a = inner(), b = outer(), l = std::log(b / a);
    return more * a / (plate() * l + p * t / (b * l) - p);
  }
};

/// Farthest displacement after some steps in a medium that slows the motion. The wall begins with a push that would make it
/// oval, of the speed given.
template <int D>
double wander(const ShellModel<D>& model, const std::vector<ShellLoad<D>>& load, int steps, double push = 0) {
  auto state = rest(model);
  for (std::size_t a = 0; a < model.count(); ++a) {
    const Vec<D> n = model.cloud.normal[a];
    if (model.cloud.support[a] == Support::clamped) continue;
    state.velocity(a, push * (n[0] * Vec<D>::Unit(0) - n[1] * Vec<D>::Unit(1)));
  }
  ShellWorkspace<D> work(model);
  const double dt = stable_step(model);
  advance(model, state, load, work, {dt, steps, 20.0 / (steps * dt)});
  double farthest = 0;
  for (std::size_t a = 0; a < model.count(); ++a) farthest = std::max(farthest, state.displacement(a).norm());
  return farthest;
}

/// Displacements and turns without pattern.
template <int D>
ShellField<D> noise(const ShellModel<D>& model, const LinearShell<D>& shell) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(-1, 1);
  ShellField<D> x(model.count());
  for (std::size_t a = 0; a < x.size(); ++a) {
    for (int d = 0; d < D; ++d) x[a].u[d] = model.options.spacing * value(random), x[a].d[d] = value(random);
    shell.hold(x[a], a);
  }
  return x;
}

template <int D>
void stiffness_is_the_kernels(ShellModel<D> model) {
  const LinearShell<D> shell(model);
  const auto x = noise(model, shell);
  const auto K = shell.stiffness(x);
  auto state = rest(model);
  ShellWorkspace<D> work[2]{ShellWorkspace<D>(model), ShellWorkspace<D>(model)};
  const double step = 1e-5;
  for (int side = 0; side < 2; ++side) {
    for (std::size_t a = 0; a < x.size(); ++a) {
      state.displacement(a, (side ? step : -step) * x[a].u);
      state.normal(a, (model.cloud.normal[a] + (side ? step : -step) * x[a].d).normalized());
    }
    accelerate(model, state, no_load(model), work[side]);
  }
  double largest = 0, error = 0;
  for (std::size_t a = 0; a < x.size(); ++a) {
    const Vec<D> f = (work[0].acceleration(a) - work[1].acceleration(a)) * model.mass(a) / (2 * step);
    largest = std::max(largest, f.norm()), error = std::max(error, (f - K[a].u).norm());
  }
  EXPECT_LT(error, 1e-7 * largest);
}

TEST(ShellPrestress, LinearStiffnessIsThatOfTheKernels) {
  const Loaded wall;
  stiffness_is_the_kernels(wall.ring(40));
  stiffness_is_the_kernels(wall.tube(20, Support::released));
  stiffness_is_the_kernels(wall.tube(20, Support::clamped));
}

TEST(ShellPrestress, NoPressureIsNoStress) {
  auto model = Loaded{}.ring(40);
  EXPECT_EQ(find_prestress(model, no_load(model)).iterations, 0);
  EXPECT_TRUE(model.prestress.empty());
}

// The mean hoop stress is p R_i / t whatever the wall is made of; the profile through the thickness falls as 1/r.
TEST(ShellPrestress, RingStaysAndCarriesItsPressure) {
  const Loaded wall;
  auto model = wall.ring(64);
  const auto load = pressure_load(model, wall.p);
  const auto report = find_prestress(model, load);
  EXPECT_NEAR(report.displacement,
              wall.p * wall.inner() / (wall.plate() * std::log(wall.outer() / wall.inner())),
              0.01 * report.displacement);
  EXPECT_LT(wander(model, load, 4000), 1e-6 * wall.R);
  const auto state = rest(model);
  for (const double zeta : {-1.0, 0.0, 1.0}) {
    const double r = wall.R + 0.5 * zeta * wall.t,
                 exact = wall.p * wall.inner() / (r * std::log(wall.outer() / wall.inner()));
    const auto stress = wall_stress(model, state, 5, zeta);
    EXPECT_NEAR((stress.cauchy.trace() - stress.cauchy(2, 2)) / exact, 1.0, 0.005) << zeta;
    EXPECT_NEAR(stress.cauchy(2, 2) / exact, wall.nu, 0.005) << zeta;
  }
}

/// Mean radial displacement of the middle ring under a little more pressure.
double further_growth(const ShellModel<3>& model, int n, double pressure) {
  auto state = rest(model);
  find_equilibrium(model, state, pressure_load(model, pressure), {.tolerance = 1e-5});
  double sum = 0;
  for (int i = 0; i < n; ++i) {
    const std::size_t a = std::size_t(n / 2) * n + i;
    sum += state.displacement(a).dot(model.cloud.normal[a]) / n;
  }
  return sum;
}

// Without the stress the tube would grow by 4 % more, without the pressure on its grown area by 4 % less.
TEST(ShellPrestress, TubeStaysAndGrowsWithTheStiffnessOfTheLoadedWall) {
  const Loaded wall;
  const int n = 32;
  for (const Support ends : {Support::released, Support::clamped}) {
    auto model = wall.tube(n, ends);
    const auto load = pressure_load(model, wall.p);
    find_prestress(model, load);
    EXPECT_LT(wander(model, load, 4000), 1e-5 * wall.R) << int(ends);
    const std::size_t middle = std::size_t(n / 2) * n;
    const auto stress = wall_stress(model, rest(model), middle, 0.0);
    const Vec3 normal = model.cloud.normal[middle], around = Vec3(0, 0, 1).cross(normal);
    EXPECT_NEAR(around.dot(stress.cauchy * around) / (wall.p * wall.inner() / wall.t), 1.0, 0.01)
        << int(ends);
    const double more = 0.01 * wall.p;
    if (ends == Support::released) {
      EXPECT_NEAR(further_growth(model, n, wall.p + more) / wall.growth(more), 1.0, 0.005);
    }
  }
}

// An oval ring is bent by its pressure: without the moments of the pre-stress it would become round.
TEST(ShellPrestress, OvalRingStaysOval) {
  const Loaded wall{.t = 0.3e-3, .p = 5e3};
  auto cloud = ring(wall.R, 96, wall.t);
  for (std::size_t a = 0; a < cloud.count(); ++a) {
    const Vec2 x = cloud.position[a];
    cloud.position[a] = Vec2(1.05 * x[0], 0.95 * x[1]);
    cloud.normal[a] = Vec2(x[0] / 1.05, x[1] / 0.95).normalized();
    cloud.area[a] *= std::hypot(1.05 * x[1], 0.95 * x[0]) / wall.R;
  }
  ShellModel<2> model(cloud, wall.options(2 * pi * wall.R / 96));
  const auto load = pressure_load(model, wall.p);
  EXPECT_GT(wander(model, load, 8000), 0.05 * wall.R);
  find_prestress(model, load);
  EXPECT_LT(wander(model, load, 8000), 1e-5 * wall.R);
  EXPECT_LT(wander(model, load, 8000, 0.1), 1e-5 * wall.R);
}

/// The wall of a vessel with the modulus and the pressure of an artery is left alone with its pre-stress; it has to stay.
void vessel_stays(const Lumen<3>& lumen, const ShellWallOptions& options) {
  const Loaded wall;
  ShellModel<3> model(shell_of(lumen, options).cloud, wall.options(options.spacing));
  const auto load = pressure_load(model, wall.p);
  const double free = wander(model, load, 2000);
  find_prestress(model, load);
  EXPECT_GT(free, 0.2e-3);
  EXPECT_LT(wander(model, load, 2000), 1e-4 * free);
  EXPECT_LT(wander(model, load, 2000, 0.1), 1e-4 * free);
}

// Where a vessel divides.
TEST(ShellPrestress, BifurcationStays) {
  vessel_stays(lumen_of(generate(BifurcationShape{.parent_length = 0.014, .daughter_length = 0.028})),
               {.spacing = 1.2e-3, .fluid_spacing = 1.2e-3, .thickness = 0.7e-3});
}

TEST(FullShellPrestress, ArchOfSevenOpeningsStays) {
  vessel_stays(lumen_of(generate(ArchShape{})),
               {.spacing = 1.5e-3, .fluid_spacing = 1.5e-3, .thickness = 1.4e-3, .tightest_bend = 1.5});
}

ShellModel<3> short_tube() {
  auto model = Loaded{}.tube(20, Support::released);
  find_prestress(model, pressure_load(model, Loaded{}.p));
  return model;
}

// Turned as a whole, the wall is the same wall: stress and zigzag forces turn with it.
TEST(ShellPrestress, StressTurnsWithTheWall) {
  const auto model = short_tube();
  ShellCloud<3> cloud = model.cloud;
  cloud.support.assign(cloud.count(), Support::free);
  ShellModel<3> loose(cloud, model.options);
  loose.prestress = model.prestress;
  const Eigen::Matrix3d Q = Eigen::AngleAxisd(2.5, Vec3(0.3, -0.7, 0.5).normalized()).toRotationMatrix();
  const auto x = noise(loose, LinearShell<3>(loose));
  ShellWorkspace<3> plain(loose), turned(loose);
  auto state = rest(loose), other = state;
  for (std::size_t a = 0; a < loose.count(); ++a) {
    const Vec3 u = 0.02 * x[a].u, n = (loose.cloud.normal[a] + 0.02 * x[a].d).normalized();
    state.displacement(a, u), state.normal(a, n);
    other.displacement(a, Q * (loose.cloud.position[a] + u) - loose.cloud.position[a]);
    other.normal(a, (Q * n).normalized());
  }
  const auto load = pressure_load(loose, Loaded{}.p);
  accelerate(loose, state, load, plain);
  accelerate(loose, other, load, turned);
  double largest = 0, error = 0;
  for (std::size_t a = 0; a < loose.count(); ++a) {
    largest = std::max(largest, plain.acceleration(a).norm());
    error = std::max(error, (Q * plain.acceleration(a) - turned.acceleration(a)).norm());
  }
  EXPECT_LT(error, 1e-4 * largest);  // the weights are single
}

// The pressure goes and the ring breathes about a smaller circle: motion takes its energy from that of the stress.
TEST(ShellPrestress, EnergyIsKept) {
  const Loaded wall;
  auto options = wall.options(2 * pi * wall.R / 48);
  options.damping = 0;
  ShellModel<2> model(ring(wall.R, 48, wall.t), options);
  find_prestress(model, pressure_load(model, wall.p));
  auto state = rest(model);
  ShellWorkspace<2> work(model);
  double motion = 0, drift = 0;
  for (int k = 0; k < 200; ++k) {
    advance(model, state, no_load(model), work, {0.5 * stable_step(model), 5});
    const auto energy = energies(model, state);
    motion = std::max(motion, energy.motion), drift = std::max(drift, std::abs(energy.total()));
  }
  EXPECT_GT(motion, 0.0);
  EXPECT_LT(drift, 2e-3 * motion);
  EXPECT_LT(state.displacement(0).norm(), 0.2 * wall.R);
}

TEST(ShellPrestress, SameBitsForAnyNumberOfThreads) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = short_tube();
  omp_set_num_threads(3);
  const auto three = short_tube();
  omp_set_num_threads(before);
  const auto &a = one.prestress.blocks, &b = three.prestress.blocks;
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])), 0);
}

// In the blood's stream: the pressure of the image, then more.
TEST(ShellPrestress, WallOfAVesselStaysAtThePressureOfItsImage) {
  const Loaded wall;
  const double outside = 500;
  const auto cloud = ring(wall.R, 48, wall.t);
  std::vector<Vec2> contact;
  for (std::size_t a = 0; a < cloud.count(); ++a)
    contact.push_back(cloud.position[a] - 0.5 * wall.t * cloud.normal[a]);
  ShellModel<2> model(cloud, wall.options(2 * pi * wall.R / 48));
  find_prestress(model, pressure_load(model, wall.p));
  DeformableWall<2> vessel(std::move(model), contact, 1e-3,
                           {.outside_pressure = outside, .rest_pressure = wall.p + outside});
  auto state = vessel.rest(wall.p + outside);
  vessel.attach(state, FluidState<2>{});
  for (int k = 0; k < 20; ++k) vessel.step(state, 1e-5, wall.p + outside);
  EXPECT_LT(state.shell.displacement(0).norm(), 1e-9 * wall.R);
  for (int k = 0; k < 20; ++k) vessel.step(state, 1e-5, 1.1 * wall.p + outside);
  EXPECT_GT(state.shell.displacement(0).norm(), 1e-4 * wall.R);
}

// Half a tube with nothing at its edges flies away under pressure.
TEST(ShellPrestress, WallThatNothingHoldsIsRefused) {
  const Loaded wall;
  ShellCloud<2> half;
  const auto whole = ring(wall.R, 64, wall.t);
  for (int a = 0; a < 32; ++a) add<2>(half, whole.position[a], whole.normal[a], whole.area[a], wall.t);
  ShellModel<2> model(half, wall.options(2 * pi * wall.R / 64));
  try {
    find_prestress(model, pressure_load(model, wall.p), {.most_iterations = 3000});
    FAIL();
  } catch (const NumericsError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("Something has to hold the wall"));
  }
}

}  // namespace
}  // namespace ostium::sph3d
