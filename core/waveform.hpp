/// A scalar function of time: constant, table or Fourier series, periodic or not.
///
///   constant   w(t) = v
///   table      through (t_i, w_i), linear (default: nothing between two samples that the samples do not say)
///   or
///              monotone cubic (Fritsch & Carlson 1980: smooth, no overshoot beyond the samples)
///   Fourier    w(t) = mean + sum_n cos_n cos(n w0 t) + sin_n sin(n w0 t),  w0 = 2 pi / period
///
///   t        s     time; a periodic waveform repeats with `period`, another one holds its end values
///   w        SI    value; the sign is the caller's convention
///   period   s     0: not periodic
///
/// A periodic table spans at most one period; between its last sample and the first one of the next period it
/// goes on interpolating, and two samples one period apart are one point (the first counts). Refused besides what is
/// no waveform: a period under a microsecond, times beyond a thousand million seconds, samples so near each other that
/// the slope between them is no number, more than 500 harmonics. Not checked: that a table resolves its signal.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace ostium {

enum class Interpolation { linear, monotone_cubic };

class Waveform {
 public:
  struct Table {
    std::vector<double> times, values;
    double period = 0;
    Interpolation interpolation = Interpolation::linear;
  };
  struct Fourier {
    double mean = 0;
    std::vector<double> cos, sin;  // harmonics 1, 2, ...
    double period = 0;
  };
  enum class Form { constant, table, fourier };

  Waveform() = default;  // zero
  static Waveform constant(double value);
  static Waveform table(Table samples);     // throws UserError
  static Waveform fourier(Fourier series);  // throws UserError
  /// Throws UserError when the times do not increase or a sample is not finite; `row` names the i-th sample
  /// (from 0).
  static void check(const Table& samples, const std::function<std::string(std::size_t)>& row);
  /// The first `modes` harmonics of a periodic piecewise linear table, by exact integrals.
  static Waveform fourier_of(const Table& samples, int modes);

  double value(double t) const;
  double operator()(double t) const { return value(t); }
  double derivative(double t) const;  // at a kink: from the right
  double integral(double t0, double t1) const;
  double mean() const;  // over a period; over the samples' span if not periodic
  double min() const;
  double max() const;
  double period() const { return period_; }
  bool is_constant() const { return form_ == Form::constant; }
  Form form() const { return form_; }
  Interpolation interpolation() const { return interpolation_; }

  /// Times in (t0, t1) where the derivative jumps, increasing: where a time integrator should stop.
  std::vector<double> kinks(double t0, double t1) const;

  /// factor * w(t), for example a flow from a mean velocity and an area.
  Waveform scaled(double factor) const;
  /// w(t - delay)
  Waveform delayed(double delay) const;

  const std::vector<double>& times() const { return times_; }
  const std::vector<double>& values() const { return values_; }
  Fourier series() const { return {mean_, cos_, sin_, period_}; }

  bool operator==(const Waveform&) const = default;

 private:
  double fold(double t, double& periods) const;
  std::size_t segment(double u) const;
  double from_left(std::size_t i, double s, int derivative) const;
  double antiderivative(double t) const;
  void check_steepness() const;
  void find_slopes();
  void find_integrals();
  void find_extremes();

  Form form_ = Form::constant;
  Interpolation interpolation_ = Interpolation::linear;
  double period_ = 0, mean_ = 0, min_ = 0, max_ = 0;
  std::vector<double> times_, values_;  // as given
  std::vector<double> t_, w_, slope_,
      integral_;  // knots, closed over the period; integral from the first knot
  std::vector<double> cos_, sin_;
};

}  // namespace ostium
