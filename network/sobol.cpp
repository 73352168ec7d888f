#include "network/sobol.hpp"

#include <cmath>

namespace ostium::network {

namespace {

/// A ratio of two means with the half width of its confidence interval.
struct Ratio {
  double sum = 0, square = 0;  // of numerator - ratio * denominator
  void add(double deviation) { sum += deviation, square += deviation * deviation; }
  double half(double n, double denominator) const {
    const double variance = (square - sum * sum / n) / (n - 1);
    return 1.96 * std::sqrt(std::max(variance, 0.0) / n) / denominator;
  }
};

/// The complete base samples and what stands in them, apart from the mean.
class Samples {
 public:
  Samples(std::int64_t count, int parameters, const std::function<double(std::int64_t)>& f)
      : width_(parameters + 2), f_(f) {
    for (std::int64_t j = 0; j < count; ++j)
      if (complete(j)) whole_.push_back(j);
    double sum = 0;
    for (const auto j : whole_) sum += f_(j * width_) + f_(j * width_ + 1);
    mean_ = sum / (2 * size());
  }
  double size() const { return static_cast<double>(whole_.size()); }
  double mean() const { return mean_; }

  /// visit(f(A), f(B), f(A_k)) for each base sample; k = -1: of none.
  template <class Visit>
  void each(int k, Visit visit) const {
    for (const auto j : whole_) {
      const auto row = j * width_;
      visit(f_(row) - mean_, f_(row + 1) - mean_, k < 0 ? 0.0 : f_(row + 2 + k) - mean_);
    }
  }

 private:
  bool complete(std::int64_t j) const {
    for (std::int64_t k = 0; k < width_; ++k)
      if (!std::isfinite(f_(j * width_ + k))) return false;
    return true;
  }

  std::int64_t width_;
  const std::function<double(std::int64_t)>& f_;
  std::vector<std::int64_t> whole_;
  double mean_ = 0;
};

SobolIndex index_of(const Samples& s, int k, double V) {
  const double n = s.size();
  double first = 0, total = 0;
  s.each(k, [&](double a, double b, double ak) {
    first += b * (ak - a);
    total += 0.5 * (a - ak) * (a - ak);
  });
  SobolIndex i{.first = first / n / V, .total = total / n / V};
  Ratio r, t;
  s.each(k, [&](double a, double b, double ak) {
    const double v = 0.5 * (a * a + b * b);
    r.add(b * (ak - a) - i.first * v);
    t.add(0.5 * (a - ak) * (a - ak) - i.total * v);
  });
  i.first_half = r.half(n, V), i.total_half = t.half(n, V);
  return i;
}

}  // namespace

Sobol sobol(std::int64_t base_samples, int parameters, const std::function<double(std::int64_t)>& f) {
  const Samples s(base_samples, parameters, f);
  Sobol all{.mean = s.mean(), .base_samples = static_cast<std::int64_t>(s.size())};
  s.each(-1, [&](double a, double b, double) { all.variance += 0.5 * (a * a + b * b); });
  all.variance /= s.size();
  const bool varies = all.variance > 1e-24 * all.mean * all.mean;  // less is round-off
  for (int k = 0; k < parameters; ++k) all.parameters.push_back(index_of(s, k, varies ? all.variance : NAN));
  return all;
}

}  // namespace ostium::network
