/// How a parameter varies in a sweep: its distribution, as a function of a number u in (0, 1).
///
///   uniform       low + u (high - low)
///   log_uniform   low (high/low)^u
///   normal        mean + deviation Phi^-1(u), cut at low and high where they are given: u goes from Phi(low) to Phi(high)
///   listed        one of some values, each as often as the others
///
///   low, high, mean, deviation, values    SI;   Phi   distribution function of the standard normal distribution
///
/// Not checked: that different parameters vary independently of each other, which all designs assume.
#pragma once
#include <limits>
#include <vector>

#include "network/parameters.hpp"

namespace ostium::network {

struct Variation {
  enum class Law { uniform, log_uniform, normal, listed };
  Parameter parameter;
  Law law = Law::uniform;
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  double mean = 0, deviation = 0;
  std::vector<double> values = {};

  double at(double u) const;
};

/// Throws UserError: low not below high, a logarithm of what is not positive, values that the block does not allow.
void check(const Variation& variation);

/// `count` values from low to high, evenly or by equal factors (uniform, log_uniform).
std::vector<double> evenly(const Variation& variation, int count);

/// Phi^-1(u), right to round-off. Source: Abramowitz & Stegun 1964, 26.2.23, then Halley's iteration.
double normal_quantile(double u);

}  // namespace ostium::network
