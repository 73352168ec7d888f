#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "app/results/cycles.hpp"
#include "app/results/series.hpp"

namespace ostium::app {
namespace {

TEST(Thinning, OneRowPerInterval) {
  Thinning thin(0.1);
  int rows = 0;
  for (int i = 0; i <= 1000; ++i) rows += thin.due(0.001 * i);
  EXPECT_EQ(rows, 11);
  Thinning coarse(0.1);
  EXPECT_TRUE(coarse.due(0));
  EXPECT_TRUE(coarse.due(0.35));  // intervals without a row are not made up for
  EXPECT_FALSE(coarse.due(0.39));
  EXPECT_TRUE(coarse.due(0.4));
}

TEST(CycleStatistics, MeansOfALinearFunctionAreExact) {
  CycleStatistics s(0.66);
  for (int i = 0; i <= 200; ++i)
    s.add(0.01 * i, 3 * 0.01 * i);  // 0.66 is no multiple of the sample interval times 3
  const auto cycles = s.cycles();
  ASSERT_EQ(cycles.size(), 4u);
  for (int n = 0; n < 3; ++n) {
    EXPECT_NEAR(cycles[n].mean, 3 * 0.66 * (n + 0.5), 1e-12);
    EXPECT_NEAR(cycles[n].min, 3 * 0.66 * n, 1e-12);
    EXPECT_NEAR(cycles[n].max, 3 * 0.66 * (n + 1), 1e-12);
    EXPECT_NEAR(cycles[n].duration, 0.66, 1e-12);
  }
  EXPECT_NEAR(cycles[3].duration, 0.02, 1e-12);
}

TEST(CycleStatistics, RoundingMakesNoNewCycle) {
  CycleStatistics s(0.1);
  for (int i = 0; i <= 30; ++i) s.add(0.01 * i, std::sin(20 * std::numbers::pi * 0.01 * i));
  EXPECT_EQ(s.cycles().size(), 3u);
  EXPECT_LT(s.change(), 1e-12);
}

TEST(CycleStatistics, ChangeBetweenCycles) {
  CycleStatistics s(1);
  EXPECT_EQ(s.change(), 1);
  for (int i = 0; i <= 250; ++i) s.add(0.01 * i, i < 100 ? 1 : 2);
  EXPECT_NEAR(s.change(), 0.5, 0.01);  // the third cycle was cut short and does not count
}

TEST(CycleStatistics, NoPeriodIsOneCycle) {
  CycleStatistics s;
  for (int i = 0; i <= 10; ++i) s.add(i, i);
  ASSERT_EQ(s.cycles().size(), 1u);
  EXPECT_EQ(s.cycles()[0].mean, 5);
}

}  // namespace
}  // namespace ostium::app
