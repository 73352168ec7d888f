#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sph3d/neighbours/order.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

std::vector<Vec3> cloud(int n) {
  std::vector<Vec3> points;
  for (int k = 0; k < n; ++k)
    points.push_back(Vec3(std::fmod(0.754877666 * k, 1.0), std::fmod(0.569840291 * k, 1.0),
                          std::fmod(0.381966011 * k, 1.0)));
  return points;
}

TEST(Order, IsAPermutationOfCompactClusters) {
  const auto points = cloud(4099);
  auto order = bisection_order<3>(points);
  double extent = 0;
  for (std::size_t c = 0; c + 8 <= order.size(); c += 8) {
    Vec3 low = points[order[c]], high = low;
    for (std::size_t k = c; k < c + 8; ++k)
      low = low.cwiseMin(points[order[k]]), high = high.cwiseMax(points[order[k]]);
    extent += (high - low).maxCoeff() / static_cast<double>(order.size() / 8);
  }
  EXPECT_LT(extent,
            3.0 * std::cbrt(8.0 / 4099));  // a cluster is about as large as the cube of eight particles
  std::sort(order.begin(), order.end());
  for (int k = 0; k < 4099; ++k) ASSERT_EQ(order[k], k);
}

TEST(RowLists, HoldExactlyTheParticlesWithinReach) {
  const FluidOptions<3> options{
      .dp = 1e-3, .density = 1000, .viscosity = 1e-6, .sound_speed = 10, .reference_speed = 1};
  Vessel<3> vessel(tube(0.004, 0.008), options, {{}, {}});
  FluidState<3> fluid = vessel.state().fluid;
  fluid.remove(11);  // an empty place among the others
  Workspace<3> work;
  freeze(vessel.model(), fluid, work);
  const double reach = vessel.model().reach();
  for (std::size_t c = 0; c < fluid.clusters.size(); ++c) {
    std::set<int> expected, found;
    for (std::size_t j = 0; j < fluid.places(); ++j) {
      if (!fluid.filled[j]) continue;
      for (std::size_t i = 8 * c; i < 8 * c + 8; ++i)
        if (fluid.filled[i] && (fluid.position[i] - fluid.position[j]).norm() < reach * (1 - 1e-6))
          expected.insert(static_cast<int>(j));
    }
    for (int n = 0; n < work.rows[c].count; ++n) found.insert(work.rows[c].begin[n]);
    for (int n = 0; n < 4; ++n) {  // what a sum may read too
      EXPECT_GE(work.rows[c].begin[work.rows[c].count + n], 0);
      EXPECT_LE(work.rows[c].begin[work.rows[c].count + n], static_cast<int>(fluid.places()));
    }
    EXPECT_TRUE(std::includes(found.begin(), found.end(), expected.begin(), expected.end()));
    EXPECT_LE(found.size(), expected.size() + 1);
  }
}

TEST(FluidState, InsertionRemovalAndOrderKeepWhatAParticleCarries) {
  FluidState<2> fluid = fluid_at<2>(std::vector<Vec2>{{0, 0}, {1, 0}, {0, 1}}, 1.0);
  const std::size_t i = fluid.insert(Vec2(5, 5));
  fluid.velocity(i, Vec2(3, 4));
  fluid.psi(i) = 0.25f;
  fluid.remove(0);
  EXPECT_EQ(fluid.count(), 3u);
  for (int k = 0; k < 20; ++k) fluid.insert(Vec2(0.1 * k, 7));
  FluidState<2> spare;
  fluid.reorder(spare);
  EXPECT_EQ(fluid.count(), 23u);
  EXPECT_EQ(fluid.places() % 8, 0u);
  int found = 0;
  for (std::size_t k = 0; k < fluid.places(); ++k)
    if (fluid.filled[k] && fluid.position[k] == Vec2(5, 5)) {
      ++found;
      EXPECT_EQ(fluid.velocity(k), Vec2(3, 4));
      EXPECT_EQ(fluid.psi(k), 0.25f);
    }
  EXPECT_EQ(found, 1);
}

}  // namespace
}  // namespace ostium::sph3d
