#include "core/random.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

namespace ostium {
namespace {

/// The vectors that come with the authors' own library.
TEST(Random, PhiloxAsPublished) {
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

/// Mean, variance and the correlation of neighbours of n numbers, each within four standard errors.
TEST(Random, UniformInTheUnitInterval) {
  const int n = 100000;
  for (const bool along_rows : {true, false}) {
    double sum = 0, squares = 0, products = 0, last = 0.5;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double u = along_rows ? uniform(7, {i, 3}) : uniform(7, {3, i});
      ASSERT_GT(u, 0);
      ASSERT_LT(u, 1);
      sum += u, squares += (u - 0.5) * (u - 0.5), products += (u - 0.5) * (last - 0.5), last = u;
    }
    EXPECT_NEAR(sum / n, 0.5, 4 * std::sqrt(1 / 12.0 / n));
    EXPECT_NEAR(squares / n, 1 / 12.0, 4 * std::sqrt(1 / 180.0 / n));
    EXPECT_NEAR(products / n, 0, 4 / 12.0 / std::sqrt(n));
  }
  EXPECT_NE(uniform(7, {3, 3}), uniform(8, {3, 3}));
}

TEST(Random, ShuffledIsAPermutation) {
  for (const std::uint64_t n : {1, 2, 3, 5, 16, 17, 1000, 4097}) {
    std::vector<int> seen(n, 0);
    for (std::uint64_t i = 0; i < n; ++i) {
      const auto to = shuffled(1, 0, i, n);
      ASSERT_LT(to, n);
      ++seen[to];
    }
    EXPECT_THAT(seen, testing::Each(1)) << n;
  }
}

/// Items that stay, and neighbours that stay neighbours: about one of each, whatever the number.
TEST(Random, ShuffledForgetsTheOrder) {
  const std::uint64_t n = 4096;
  for (std::uint32_t column = 0; column < 4; ++column) {
    int stay = 0, follow = 0, as_column_4 = 0;
    for (std::uint64_t i = 0; i + 1 < n; ++i) {
      const auto to = shuffled(1, column, i, n);
      stay += to == i, follow += shuffled(1, column, i + 1, n) == to + 1;
      as_column_4 += to == shuffled(1, 4, i, n);
    }
    EXPECT_LT(stay, 8);
    EXPECT_LT(follow, 8);
    EXPECT_LT(as_column_4, 8);
  }
}

}  // namespace
}  // namespace ostium
