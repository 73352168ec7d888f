// The algebra of the shell: exact gradients, exact rotations, forces as derivatives of the energy.
#include <gtest/gtest.h>

#include "shell_clouds.hpp"
#include "sph3d/shell/recover.hpp"

namespace ostium::sph3d {
namespace {

ShellOptions soft(double dp, double nu = 0.3) {
  return {.spacing = dp, .density = 1000, .material = SaintVenantKirchhoff(elastic(1e6, nu)), .damping = 0.0};
}

Eigen::Matrix3d rotation(double angle) {
  return Eigen::AngleAxisd(angle, Vec3(0.3, -0.7, 0.5).normalized()).toRotationMatrix();
}

/// Displacements and rotations of a few percent, without pattern.
template <int D>
void shake(const ShellModel<D>& model, ShellState<D>& state, double size) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> value(-size, size);
  for (std::size_t a = 0; a < model.count(); ++a) {
    Vec<D> u, turn;
    for (int d = 0; d < D; ++d) u[d] = value(random) * model.options.spacing, turn[d] = value(random);
    state.displacement(a, u);
    state.normal(a, (model.cloud.normal[a] + turn).normalized());
  }
}

// Uniform strain on a cloud without order: the stress is uniform, and exact.
TEST(ShellAlgebra, PatchOfUniformStrain) {
  const ShellModel<3> model(free_plate(14, 11, 0.1, 0.02, 0.2), soft(0.1));
  auto state = rest(model);
  const double e = 0.01;
  deform<3>(
      model, state, [&](const Vec3& X) { return Vec3(X[0] * (1 + e), X[1], X[2]); },
      [](std::size_t) { return Vec3(0, 0, 1); });
  EXPECT_EQ(model.guarded, 0u);
  const double E_xx = e + 0.5 * e * e, S = 1e6 / (1 - 0.09) * E_xx,
               stretch = std::sqrt(1 - 2 * 0.3 / 0.7 * E_xx);
  for (std::size_t a = 0; a < model.count(); ++a) {
    const auto wall = wall_stress(model, state, a, 1.0);
    EXPECT_NEAR(wall.cauchy(0, 0) / (S * (1 + e) / stretch), 1.0, 1e-6);
    EXPECT_NEAR(wall.cauchy(1, 1) / (0.3 * S / (1 + e) / stretch), 1.0, 1e-6);
    EXPECT_NEAR(wall.cauchy(0, 1) / S, 0.0, 1e-6);
  }
}

// A turned shell is a shell at rest, whatever its shape and however far it is turned.
TEST(ShellAlgebra, RotationIsNoStrain) {
  ShellCloud<3> cloud = cylinder(1.0, 40, 9, 0.15, 0.1);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> shift(-0.02, 0.02);
  for (std::size_t a = 0; a < cloud.count(); ++a) {
    for (int d = 0; d < 3; ++d) cloud.position[a][d] += shift(random), cloud.normal[a][d] += shift(random);
    cloud.normal[a].normalize();
  }
  const ShellModel<3> model(cloud, soft(0.155));
  auto state = rest(model);
  const Eigen::Matrix3d R = rotation(2.5);
  deform<3>(
      model, state, [&](const Vec3& X) -> Vec3 { return R * X + Vec3(3, 1, -2); },
      [&](std::size_t a) { return R * cloud.normal[a]; });
  ShellWorkspace<3> work(model);
  accelerate(model, state, no_load(model), work);
  for (std::size_t a = 0; a < model.count(); ++a)
    EXPECT_LT(work.acceleration(a).norm(), 1e-4);  // of E / (rho dp): the weights are single
  EXPECT_LT(energies(model, state).total(), 1e-10);
}

template <int D>
void forces_are_derivatives(const ShellModel<D>& model) {
  const auto& cloud = model.cloud;
  const auto& options = model.options;
  auto state = rest(model);
  shake(model, state, 0.05);
  ShellWorkspace<D> work(model);
  const auto kept = state;
  accelerate(model, state, no_load(model), work);
  double largest_force = 0.0, largest_moment = 0.0;
  for (const auto& f : work.force)
    for (int d = 0; d < D; ++d)
      for (int l = 0; l < 8; ++l) {
        largest_force = std::max(largest_force, std::abs(f.force[d][l]));
        largest_moment = std::max(largest_moment, std::abs(f.moment[d][l]));
      }
  for (std::size_t a = 0; a < model.count(); a += 7) {
    if (cloud.support[a] == Support::clamped) continue;
    for (int d = 0; d < D; ++d) {
      const double step = 1e-5 * options.spacing;
      double energy[2];
      for (int side = 0; side < 2; ++side) {
        state = kept;
        state.displacement(a, kept.displacement(a) + (side ? step : -step) * Vec<D>::Unit(d));
        energy[side] = energies(model, state).total();
      }
      const double force = model.mass(a) * work.acceleration(a)[d];
      EXPECT_NEAR(force, -(energy[1] - energy[0]) / (2 * step), 1e-6 * largest_force * model.mass(a))
          << a << " " << d;
      const Vec<D> n = kept.normal(a), along = (Vec<D>::Unit(d) - n[d] * n).normalized();
      for (int side = 0; side < 2; ++side) {
        state = kept;
        const double angle = side ? 1e-5 : -1e-5;
        state.normal(a, std::cos(angle) * n + std::sin(angle) * along);
        energy[side] = energies(model, state).total();
      }
      double moment = 0.0;
      for (int k = 0; k < D; ++k) moment += work.force[a / 8].moment[k][a % 8] * along[k];
      const double rotary = model.mass(a) * model.gyration2(a);
      EXPECT_NEAR(rotary * moment, -(energy[1] - energy[0]) / 2e-5, 1e-6 * largest_moment * rotary)
          << a << " " << d;
    }
  }
}

template <int D>
void forces_are_derivatives(const ShellCloud<D>& cloud, const ShellOptions& options) {
  forces_are_derivatives(ShellModel<D>(cloud, options));
}

TEST(ShellAlgebra, ForcesAreDerivativesOfTheEnergy) {
  ShellOptions options = soft(0.155);
  for (const Material& material :
       {Material(SaintVenantKirchhoff(elastic(1e6, 0.3))), Material(NeoHookean(elastic(1e6, 0.45))),
        Material(holzapfel(elastic(1e6, 0.45), {.k1 = 1e6, .k2 = 2.0, .kappa = 0.1}))}) {
    options.material = material;
    auto cloud = cylinder(1.0, 40, 6, 0.15, 0.2);
    for (const Vec3& n : cloud.normal) cloud.circumference.push_back(Vec3(0, 0, 1).cross(n));
    options.fibre_angle = 0.6;
    forces_are_derivatives<3>(cloud, options);
    forces_are_derivatives<2>(ring(1.0, 40, 0.2), options);
  }
}

// Beside a clamp the hourglass weights are others.
TEST(ShellAlgebra, ForcesAreDerivativesAtAClamp) {
  auto cloud = cylinder(1.0, 40, 6, 0.15, 0.2);
  std::fill_n(cloud.support.begin(), 80, Support::clamped);
  forces_are_derivatives<3>(cloud, soft(0.155));
  auto arch = ring(1.0, 40, 0.2);
  std::fill_n(arch.support.begin(), 4, Support::clamped);
  forces_are_derivatives<2>(arch, soft(0.155));
}

/// A stress like none that a load makes, of the wall's own stiffness and without pattern.
template <int D>
ShellModel<D> stressed(const ShellCloud<D>& cloud, const ShellOptions& options) {
  ShellModel<D> model(cloud, options);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  model.prestress.blocks.resize(model.blocks());
  for (auto& block : model.prestress.blocks) {
    for (auto& traction : block.traction)
      for (double& x : traction) x = 2e4 * value(random);
    for (auto& zigzag : block.zigzag)
      for (double& x : zigzag) x = 1e6 * value(random);
  }
  return model;
}

TEST(ShellAlgebra, ForcesAreDerivativesWithStressInTheReference) {
  forces_are_derivatives(stressed(cylinder(1.0, 40, 6, 0.15, 0.2), soft(0.155)));
  forces_are_derivatives(stressed(ring(1.0, 40, 0.2), soft(0.155)));
}

// Momentum and angular momentum of inner forces.
TEST(ShellAlgebra, InnerForcesBalance) {
  const ShellModel<3> model(cylinder(1.0, 40, 6, 0.15, 0.2), soft(0.155));
  auto state = rest(model);
  shake(model, state, 0.05);
  ShellWorkspace<3> work(model);
  accelerate(model, state, no_load(model), work);
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  double size = 0.0;
  for (std::size_t a = 0; a < model.count(); ++a) {
    const Vec3 f = model.mass(a) * work.acceleration(a), x = model.cloud.position[a] + state.displacement(a);
    Vec3 m;
    for (int d = 0; d < 3; ++d)
      m[d] = model.mass(a) * model.gyration2(a) * work.force[a / 8].moment[d][a % 8];
    force += f;
    moment += x.cross(f) + state.normal(a).cross(m);
    size += f.norm();
  }
  EXPECT_LT(force.norm(), 1e-12 * size);
  EXPECT_LT(moment.norm(), 1e-10 * size);  // the weights are single
}

// A curved wall under plain radial growth: the stress through its thickness is that of a thick tube without radial stress.
TEST(ShellAlgebra, StressThroughACurvedWall) {
  const double R = 1.0, t = 0.2, grow = 0.02;
  const int n = 400;
  ShellOptions options = soft(2 * pi * R / n);
  const ShellModel<2> model(ring(R, n, t), options);
  auto state = rest(model);
  deform<2>(
      model, state, [&](const Vec2& X) { return X * (1 + grow / R); },
      [&](std::size_t a) { return model.cloud.normal[a]; });
  for (const double zeta : {-1.0, 0.0, 1.0}) {
    const double r = R + 0.5 * zeta * t, stretch = 1.0 + grow / r, E = 0.5 * (stretch * stretch - 1.0);
    const double thick = std::sqrt(1 - 2 * 0.3 / 0.7 * E), exact = 1e6 / 0.91 * E * stretch / thick;
    const auto wall = wall_stress(model, state, 0, zeta);
    EXPECT_NEAR(wall.cauchy.trace() - wall.cauchy(2, 2), exact, 2e-4 * exact) << zeta;
  }
}

}  // namespace
}  // namespace ostium::sph3d
