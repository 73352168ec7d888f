// The blood between its particles: exact for linear fields, of second order for others.
#include "sph3d/fields/blood_probe.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

constexpr double density = 1000, sound_speed = 10, stiffness = density * sound_speed * sound_speed;

template <int D>
Vessel<D> filled(const Lumen<D>& lumen, double dp) {
  return Vessel<D>(
      lumen,
      {.dp = dp, .density = density, .viscosity = 1e-5, .sound_speed = sound_speed, .reference_speed = 1},
      {{true, Profile::parabolic}, {}});
}

template <int D>
using ScalarField = std::function<double(const Vec<D>&)>;

/// Particles stay where they are; along every axis they move with the same field.
template <int D>
void give(Vessel<D>& vessel, const ScalarField<D>& velocity, const ScalarField<D>& pressure) {
  auto state = vessel.save();
  for (std::size_t i = 0; i < state.fluid.places(); ++i) {
    if (!state.fluid.filled[i]) continue;
    const Vec<D>& x = state.fluid.position[i];
    state.fluid.velocity(i, velocity(x) * Vec<D>::Ones());
    state.fluid.psi(i) = static_cast<float>(pressure(x) / stiffness);
  }
  vessel.load(state);
}

constexpr double length = 0.016, width = 0.010, dp = 1e-3;

template <int D>
void finds_linear_fields(const Lumen<D>& lumen, const std::vector<Vec<D>>& places) {
  auto vessel = filled(lumen, dp);
  PressureDatum datum;
  datum.reference = 12000;
  vessel.start_datum(datum);
  const Vec<D> along = Vec<D>::LinSpaced(40, 90);
  const auto velocity = [&](const Vec<D>& x) { return 0.3 + along.dot(x); };
  const auto pressure = [&](const Vec<D>& x) { return 700 - 2e4 * x[0] + 5e4 * x[1]; };
  give<D>(vessel, velocity, pressure);
  for (const Vec<D>& x : places) {
    const auto blood = blood_at(vessel, x);
    ASSERT_TRUE(blood) << x.transpose();
    for (int d = 0; d < D; ++d) EXPECT_NEAR(blood->velocity[d], velocity(x), 1e-6) << x.transpose();
    EXPECT_NEAR(blood->pressure, 12000 + pressure(x), 1e-3) << x.transpose();
  }
}

TEST(BloodProbe, LinearFieldsAreExact2d) {
  finds_linear_fields<2>(channel(length, width), {{0.5 * length, 0.5 * width},
                                                  {0.4032 * length, 0.1717 * width},
                                                  {0.3 * length, 0.03 * width},   // before the first layer
                                                  {0.7 * length, width},          // on the wall
                                                  {0.999 * length, 0.5 * width},  // at the cap
                                                  {0.001 * length, 0.99 * width}});
}
TEST(BloodProbe, LinearFieldsAreExact3d) {
  finds_linear_fields<3>(tube(0.005, length), {{0.5 * length, 0, 0},
                                               {0.37 * length, 0.0021, -0.0017},
                                               {0.5 * length, 0.0048, 0},
                                               {0.98 * length, 0, -0.0049}});
}

double largest_error(double spacing) {
  auto vessel = filled(channel(length, width), spacing);
  const auto field = [](const Vec2& x) { return std::sin(400 * x[0]) * std::cos(300 * x[1]); };
  give<2>(vessel, field, [&](const Vec2& x) { return 100 * field(x); });
  double worst = 0;
  for (double x = 0.003; x < length - 0.003; x += 0.37e-3)
    for (double y = 0; y <= width; y += 0.41e-3) {
      const auto blood = blood_at<2>(vessel, {x, y});
      worst = std::max({worst, std::abs(blood->velocity[0] - field({x, y})),
                        std::abs(blood->pressure / 100 - field({x, y}))});
    }
  return worst;
}

TEST(BloodProbe, SmoothFieldsConvergeInTheSecondOrder) {
  const double coarse = largest_error(1e-3), fine = largest_error(0.5e-3);
  EXPECT_LT(coarse, 0.1);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
}

TEST(BloodProbe, NothingWhereNoBloodIs) {
  const auto vessel = filled(channel(length, width), dp);
  EXPECT_FALSE(blood_at<2>(vessel, {0.5 * length, -1.5 * dp}));
  EXPECT_FALSE(blood_at<2>(vessel, {0.5 * length, 10 * width}));
}

}  // namespace
}  // namespace ostium::sph3d
