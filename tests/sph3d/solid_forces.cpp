// The solid's operators: exact for uniform strain, forces from one energy, momentum kept, the same for any number of threads.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <omp.h>

#include "core/error.hpp"
#include "solid_bodies.hpp"

namespace ostium::sph3d {
namespace {

using bodies::box;

const Moduli tissue = elastic(1e6, 0.45);
const Fibres<double> crossed = fibres_at_angle(Vec3(0.6, 0.8, 0), Vec3::UnitZ(), 0.7);
const std::vector<Material> laws = {SaintVenantKirchhoff(tissue), NeoHookean(tissue),
                                    holzapfel(tissue, {.k1 = 4e5, .k2 = 2.0, .kappa = 0.1})};

/// An irregular cube of side one whose stiffness and fibres vary.
template <int D>
SolidModel<D> irregular_cube(const Material& law, double damping = 0.0) {
  const double dp = D == 2 ? 0.1 : 0.2;
  auto cloud = box<D>(Vec<D>::Zero(), Vec<D>::Ones(), dp, 0.2);
  for (const auto& X : cloud.position) cloud.stiffness.push_back(1.0 + 0.5 * X[0]);
  cloud.fibres.assign(cloud.count(), crossed);
  return make_solid<D>(std::move(cloud),
                       {.material = law, .density = 1000, .spacing = dp, .damping = damping});
}

template <int D>
SolidState<D> deformed(const SolidModel<D>& m, const std::function<Vec<D>(const Vec<D>&)>& u) {
  auto state = at_rest(m);
  for (std::size_t a = 0; a < m.count(); ++a) state.displacement[a] = u(m.cloud.position[a]);
  return state;
}

/// Forces on the particles, from the kick of a step so short that nothing moves.
template <int D>
std::vector<Vec<D>> forces(const SolidModel<D>& m, SolidState<D> state, const SolidLoads<D>& loads = {}) {
  SolidWorkspace<D> work;
  const double dt = 1e-12;
  advance(m, state, loads, dt, work);
  std::vector<Vec<D>> f;
  for (std::size_t a = 0; a < m.count(); ++a) f.push_back(m.mass(a) * state.velocity[a] / dt);
  return f;
}

template <int D>
Vec<D> wave(const Vec<D>& X) {
  Vec<D> u;
  for (int d = 0; d < D; ++d) u[d] = 0.03 * std::sin(3.0 * X[(d + 1) % D] + d) + 0.02 * X[d] * X[d];
  return u;
}

template <int D>
void expect_uniform_stress() {
  Mat<D> H = Mat<D>::Zero();
  H(0, 0) = 0.01, H(0, 1) = 0.002, H(1, 1) = -0.003;
  auto m = irregular_cube<D>(laws[0]);
  m.cloud.stiffness.clear();
  const auto state = deformed<D>(m, [&](const Vec<D>& X) -> Vec<D> { return H * X; });
  const double most = von_mises(cauchy_stress(m, state, 0));
  for (std::size_t a = 0; a < m.count(); ++a) {
    const auto s = cauchy_stress(m, state, a), s0 = cauchy_stress(m, state, 0);
    EXPECT_NEAR(s.xx, s0.xx, 1e-10 * most);
    EXPECT_NEAR(s.xy, s0.xy, 1e-10 * most);
  }
  EXPECT_LT(energy(m, state).hourglass, 1e-12 * energy(m, state).strain);
}

TEST(SolidForces, UniformStrainGivesUniformStressInAnIrregularCloud) {
  expect_uniform_stress<2>();
  expect_uniform_stress<3>();
}

/// Central differences of the plain energy: checks the kernels of this processor against plain code.
template <int D>
void expect_forces_from_energy(const Material& law) {
  const auto m = irregular_cube<D>(law);
  const auto state = deformed<D>(m, wave<D>);
  const auto f = forces(m, state);
  double largest = 0.0;
  for (const auto& one : f) largest = std::max(largest, one.norm());
  for (std::size_t a = 0; a < m.count(); a += m.count() / 7)
    for (int d = 0; d < D; ++d) {
      const auto at = [&](double step) {
        auto moved = state;
        moved.displacement[a][d] += step;
        return energy(m, moved).total();
      };
      EXPECT_NEAR(f[a][d], -(at(1e-5) - at(-1e-5)) / 2e-5, 1e-6 * largest);
    }
}

TEST(SolidForces, AreTheDerivativeOfTheEnergy) {
  for (const auto& law : laws) {
    expect_forces_from_energy<2>(law);
    expect_forces_from_energy<3>(law);
  }
}

/// Neighbours that move to and fro against each other: away from edges only the springs see it. Of a particle's neighbours the
/// four along the axes move against it, those across the diagonal with it: f = - 2 alpha mu V 4 s 2 u.
TEST(SolidForces, SpringsHoldWhatTheGradientDoesNotSee) {
  const double dp = 0.05, size = 1e-5, V = dp * dp, alpha = 0.3;
  const auto push = [&](double hourglass) {
    const auto m =
        make_solid<2>(box<2>(Vec2::Zero(), Vec2::Ones(), dp),
                      {.material = laws[0], .density = 1000, .spacing = dp, .hourglass = hourglass});
    const auto sign = [&](const Vec2& X) {
      return (std::lround(X[0] / dp - 0.5) + std::lround(X[1] / dp - 0.5)) % 2 ? 1.0 : -1.0;
    };
    const auto u = deformed<2>(m, [&](const Vec2& X) -> Vec2 { return size * sign(X) * Vec2::UnitX(); });
    const auto f = forces(m, u);
    std::size_t middle = 0;
    for (std::size_t a = 0; a < m.count(); ++a)
      if ((m.cloud.position[a] - Vec2(0.525, 0.525)).norm() < 0.01) middle = a;
    return f[middle][0] * sign(m.cloud.position[middle]);
  };
  const double s = -Wendland<2>{dp}.slope(dp) / dp * V,
               expected = -2 * alpha * tissue.mu() * V * 4 * s * 2 * size;
  EXPECT_NEAR(push(0.0), 0.0, 1e-10 * std::abs(expected));
  EXPECT_NEAR(push(alpha), expected, 1e-9 * std::abs(expected));
}

TEST(SolidForces, KeepMomentumAndAngularMomentum) {
  const auto m = irregular_cube<3>(laws[1]);
  const auto state = deformed<3>(m, wave<3>);
  const auto f = forces(m, state);
  Vec3 sum = Vec3::Zero(), torque = Vec3::Zero();
  double size = 0.0;
  for (std::size_t a = 0; a < m.count(); ++a) {
    sum += f[a], torque += (m.cloud.position[a] + state.displacement[a]).cross(f[a]), size += f[a].norm();
  }
  EXPECT_LT(sum.norm(), 1e-12 * size);
  EXPECT_LT(torque.norm(), 1e-12 * size);
}

TEST(SolidForces, TurningAroundCostsNothing) {
  const auto m = irregular_cube<3>(laws[2]);
  const Eigen::Matrix3d Q = Eigen::AngleAxisd(2.0, Vec3(1, 1, 0.3).normalized()).toRotationMatrix();
  const auto turned = deformed<3>(m, [&](const Vec3& X) -> Vec3 { return Q * X - X; });
  for (const auto& f : forces(m, turned)) EXPECT_LT(f.norm(), 1e-12 * tissue.E);
}

TEST(SolidForces, PressureAllAroundPullsNowhere) {
  const auto m = irregular_cube<2>(laws[0]);
  PressurePatch<2> patch;
  patch.depth = 0.05, patch.pressure = 100.0;
  for (std::size_t a = 0; a < m.count(); ++a)
    for (int d = 0; d < 2; ++d)
      for (const double side : {-1.0, 1.0})
        if (side * (m.cloud.position[a][d] - 0.5) > 0.42)
          patch.particle.push_back(static_cast<int>(a)), patch.area.push_back(side * 0.1 * Vec2::Unit(d));
  ASSERT_EQ(patch.particle.size(), 40u);
  Vec2 sum = Vec2::Zero();
  double virial = 0.0;
  const auto f = forces(m, at_rest(m), {.patches = {patch}});
  for (std::size_t a = 0; a < m.count(); ++a) sum += f[a], virial += f[a].dot(m.cloud.position[a]);
  EXPECT_LT(sum.norm(), 1e-9);
  EXPECT_NEAR(virial, -2.0 * 100.0, 5.0);  // - D p V; what the cloud's irregular edge leaves
}

TEST(SolidForces, HeldComponentsKeepTheirVelocity) {
  auto cloud = box<2>(Vec2::Zero(), Vec2::Ones(), 0.1);
  cloud.held.assign(cloud.count(), 0);
  cloud.held[3] = hold_all, cloud.held[7] = 1;
  const auto m = make_solid<2>(cloud, {.material = laws[0], .density = 1000, .spacing = 0.1});
  auto state = deformed<2>(m, wave<2>);
  state.velocity[3] = Vec2(0.25, 0.0);
  SolidWorkspace<2> work;
  for (int k = 0; k < 10; ++k) advance(m, state, {}, 1e-4, work);
  EXPECT_EQ(state.velocity[3], Vec2(0.25, 0.0));
  EXPECT_EQ(state.velocity[7][0], 0.0);
  EXPECT_NE(state.velocity[7][1], 0.0);
}

TEST(SolidForces, SameBitsForAnyNumberOfThreads) {
  const auto run = [](int threads) {
    omp_set_num_threads(threads);
    const auto m = irregular_cube<3>(laws[2], 0.3);
    auto state = deformed<3>(m, wave<3>);
    SolidWorkspace<3> work;
    for (int k = 0; k < 20; ++k) advance(m, state, {}, stable_step(m, state, work), work);
    omp_set_num_threads(1);
    return state;
  };
  const auto one = run(1), three = run(3);
  EXPECT_EQ(one.displacement, three.displacement);
  EXPECT_EQ(one.velocity, three.velocity);
  EXPECT_EQ(one.strain, three.strain);
}

std::string refusal(const std::function<void()>& f) {
  try {
    f();
  } catch (const UserError& e) {
    return e.what();
  }
  return "nothing was refused";
}

TEST(SolidForces, RefuseBodiesThatCannotBe) {
  const auto cube = box<2>(Vec2::Zero(), Vec2::Ones(), 0.1);
  EXPECT_EQ(refusal([&] { make_solid<2>(cube, {.material = laws[0], .density = 0, .spacing = 0.1}); }),
            "The density of a solid must be positive; found 0 kg/m3.");
  EXPECT_THAT(refusal([&] { make_solid<2>(cube, {.material = laws[2], .density = 1, .spacing = 0.1}); }),
              testing::HasSubstr("needs the directions of its fibres at every particle"));
  const auto line = box<2>(Vec2::Zero(), Vec2(1, 0.1), 0.1);
  EXPECT_THAT(refusal([&] { make_solid<2>(line, {.material = laws[0], .density = 1, .spacing = 0.1}); }),
              testing::HasSubstr("too few on one side to tell how it deforms"));
}

TEST(SolidForces, BlowUpIsReportedWithPlaceAndTime) {
  const auto m = irregular_cube<2>(laws[0]);
  auto state = deformed<2>(m, wave<2>);
  SolidWorkspace<2> work;
  const auto run = [&] {
    for (int k = 0; k < 1000; ++k) advance(m, state, {}, 0.02, work);
  };
  EXPECT_THROW(run(), NumericsError);
}

}  // namespace
}  // namespace ostium::sph3d
