/// Which values the parameters take in each run of a sweep.
///
///   grid              every combination of the values of all parameters, the last parameter changing fastest
///   random            independent draws
///   latin_hypercube   of each parameter one draw from each of `count` slices of equal probability, shuffled independently
///   saltelli          for each of `count` base samples d + 2 rows, two independent draws A and B and A with its k-th value
///                     from B, k = 1 .. d; what network/sobol needs
///   table             rows given from outside
///
/// Row i is a function of i and the seed alone (core/random), whatever was asked before. Source: McKay, Beckman & Conover,
/// Technometrics 21 (1979) 239; Saltelli et al., Comput. Phys. Commun. 181 (2010) 259, sec. 3.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "network/variation.hpp"

namespace ostium::network {

enum class Sampling { grid, random, latin_hypercube, saltelli, table };

struct DesignOptions {
  Sampling sampling = Sampling::random;
  std::int64_t count = 0;  // of a table and of a grid it follows from the values
  std::uint64_t seed = 1;
  /// Of a grid all listed; of a table the values are its columns.
  std::vector<Variation> parameters;
};

class Design {
 public:
  /// Throws UserError: no parameters, one of them twice, count < 1, too many rows to count.
  explicit Design(DesignOptions options);

  std::int64_t rows() const { return rows_; }
  int columns() const { return static_cast<int>(options_.parameters.size()); }
  std::vector<Parameter> parameters() const;
  const DesignOptions& options() const { return options_; }
  /// values: one per parameter, SI.
  void row(std::int64_t i, std::span<double> values) const;

 private:
  double value(std::int64_t i, int column) const;
  double draw(std::int64_t row, int column) const;
  double from_grid(std::int64_t i, int column) const;
  double from_saltelli(std::int64_t i, int column) const;

  DesignOptions options_;
  std::int64_t rows_ = 0;
  std::vector<std::int64_t> strides_;  // of a grid: rows until the value of a column changes
};

}  // namespace ostium::network
