#include "core/random.hpp"

#include <bit>

namespace ostium {
namespace {

using Words = std::array<std::uint32_t, 4>;
using Key = std::array<std::uint32_t, 2>;

enum Purpose : std::uint32_t { numbers, shuffles };  // apart in the key: two uses never meet

Words drawn(std::uint64_t seed, Purpose purpose, std::uint64_t row, std::uint32_t column,
            std::uint32_t step) {
  const auto low = static_cast<std::uint32_t>(seed), high = static_cast<std::uint32_t>(seed >> 32);
  return philox({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(row >> 32), column,
                 step << 1 | static_cast<std::uint32_t>(purpose)},
                {low, high});
}

}  // namespace

Words philox(Words c, Key key) {
  for (int round = 0; round < 10; ++round) {
    const std::uint64_t a = std::uint64_t{0xD2511F53} * c[0], b = std::uint64_t{0xCD9E8D57} * c[2];
    c = {static_cast<std::uint32_t>(b >> 32) ^ c[1] ^ key[0], static_cast<std::uint32_t>(b),
         static_cast<std::uint32_t>(a >> 32) ^ c[3] ^ key[1], static_cast<std::uint32_t>(a)};
    key[0] += 0x9E3779B9, key[1] += 0xBB67AE85;
  }
  return c;
}

double uniform(std::uint64_t seed, Place place) {
  const Words w = drawn(seed, numbers, place.row, place.column, 0);
  const std::uint64_t bits = (std::uint64_t{w[0]} << 32 | w[1]) >> 12;  // 52, and a half: exact, below 1
  return (static_cast<double>(bits) + 0.5) * 0x1p-52;
}

/// A Feistel network on the pairs of half words that hold the numbers up to `count`; what leaves the range goes round again.
std::uint64_t shuffled(std::uint64_t seed, std::uint32_t column, std::uint64_t i, std::uint64_t count) {
  if (count < 2) return i;
  const int half = (std::bit_width(count - 1) + 1) / 2;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {
    std::uint64_t left = i >> half, right = i & mask;
    for (std::uint32_t round = 0; round < 6; ++round) {
      const std::uint64_t mixed = left ^ (drawn(seed, shuffles, right, column, round)[0] & mask);
      left = right, right = mixed;
    }
    i = left << half | right;
  } while (i >= count);
  return i;
}

}  // namespace ostium
