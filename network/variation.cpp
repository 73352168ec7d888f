#include "network/variation.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace ostium::network {

namespace {

using Law = Variation::Law;

double normal_distribution(double x) { return 0.5 * std::erfc(-x * M_SQRT1_2); }

void check_range(const Variation& v) {
  const auto& p = v.parameter;
  if (!(v.low < v.high))
    user_error("{}: low is {:g} and high {:g} {}; low must be below high", p.name, v.low, v.high, p.unit);
  if (v.law == Law::log_uniform && !(v.low > 0))
    user_error(
        "{}: low is {:g} {}, and a logarithmic scale needs low > 0; raise it, or choose `scale: linear`",
        p.name, v.low, p.unit);
  if (std::isfinite(v.low)) check_value(p, v.low);
  if (std::isfinite(v.high)) check_value(p, v.high);
}

void check_normal(const Variation& v) {
  const auto& p = v.parameter;
  if (!(v.deviation > 0))
    user_error("{}: the standard deviation is {:g} {}; it must be > 0", p.name, v.deviation, p.unit);
  const double a = (v.low - v.mean) / v.deviation, b = (v.high - v.mean) / v.deviation;
  if (normal_distribution(b) - normal_distribution(a) < 1e-6)
    user_error(
        "{}: between low {:g} and high {:g} {} lies next to nothing of a normal distribution with mean {:g} "
        "and "
        "standard deviation {:g}; widen the bounds or move the mean",
        p.name, v.low, v.high, p.unit, v.mean, v.deviation);
}

}  // namespace

double normal_quantile(double u) {
  const double tail = std::min(u, 1 - u), t = std::sqrt(-2 * std::log(tail));
  double x =
      t - (2.515517 + t * (0.802853 + t * 0.010328)) / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
  for (int i = 0; i < 3; ++i) {  // on the upper side, where erfc keeps its digits
    const double density = std::exp(-0.5 * x * x) / std::sqrt(2 * M_PI);
    const double e = (tail - 0.5 * std::erfc(x * M_SQRT1_2)) / density;
    x -= e / (1 + 0.5 * x * e);
  }
  return u < 0.5 ? -x : x;
}

double Variation::at(double u) const {
  switch (law) {
    case Law::uniform:
      return low + u * (high - low);
    case Law::log_uniform:
      return std::clamp(low * std::pow(high / low, u), low, high);
    case Law::normal: {
      const double a = normal_distribution((low - mean) / deviation),
                   b = normal_distribution((high - mean) / deviation);
      return std::clamp(mean + deviation * normal_quantile(a + u * (b - a)), low, high);
    }
    case Law::listed:
      return values[std::min(static_cast<std::size_t>(u * static_cast<double>(values.size())),
                             values.size() - 1)];
  }
  return 0;
}

void check(const Variation& v) {
  if (v.law == Law::listed) {
    if (v.values.empty()) user_error("{}: the list of values is empty", v.parameter.name);
    for (const double x : v.values) check_value(v.parameter, x);
    return;
  }
  check_range(v);
  if (v.law == Law::normal) check_normal(v);
}

std::vector<double> evenly(const Variation& v, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) {
    const double u = static_cast<double>(i) / (count - 1);
    all.push_back(i == 0 ? v.low : i == count - 1 ? v.high : v.at(u));
  }
  return all;
}

}  // namespace ostium::network
