#include "core/waveform.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/units.hpp"

namespace ostium {
namespace {

constexpr double same_point =
    1e-6;  // two samples are one point when their distance differs from a period by less

constexpr double shortest_period = 1e-6, latest = 1e9;  // s: a whole number of periods stays an exact number
constexpr std::size_t most_harmonics = 500;

void check_length(double period) {
  if (!(period >= shortest_period) || !(period <= latest))
    user_error("the period of {} s must be from {:g} s to {:g} s", shortest(period), shortest_period, latest);
}

void check_period(const Waveform::Table& table) {
  const double span = table.times.back() - table.times.front();
  if (table.period != 0) check_length(table.period);
  if (table.period > 0 && span > table.period * (1 + same_point))
    user_error("the samples span {} s, more than the period of {} s; correct the period or cut the table",
               shortest(span), shortest(table.period));
}

/// Slope at a knot between two secants: harmonic mean, zero at an extremum (Fritsch & Butland 1984).
double monotone_slope(double h0, double d0, double h1, double d1) {
  if (d0 * d1 <= 0) return 0;
  const double a = 2 * h1 + h0, b = h1 + 2 * h0;
  return (a + b) / (a / d0 + b / d1);
}

}  // namespace

Waveform Waveform::constant(double value) {
  if (!std::isfinite(value)) user_error("a constant waveform must be finite, found {}", value);
  Waveform w;
  w.mean_ = w.min_ = w.max_ = value;
  return w;
}

void Waveform::check(const Table& table, const std::function<std::string(std::size_t)>& row) {
  const auto& [t, w, period, interpolation] = table;
  if (t.size() != w.size()) user_error("there are {} times but {} values", t.size(), w.size());
  if (t.size() < 2) user_error("a waveform needs at least two samples, found {}", t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!std::isfinite(t[i])) user_error("{}: the time {} is not a finite number", row(i), t[i]);
    if (!std::isfinite(w[i])) user_error("{}: the value {} is not a finite number", row(i), w[i]);
    if (std::abs(t[i]) > latest)
      user_error("{}: the time {} s is too far away; times lie between {:g} and {:g} s", row(i),
                 shortest(t[i]), -latest, latest);
    if (i > 0 && t[i] <= t[i - 1])
      user_error("{}: the time {} s does not come after {} s of the row before; times must increase", row(i),
                 shortest(t[i]), shortest(t[i - 1]));
  }
  check_period(table);
}

Waveform Waveform::table(Table samples) {
  check(samples, [](std::size_t i) { return fmt::format("row {}", i + 1); });
  Waveform w;
  w.form_ = Form::table;
  w.interpolation_ = samples.interpolation;
  w.period_ = samples.period;
  w.times_ = std::move(samples.times), w.values_ = std::move(samples.values);
  w.t_ = w.times_, w.w_ = w.values_;
  if (w.period_ > 0) {
    if (w.t_.size() > 2 && w.t_.back() > w.t_.front() + w.period_ * (1 - same_point))
      w.t_.pop_back(), w.w_.pop_back();
    w.t_.push_back(w.t_.front() + w.period_), w.w_.push_back(w.w_.front());
  }
  w.find_slopes();
  w.find_integrals();
  w.check_steepness();
  w.find_extremes();
  return w;
}

void Waveform::check_steepness() const {
  for (std::size_t i = 0; i + 1 < t_.size(); ++i)
    if (!std::isfinite(slope_[i]) || !std::isfinite(integral_[i + 1]))
      user_error("between {} s and {} s the value changes from {} to {}, which is no finite slope",
                 shortest(t_[i]), shortest(t_[i + 1]), shortest(w_[i]), shortest(w_[i + 1]));
}

Waveform Waveform::fourier(Fourier series) {
  if (series.period == 0) user_error("a Fourier series needs a period > 0");
  check_length(series.period);
  if (std::max(series.cos.size(), series.sin.size()) > most_harmonics)
    user_error("the Fourier series has {} harmonics, at most {} are allowed",
               std::max(series.cos.size(), series.sin.size()), most_harmonics);
  Waveform w;
  w.form_ = Form::fourier;
  w.period_ = series.period, w.mean_ = series.mean;
  w.cos_ = std::move(series.cos), w.sin_ = std::move(series.sin);
  const std::size_t n = std::max(w.cos_.size(), w.sin_.size());
  w.cos_.resize(n), w.sin_.resize(n);
  for (std::size_t k = 0; k < n; ++k)
    if (!std::isfinite(w.cos_[k]) || !std::isfinite(w.sin_[k]) || !std::isfinite(w.mean_))
      user_error("harmonic {} of the Fourier series is not finite", k + 1);
  w.find_extremes();
  return w;
}

