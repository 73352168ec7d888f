/// Random numbers without a state: each is a function of a key and of a place, so that they do not depend on the order in
/// which they are asked for, nor on the threads that ask.
///
///   Philox 4x32 with ten rounds: a bijection of four words that scrambles a counter under a key of two
///
/// Source: Salmon, Moraes, Dror & Shaw, SC'11 (2011), "Parallel random numbers: as easy as 1, 2, 3". Not for secrets.
#pragma once
#include <array>
#include <cstdint>

namespace ostium {

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key);

/// Where a number stands in a table of them.
struct Place {
  std::uint64_t row = 0;
  std::uint32_t column = 0;
};

/// Evenly in (0, 1), never 0 or 1.
double uniform(std::uint64_t seed, Place place);

/// Where the item `i` of `count` goes when they are shuffled; another shuffle for each column.
std::uint64_t shuffled(std::uint64_t seed, std::uint32_t column, std::uint64_t i, std::uint64_t count);

}  // namespace ostium
