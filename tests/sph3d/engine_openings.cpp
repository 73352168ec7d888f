#include <gtest/gtest.h>

#include "sph3d/openings/profile.hpp"
#include "sph3d/openings/slice.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

TEST(Profile, OfACircleIsTheParabola) {
  const auto lumen = tube(0.01, 0.03, 256);
  const FlowShape<3> shape(Profile::parabolic, lumen.openings[0]);
  for (double r = 0; r < 0.0095; r += 0.001)
    EXPECT_NEAR(shape(Vec3(0, r, 0.1 * r)), 2 * (1 - 1.01 * r * r / 1e-4), 0.01) << r;
}

TEST(Profile, HasMeanOneOverAnyOutline) {
  Lumen<3> lumen = tube(0.01, 0.03, 128);
  for (auto& p : lumen.openings[0].outline)
    p[1] *= 0.5;  // an ellipse; its developed flow is known, 2 (1 - y2/b2 - z2/a2)
  lumen.openings[0].area *= 0.5;
  const FlowShape<3> shape(Profile::parabolic, lumen.openings[0]);
  EXPECT_NEAR(shape(lumen.openings[0].centre), 2.0, 0.02);
  EXPECT_NEAR(shape(Vec3(0, 0.0025, 0)), 2.0 * (1 - 0.25), 0.02);
  EXPECT_NEAR(shape(Vec3(0, 0, 0.005)), 2.0 * (1 - 0.25), 0.02);
}

TEST(Profile, PlaneParabolaAndPlug) {
  const auto lumen = channel(0.05, 0.01);
  const FlowShape<2> parabola(Profile::parabolic, lumen.openings[0]), plug(Profile::plug, lumen.openings[0]);
  EXPECT_NEAR(parabola(Vec2(0, 0.005)), 1.5, 1e-12);
  EXPECT_NEAR(parabola(Vec2(0, 0.0025)), 1.5 * 0.75, 1e-12);
  EXPECT_EQ(plug(Vec2(0, 0.001)), 1.0);
}

TEST(Slice, FillsTheOpeningEvenly) {
  const double dp = 1e-3;
  const auto lumen = tube(0.008, 0.03);
  const auto slice = slice_of(lumen.openings[1], dp);
  EXPECT_EQ(slice.sites.size(), static_cast<std::size_t>(std::lround(lumen.openings[1].area / (dp * dp))));
  EXPECT_NEAR(slice.spacing * lumen.openings[1].area, static_cast<double>(slice.sites.size()) * dp * dp * dp,
              1e-18);
  for (const auto& a : slice.sites) {
    EXPECT_LT(std::hypot(a[1], a[2]), 0.008 - 0.3 * dp);
    EXPECT_NEAR(a[0], 0.03, 1e-12);
    double nearest = 1;
    for (const auto& b : slice.sites)
      if (&a != &b) nearest = std::min(nearest, (a - b).norm());
    EXPECT_GT(nearest, 0.7 * dp);
    EXPECT_LT(nearest, 1.2 * dp);
  }
}

template <int D>
void relaxed_filling(const Lumen<D>& lumen, double bar) {
  const FluidOptions<D> options{
      .dp = 1e-3, .density = 1000, .viscosity = 1e-6, .sound_speed = 10, .reference_speed = 1};
  Vessel<D> vessel(lumen, options, {{}, {}});
  const auto& model = vessel.model();
  FluidState<D> fluid = vessel.state().fluid;
  EXPECT_NEAR(static_cast<double>(fluid.count()), model.domain.volume / model.particle_volume, 0.6);
  Workspace<D> work;
  freeze(model, fluid, work);
  find_zones(model, fluid, work);
  look_around(model, fluid, work);
  kernel_sums(model, fluid, work);
  double square = 0, largest = 0;
  int n = 0;
  for (std::size_t i = 0; i < fluid.places(); ++i) {
    if (!fluid.filled[i]) continue;
    EXPECT_LT(work.around[i / 8].filling[i % 8], 0.5);
    const double density = (work.sums[i / 8].density[i % 8] + work.around[i / 8].filling[i % 8] +
                            work.around[i / 8].open_filling[i % 8]) /
                               model.number_density -
                           1;
    square += density * density, largest = std::max(largest, std::abs(density)), ++n;
  }
  EXPECT_LT(std::sqrt(square / n), bar);
  EXPECT_LT(largest, 5 * bar);
}
TEST(Filling, IsRelaxed2d) { relaxed_filling<2>(channel(0.03, 0.01), 0.01); }
TEST(Filling, IsRelaxed3d) { relaxed_filling<3>(tube(0.0062, 0.02), 0.01); }

}  // namespace
}  // namespace ostium::sph3d