Waveform Waveform::fourier_of(const Table& samples, int modes) {
  if (samples.period <= 0) user_error("a Fourier series needs a period");
  const Waveform w = table({samples.times, samples.values, samples.period, Interpolation::linear});
  Fourier series{w.mean_, std::vector<double>(modes), std::vector<double>(modes), w.period_};
  for (int n = 1; n <= modes; ++n) {
    const double omega = 2 * std::numbers::pi * n / w.period_, factor = 2 / (w.period_ * omega * omega);
    for (std::size_t i = 0; i + 1 < w.t_.size(); ++i) {
      series.cos[n - 1] += factor * w.slope_[i] * (std::cos(omega * w.t_[i + 1]) - std::cos(omega * w.t_[i]));
      series.sin[n - 1] += factor * w.slope_[i] * (std::sin(omega * w.t_[i + 1]) - std::sin(omega * w.t_[i]));
    }
  }
  return fourier(std::move(series));
}

/// Linear: slope of the segment right of each knot. Cubic: slope at each knot.
void Waveform::find_slopes() {
  const std::size_t n = t_.size();
  std::vector<double> h(n - 1), secant(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) h[i] = t_[i + 1] - t_[i], secant[i] = (w_[i + 1] - w_[i]) / h[i];
  slope_ = secant;
  slope_.push_back(period_ > 0 ? secant.front() : secant.back());
  if (interpolation_ == Interpolation::linear) return;
  for (std::size_t i = 1; i + 1 < n; ++i)
    slope_[i] = monotone_slope(h[i - 1], secant[i - 1], h[i], secant[i]);
  if (period_ > 0) slope_[0] = slope_[n - 1] = monotone_slope(h[n - 2], secant[n - 2], h[0], secant[0]);
}

void Waveform::find_integrals() {
  integral_.assign(t_.size(), 0);
  for (std::size_t i = 0; i + 1 < t_.size(); ++i)
    integral_[i + 1] = integral_[i] + from_left(i, t_[i + 1] - t_[i], -1);
  mean_ = integral_.back() / (t_.back() - t_.front());
}

/// Derivative of order 0 or 1, or integral (-1) from the left knot, at the distance s behind knot i.
double Waveform::from_left(std::size_t i, double s, int derivative) const {
  const double h = t_[i + 1] - t_[i], secant = (w_[i + 1] - w_[i]) / h, a = slope_[i];
  double c = 0, d = 0;  // w = w_i + a s + c s^2 + d s^3
  if (interpolation_ == Interpolation::monotone_cubic) {
    const double b = slope_[i + 1];
    c = (3 * secant - 2 * a - b) / h, d = (a + b - 2 * secant) / (h * h);
  }
  if (derivative == 1) return a + s * (2 * c + 3 * d * s);
  if (derivative == 0) return w_[i] + s * (a + s * (c + s * d));
  return s * (w_[i] + s * (a / 2 + s * (c / 3 + s * d / 4)));
}

void Waveform::find_extremes() {
  if (form_ == Form::table) {  // both interpolations stay between neighbouring samples
    min_ = *std::min_element(w_.begin(), w_.end()), max_ = *std::max_element(w_.begin(), w_.end());
    return;
  }
  min_ = max_ = value(0);
  const int n = (cos_.size() > 30 ? 8 : 64) * (1 + static_cast<int>(cos_.size()));
  double left = derivative(0);
  for (int i = 0; i < n; ++i) {
    double a = period_ * i / n, b = period_ * (i + 1) / n;
    const double right = derivative(b);
    if (left * right < 0)
      for (int k = 0; k < 60; ++k) {
        const double middle = (a + b) / 2;
        (left * derivative(middle) <= 0 ? b : a) = middle;
      }
    left = right;
    min_ = std::min(min_, value(a)), max_ = std::max(max_, value(a));
  }
}

/// t in the first period [t_0, t_0 + period) and the number of periods taken off; unchanged if not periodic.
double Waveform::fold(double t, double& periods) const {
  periods = 0;
  if (period_ <= 0) return t;
  const double start = t_.empty() ? 0 : t_.front();
  periods = std::floor((t - start) / period_);
  return std::clamp(t - periods * period_, start, start + period_);
}

