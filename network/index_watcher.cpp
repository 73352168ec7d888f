#include <cmath>

#include "core/error.hpp"
#include "network/indices.hpp"

namespace ostium::network {

using Row = Eigen::RowVectorXd;

IndexWatcher::IndexWatcher(const std::vector<Index>& indices, int directions) {
  const auto watch = [&](int unknown) {
    for (const auto& s : series_)
      if (s.unknown == unknown) return;
    const Row zero = Row::Zero(directions);
    Series& s = series_.emplace_back();
    s.unknown = unknown, s.integral = {0, zero}, s.max = {-INFINITY, zero}, s.min = {INFINITY, zero};
    s.before_s = zero;
  };
  for (const auto& i : indices) {
    watch(i.series);
    if (i.kind == Index::Kind::flow_split) watch(i.of);
  }
}

void IndexWatcher::step(Interpolant& trajectory, double a, double b, bool fresh,
                        const std::optional<Row>& tau) {
  integrate(trajectory, a, b);
  for (auto& s : series_) {
    if (fresh)
      corner(s, trajectory, a, tau);
    else
      offer(s, s.before_value, s.before_s);
    extremes(s, trajectory, a, b);
  }
  duration_ += b - a;
  begun_ = true;
}

void IndexWatcher::integrate(Interpolant& trajectory, double a, double b) {
  constexpr double place = 0.7745966692414834;  // sqrt(3/5)
  constexpr double where[] = {-place, 0, place}, weight[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  for (int g = 0; g < 3; ++g) {
    const double t = 0.5 * (a + b) + 0.5 * (b - a) * where[g];
    const auto& y = trajectory.y(t, 0);
    const auto& S = trajectory.S(t);
    for (auto& s : series_) {
      s.integral.value += weight[g] * (b - a) * y[s.unknown];
      s.integral.gradient += weight[g] * (b - a) * S.row(s.unknown);
    }
  }
}

void IndexWatcher::offer(Series& s, double value, const Row& gradient) {
  if (value > s.max.value) s.max = {value, gradient};
  if (value < s.min.value) s.min = {value, gradient};
}

/// Where a stop lies between two steps: the value before and behind it, each along its own side of the moving corner.
void IndexWatcher::corner(Series& s, Interpolant& trajectory, double t, const std::optional<Row>& tau) {
  const double value = trajectory.y(t, 0)[s.unknown], rate = trajectory.y(t, 1)[s.unknown];
  const Row S = trajectory.S(t).row(s.unknown);
  if (!begun_) return offer(s, value, S);
  Row moves = Row::Zero(S.size());
  if (tau) moves = *tau;
  const double bend = s.before_rate - rate;
  if (!tau && s.before_rate * rate < 0) moves = (S - s.before_s) / bend;
  offer(s, s.before_value, s.before_s + s.before_rate * moves);
  offer(s, value, S + rate * moves);
}

void IndexWatcher::extremes(Series& s, Interpolant& trajectory, double a, double b) {
  const auto rate = [&](double t) { return trajectory.y(t, 1)[s.unknown]; };
  const double start = rate(a), end = rate(b);
  if (start * end < 0) {
    double low = a, high = b;
    for (int i = 0; i < 60 && high - low > 1e-15 * (std::abs(a) + std::abs(b)); ++i) {
      const double middle = 0.5 * (low + high);
      (rate(middle) * start > 0 ? low : high) = middle;
    }
    const double value = trajectory.y(low, 0)[s.unknown];
    offer(s, value, trajectory.S(low).row(s.unknown));
  }
  s.before_value = trajectory.y(b, 0)[s.unknown], s.before_rate = end;
  s.before_s = trajectory.S(b).row(s.unknown);
}

const IndexWatcher::Series& IndexWatcher::of(int unknown) const {
  for (const auto& s : series_)
    if (s.unknown == unknown) return s;
  OSTIUM_ASSERT(false, "the unknown {} is not watched", unknown);
}

Graded IndexWatcher::value(const Index& index) const {
  Series s = of(index.series);
  offer(s, s.before_value, s.before_s);
  const Graded mean{s.integral.value / duration_, s.integral.gradient / duration_};
  switch (index.kind) {
    case Index::Kind::mean:
      return mean;
    case Index::Kind::max:
      return s.max;
    case Index::Kind::min:
      return s.min;
    case Index::Kind::pulse:
      return {s.max.value - s.min.value, s.max.gradient - s.min.gradient};
    case Index::Kind::stroke_volume:
      if (!index.of_volume) return s.integral;
      return {s.max.value - s.min.value, s.max.gradient - s.min.gradient};
    case Index::Kind::ejection_fraction: {
      const double left = s.min.value / s.max.value;
      return {1 - left, (left * s.max.gradient - s.min.gradient) / s.max.value};
    }
    case Index::Kind::flow_split: {
      const auto& whole = of(index.of).integral;
      const double share = s.integral.value / whole.value;
      return {share, (s.integral.gradient - share * whole.gradient) / whole.value};
    }
  }
  return {};
}

}  // namespace ostium::network
