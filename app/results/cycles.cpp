#include "app/results/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace ostium::app {

void CycleStatistics::piece(std::size_t cycle, double t0, const double* x0, double t1, const double* x1) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  const std::size_t n = last_.size(), cycles = cycle + 1;
  if (cycles > duration_.size())
    duration_.resize(cycles), integral_.resize(cycles * n), min_.resize(cycles * n, inf),
        max_.resize(cycles * n, -inf);
  duration_[cycle] += t1 - t0;
  double *integral = &integral_[cycle * n], *low = &min_[cycle * n], *high = &max_[cycle * n];
  for (std::size_t k = 0; k < n; ++k) integral[k] += (t1 - t0) * (x0[k] + x1[k]) / 2;
  for (std::size_t k = 0; k < n; ++k) low[k] = std::min(low[k], std::min(x0[k], x1[k]));
  for (std::size_t k = 0; k < n; ++k) high[k] = std::max(high[k], std::max(x0[k], x1[k]));
}

void CycleStatistics::add(double time, std::span<const double> values) {
  if (!std::exchange(started_, true)) time_ = time, last_.assign(values.begin(), values.end());
  const double tiny = 1e-9 * period_;
  std::vector<double> between;
  while (time_ < time) {
    const double cycle = period_ > 0 ? std::floor((time_ + tiny) / period_) : 0;
    double end = period_ > 0 ? std::min(time, (cycle + 1) * period_) : time;
    if (time - end < tiny) end = time;  // a rounding error is no new cycle
    const double* x = values.data();
    if (end < time) {
      between = last_;
      const double share = (end - time_) / (time - time_);
      for (std::size_t k = 0; k < between.size(); ++k) between[k] += share * (values[k] - last_[k]);
      x = between.data();
    }
    piece(static_cast<std::size_t>(cycle), time_, last_.data(), end, x);
    time_ = end;
    std::copy_n(x, last_.size(), last_.begin());
  }
}

std::vector<CycleValues> CycleStatistics::cycles(std::size_t series) const {
  std::vector<CycleValues> all;
  for (std::size_t c = 0, at = series; c < duration_.size(); ++c, at += last_.size())
    if (duration_[c] > 0) all.push_back({integral_[at] / duration_[c], min_[at], max_[at], duration_[c]});
  return all;
}

void CycleStatistics::archive(Archive& a) {
  a("period", period_);
  a("time", time_);
  a("last", last_);
  a("started", started_);
  a("duration", duration_);
  a("integral", integral_);
  a("min", min_);
  a("max", max_);
}

double CycleStatistics::change(std::size_t series) const {
  auto all = cycles(series);
  if (!all.empty() && all.back().duration < period_ * (1 - 1e-6)) all.pop_back();
  if (period_ <= 0 || all.size() < 2) return 1;
  const auto &last = all.back(), &before = all[all.size() - 2];
  const double scale = std::max(last.max - last.min, std::abs(last.mean));
  return scale > 0 ? std::abs(last.mean - before.mean) / scale : 0;
}

}  // namespace ostium::app
