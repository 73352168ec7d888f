/// Ratios of a run against stored ones: they survive another machine and other work beside, times do not.
///
///   {"tolerance": 0.15, "kernels": "avx2", "ratios": {NAME: VALUE, ...}}
///
/// A ratio is worse when it lies beyond its baseline by more than the tolerance, a share of the baseline; better ones are
/// not told. Ratios to the plain reference are compared only between kernels for the same instruction set.
#pragma once
#include "bench/bench.hpp"

namespace ostium::bench {

struct Ratio {
  std::string name;
  double value = 0;
  bool larger_is_better = true, of_kernels = false;
};

struct Ratios {
  std::string kernels;
  std::vector<Ratio> all = {};
};

Ratios ratios_of(const Results& results);

void write_baseline(const Ratios& ratios, const std::filesystem::path& file);

/// One sentence per ratio that is worse; one that says so where there is nothing to compare with.
std::vector<std::string> worse_than(const std::filesystem::path& baseline, const Ratios& ratios);

}  // namespace ostium::bench
