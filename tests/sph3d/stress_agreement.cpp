// Two measures of the wall shear stress, compared over a cycle: who differs, on how much of the wall, where most.
#include "sph3d/fields/stress_agreement.hpp"

#include <gtest/gtest.h>

namespace ostium::sph3d {
namespace {

using Stresses = std::vector<Vec2>;

std::vector<WallPoint<2>> wall_of(const std::vector<double>& areas) {
  std::vector<WallPoint<2>> wall;
  for (const double area : areas)
    wall.push_back({.position = Vec2::Zero(), .normal = Vec2::UnitY(), .area = area});
  return wall;
}

Stresses along(const std::vector<double>& magnitudes) {
  Stresses stress;
  for (const double m : magnitudes) stress.push_back({m, 0.0});
  return stress;
}

TEST(StressAgreement, ShareMedianAndWorstAreByArea) {
  StressAgreement agreement;
  take<2>(agreement, 0, 0.1, along({1.0, 1.0, -1.0}), along({1.05, 0.8, -0.5}));
  take<2>(agreement, 0, 0.2, along({3.0, 3.0, -3.0}), along({3.15, 2.4, -1.5}));
  const auto d = disagreement<2>(agreement.running, wall_of({2.0, 1.0, 5.0}));
  EXPECT_DOUBLE_EQ(d.share, 6.0 / 8.0);
  EXPECT_DOUBLE_EQ(d.median, 0.5);
  EXPECT_EQ(d.worst, 2u);
  EXPECT_DOUBLE_EQ(d.forces, 2.0);
  EXPECT_DOUBLE_EQ(d.gradient, 1.0);
}

/// Where there is hardly any stress its noise is no matter.
TEST(StressAgreement, SmallStressIsComparedWithTheMean) {
  StressAgreement agreement;
  take<2>(agreement, 0, 0.1, along({1.0, 0.001}), along({1.0, 0.011}));
  EXPECT_EQ(disagreement<2>(agreement.running, wall_of({1.0, 1.0})).share, 0.0);
}

TEST(StressAgreement, ACycleEndsWhereTheNextBegins) {
  StressAgreement agreement;
  take<2>(agreement, 0, 0.1, along({1.0}), along({1.0}));
  EXPECT_EQ(agreement.whole.count, 0);
  take<2>(agreement, 0, 0.2, along({1.0}), along({1.0}));
  take<2>(agreement, 1, 0.3, along({5.0}), along({1.0}));
  EXPECT_EQ(agreement.whole.count, 2);
  EXPECT_EQ(disagreement<2>(agreement.whole, wall_of({1.0})).share, 0.0);
  EXPECT_EQ(disagreement<2>(agreement.running, wall_of({1.0})).share, 1.0);
}

TEST(StressAgreement, NothingTakenIsNoDisagreement) {
  EXPECT_EQ(disagreement<2>(StressSums(), wall_of({1.0})).share, 0.0);
}

}  // namespace
}  // namespace ostium::sph3d
