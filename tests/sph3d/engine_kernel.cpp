#include <gtest/gtest.h>

#include "sph3d/walls/half_space.hpp"
#include "sph3d/walls/wall_field.hpp"

namespace ostium::sph3d {
namespace {

TEST(Kernel, LatticeSumsOfTheLiterature) {
  EXPECT_NEAR(lattice_sum(Wendland<2>{1.30}, 1.0), 1.010473, 1e-6);
  EXPECT_NEAR(lattice_sum(Wendland<3>{1.30}, 1.0), 1.009501, 1e-6);
  EXPECT_NEAR(lattice_sum(Wendland<2>{1.15}, 1.0), 1.022629, 1e-6);
  EXPECT_NEAR(lattice_sum(Wendland<3>{1.15}, 1.0), 1.021279, 1e-6);
}

TEST(Kernel, SlopeIsTheDerivativeOfTheValue) {
  const Wendland<3> kernel{0.7};
  for (double r = 0.05; r < 1.4; r += 0.1)
    EXPECT_NEAR(kernel.slope(r), (kernel.value(r + 1e-6) - kernel.value(r - 1e-6)) / 2e-6, 1e-7);
}

/// Closed forms of the half-space in 3D: w = 21/(2h) u^5 (1 - 3u/2 + 4u^2/7), S = 7/2 u^6 - 9/2 u^7 + 3/2 u^8, u = 1 - s/2h.
TEST(HalfSpace, ClosedFormsInThreeDimensions) {
  const double h = 1.3;
  const HalfSpace<3> space(Wendland<3>{h}, 1.0);
  for (double s = 0.0; s < 2.6; s += 0.13) {
    const double u = 1 - s / (2 * h);
    EXPECT_NEAR(space.flux(s), 10.5 / h * std::pow(u, 5) * (1 - 1.5 * u + 4.0 / 7.0 * u * u), 2e-4) << s;
    EXPECT_NEAR(space.filling(s), 3.5 * std::pow(u, 6) - 4.5 * std::pow(u, 7) + 1.5 * std::pow(u, 8), 2e-4)
        << s;
    EXPECT_NEAR(space.filling(-s), 1 - space.filling(s), s > 0 ? 1e-12 : 4e-4);
    EXPECT_NEAR(space.distance(space.filling(s)), s, 0.02);
  }
}

template <int D>
void moments_of_a_half_space() {
  const HalfSpace<D> space(Wendland<D>{1.3}, 1.0);
  // the whole moment of the kernel is the identity: half of it on either side of a plane through the particle
  EXPECT_NEAR(space.moment_n(0), 0.5, 1e-3);
  EXPECT_NEAR(space.moment_t(0), 0.5, 1e-3);
}
TEST(HalfSpace, MomentsInTwoDimensions) { moments_of_a_half_space<2>(); }
TEST(HalfSpace, MomentsInThreeDimensions) { moments_of_a_half_space<3>(); }

/// A linear velocity profile over a plane wall, fluid all the way to it: without the cap of the extrapolation the wall's
/// friction is eta times the shear rate. The cap at five times the particle's own velocity acts where the depth behind the
/// wall exceeds four times the distance before it and takes a tenth: int_0^(x/5) (x - 5 s) ds = x^2/10
/// of int_0^x x ds = x^2.
TEST(HalfSpace, FrictionOfALinearProfileInContinuousFluid) {
  const HalfSpace<3> space(Wendland<3>{1.3}, 1e-9);  // tiny dp: its quarter as least distance plays no part
  double stress = 0;
  const double ds = 1e-3;
  for (double s = 0.5 * ds; s < 2.6; s += ds)
    stress += (space.friction_n(s) + 2 * space.friction_t(s)) * s * ds;
  EXPECT_NEAR(stress, 0.9, 1e-3);
}

/// Layers at half a spacing from the wall and on: what a particle fluid really feels.
template <int D>
void friction_of_layers() {
  const HalfSpace<D> space(Wendland<D>{1.3}, 1.0);
  double stress = 0;
  for (const double s : {0.5, 1.5, 2.5}) stress += (space.friction_n(s) + (D - 1) * space.friction_t(s)) * s;
  EXPECT_NEAR(stress, 1.0, 0.02);
}
TEST(HalfSpace, FrictionOfALinearProfileInLayers2d) { friction_of_layers<2>(); }
TEST(HalfSpace, FrictionOfALinearProfileInLayers3d) { friction_of_layers<3>(); }

template <int D>
void plane_wall() {
  const Wendland<D> kernel{1.3};
  const HalfSpace<D> space(kernel, 1.0);
  Vec<D> n = Vec<D>::Ones();
  n[0] = 0.3;
  n.normalize();
  const WallField<D> field([&](const Vec<D>& x) { return x.dot(n); }, Vec<D>::Constant(-6),
                           Vec<D>::Constant(6), kernel, 1.0);
  for (int k = 0; k < 200; ++k) {
    Vec<D> x;
    for (int d = 0; d < D; ++d) x[d] = 3 * std::sin(1.7 * k + 2.1 * d);
    const double s = -x.dot(n);
    if (s < 0) continue;
    const auto sample = field(x);
    EXPECT_NEAR(sample.filling, space.filling(s), 1.2e-3);
    EXPECT_LT((sample.flux - n * space.flux(s)).norm(), 8e-3);
  }
}
TEST(WallField, OfAnObliquePlaneIsTheHalfSpace2d) { plane_wall<2>(); }
TEST(WallField, OfAnObliquePlaneIsTheHalfSpace3d) { plane_wall<3>(); }

/// Boxes are passed over only where nothing is felt in them, and most of those far from the wall are.
template <int D>
void passed_over() {
  const Wendland<D> kernel{1.3};
  Vec<D> n = Vec<D>::Ones();
  n[0] = 0.3;
  n.normalize();
  const WallField<D> field([&](const Vec<D>& x) { return x.dot(n); }, Vec<D>::Constant(-12),
                           Vec<D>::Constant(12), kernel, 1.0);
  int far = 0, passed = 0;
  for (int k = 0; k < 2000; ++k) {
    Vec<D> low, size;
    for (int d = 0; d < D; ++d)
      low[d] = -3 + 8 * std::sin(1.7 * k * k + 2.1 * d), size[d] = 1 + std::sin(0.9 * k + d);
    const Vec<D> high = low + size;
    const bool felt = field.felt_in(low, high);
    far += high.dot(n) < -7;  // all of n is positive
    passed += high.dot(n) < -7 && !felt;
    if (felt) continue;
    for (int m = 0; m < 20; ++m) {
      Vec<D> x = low;
      for (int d = 0; d < D; ++d) x[d] += size[d] * (0.5 + 0.5 * std::sin(5.3 * m + 1.9 * d));
      EXPECT_EQ(field(x).filling, 0.0);
    }
  }
  EXPECT_GT(far, 100);
  EXPECT_GT(passed, 0.9 * far);
}
TEST(WallField, BoxesFarFromItArePassedOver2d) { passed_over<2>(); }
TEST(WallField, BoxesFarFromItArePassedOver3d) { passed_over<3>(); }

/// At the edge of a right angle a quarter or three quarters of the support is wall.
TEST(WallField, RightAngles) {
  const Wendland<2> kernel{1.3};
  const auto inner = [](const Vec2& x) { return std::max(x[0], x[1]); };  // fluid in a quarter of the plane
  const auto outer = [](const Vec2& x) { return std::min(x[0], x[1]); };  // fluid in three quarters
  const WallField<2> corner(inner, Vec2::Constant(-6), Vec2::Constant(6), kernel, 1.0);
  const WallField<2> apex(outer, Vec2::Constant(-6), Vec2::Constant(6), kernel, 1.0);
  EXPECT_NEAR(corner(Vec2::Zero()).filling, 0.75, 0.01);
  EXPECT_NEAR(apex(Vec2::Zero()).filling, 0.25, 0.01);
}

TEST(WallField, FarFromTheWallThereIsNone) {
  const WallField<3> field([](const Vec3& x) { return x.norm() - 8; }, Vec3::Constant(-8), Vec3::Constant(8),
                           Wendland<3>{1.3}, 1.0);
  EXPECT_EQ(field(Vec3::Zero()).filling, 0.0);
  EXPECT_EQ(field(Vec3(20, 0, 0)).filling, 1.0);
}

}  // namespace
}  // namespace ostium::sph3d
