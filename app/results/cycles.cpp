#include "app/results/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ostium::app {

void CycleStatistics::piece(long cycle, double t0, double x0, double t1, double x1) {
  constexpr double inf = std::numeric_limits<double>::infinity();
  if (cycle >= static_cast<long>(cycles_.size())) cycles_.resize(cycle + 1, {0, inf, -inf, 0});
  Cycle& c = cycles_[cycle];
  c.integral += (t1 - t0) * (x0 + x1) / 2;
  c.duration += t1 - t0;
  c.min = std::min({c.min, x0, x1}), c.max = std::max({c.max, x0, x1});
}

long CycleStatistics::cycle_at(double time) const {
  return period_ > 0 ? static_cast<long>(std::floor((time + 1e-9 * period_) / period_)) : 0;
}

void CycleStatistics::add(double time, double value) {
  if (!started_) {
    started_ = true;
    time_ = time, value_ = value;
    return;
  }
  if (time <= turn_) {
    piece(cycle_, time_, value_, time, value);
    time_ = time, value_ = value;
    return;
  }
  const double slope = (value - value_) / (time - time_), tiny = 1e-9 * period_;
  while (time_ < time) {
    const long cycle = cycle_at(time_);
    double end = period_ > 0 ? std::min(time, (cycle + 1) * period_) : time;
    if (time - end < tiny) end = time;  // a rounding error is no new cycle
    const double x = end == time ? value : value_ + slope * (end - time_);
    piece(cycle, time_, value_, end, x);
    time_ = end, value_ = x;
  }
  cycle_ = cycle_at(time_);
  turn_ = period_ > 0 ? static_cast<double>(cycle_ + 1) * period_ : std::numeric_limits<double>::infinity();
}

std::vector<CycleValues> CycleStatistics::cycles() const {
  std::vector<CycleValues> all;
  for (const auto& c : cycles_)
    if (c.duration > 0) all.push_back({c.integral / c.duration, c.min, c.max, c.duration});
  return all;
}

void CycleStatistics::archive(Archive& a) {
  a("period", period_);
  a("time", time_);
  a("value", value_);
  a("started", started_);
  a.records<double>("cycles", cycles_);
}

double CycleStatistics::change() const {
  auto all = cycles();
  if (!all.empty() && all.back().duration < period_ * (1 - 1e-6)) all.pop_back();
  if (period_ <= 0 || all.size() < 2) return 1;
  const auto &last = all.back(), &before = all[all.size() - 2];
  const double scale = std::max(last.max - last.min, std::abs(last.mean));
  return scale > 0 ? std::abs(last.mean - before.mean) / scale : 0;
}

}  // namespace ostium::app