std::size_t Waveform::segment(double u) const {
  const auto i = std::upper_bound(t_.begin(), t_.end(), u) - t_.begin();
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(i - 1, 0, static_cast<std::ptrdiff_t>(t_.size()) - 2));
}

double Waveform::value(double t) const {
  double periods;
  const double u = fold(t, periods);
  if (form_ == Form::table) {
    const double inside = std::clamp(u, t_.front(), t_.back());
    const std::size_t i = segment(inside);
    return from_left(i, inside - t_[i], 0);
  }
  double sum = mean_;
  for (std::size_t k = 0; k < cos_.size(); ++k) {
    const double phase = 2 * std::numbers::pi * static_cast<double>(k + 1) * u / period_;
    sum += cos_[k] * std::cos(phase) + sin_[k] * std::sin(phase);
  }
  return sum;
}

double Waveform::derivative(double t) const {
  double periods, sum = 0;
  const double u = fold(t, periods);
  if (form_ == Form::table) {
    if (u < t_.front() || u >= t_.back() + (period_ > 0)) return 0;
    const std::size_t i = segment(u);
    return from_left(i, u - t_[i], 1);
  }
  for (std::size_t k = 0; k < cos_.size(); ++k) {
    const double omega = 2 * std::numbers::pi * static_cast<double>(k + 1) / period_;
    sum += omega * (sin_[k] * std::cos(omega * u) - cos_[k] * std::sin(omega * u));
  }
  return sum;
}

/// From the first knot of a table, from t = 0 otherwise.
double Waveform::antiderivative(double t) const {
  double periods;
  const double u = fold(t, periods);
  if (form_ == Form::table) {
    if (u < t_.front()) return (u - t_.front()) * w_.front();
    const double whole = integral_.back(), inside = std::min(u, t_.back());
    const std::size_t i = segment(inside);
    return periods * whole + integral_[i] + from_left(i, inside - t_[i], -1) + (u - inside) * w_.back();
  }
  double sum = mean_ * t;
  for (std::size_t k = 0; k < cos_.size(); ++k) {
    const double omega = 2 * std::numbers::pi * static_cast<double>(k + 1) / period_;
    sum += (cos_[k] * std::sin(omega * u) + sin_[k] * (1 - std::cos(omega * u))) / omega;
  }
  return sum;
}

double Waveform::integral(double t0, double t1) const { return antiderivative(t1) - antiderivative(t0); }
double Waveform::mean() const { return mean_; }
double Waveform::min() const { return min_; }
double Waveform::max() const { return max_; }

std::vector<double> Waveform::kinks(double t0, double t1) const {
  std::vector<double> all;
  if (form_ != Form::table) return all;
  const bool linear = interpolation_ == Interpolation::linear, periodic = period_ > 0;
  const std::size_t last = t_.size() - 1;
  const auto jumps = [&](std::size_t i) {
    if (periodic) return linear && slope_[i] != slope_[i == 0 ? last - 1 : i - 1];
    const double left = i == 0 ? 0 : linear ? slope_[i - 1] : slope_[i];
    return left != (i == last ? 0 : slope_[i]);
  };
  const double first = periodic ? std::floor((t0 - t_.front()) / period_) : 0;
  for (double n = first;; ++n) {
    for (std::size_t i = 0; i < last + !periodic; ++i)
      if (const double t = t_[i] + n * period_; t > t0 && t < t1 && jumps(i)) all.push_back(t);
    if (!periodic || t_.front() + (n + 1) * period_ >= t1) return all;
  }
}

Waveform Waveform::scaled(double factor) const {
  if (form_ == Form::constant) return constant(factor * mean_);
  auto times = [factor](std::vector<double> v) {
    for (double& x : v) x *= factor;
    return v;
  };
  if (form_ == Form::fourier) return fourier({factor * mean_, times(cos_), times(sin_), period_});
  return table({times_, times(values_), period_, interpolation_});
}

Waveform Waveform::delayed(double delay) const {
  if (form_ == Form::constant || delay == 0) return *this;
  if (form_ == Form::table) {
    Table later{times_, values_, period_, interpolation_};
    for (double& t : later.times) t += delay;
    return table(std::move(later));
  }
  Fourier later = series();
  for (std::size_t k = 0; k < cos_.size(); ++k) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(k + 1) * delay / period_;
    later.cos[k] = cos_[k] * std::cos(angle) - sin_[k] * std::sin(angle);
    later.sin[k] = cos_[k] * std::sin(angle) + sin_[k] * std::cos(angle);
  }
  return fourier(std::move(later));
}

}  // namespace ostium
