#include "lumped/activation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "core/vec.hpp"

namespace ostium::lumped {

namespace {

using Form = Activation::Form;

/// Harmonics 1 to 24 of the normalised elastance of human ventricles: cos, sin.
constexpr double ventricular_mean = 0.283748803;
constexpr std::array<std::array<double, 2>, 24> ventricular{{
    {0.031830626, 0.374299825},  {-0.209472400, 0.018127770},  {0.020520047, -0.073971113},
    {0.008316883, 0.047249597},  {-0.041677660, -0.003212163}, {0.000867323, -0.019441411},
    {-0.001675379, 0.005565534}, {-0.011252277, -0.003401432}, {-0.000414677, -0.008376795},
    {0.000253749, 0.000071880},  {-0.002584966, -0.001566861}, {0.000584752, -0.003143555},
    {0.000028502, 0.000024787},  {0.000022961, 0.000007476},   {0.000018735, 0.000001281},
    {0.000015573, -0.000001781}, {0.000013133, -0.000003494},  {0.000011199, -0.000004507},
    {0.000009634, -0.000005117}, {0.000008343, -0.000005481},  {0.000007265, -0.000005687},
    {0.000006354, -0.000005789}, {0.000005575, -0.000005821},  {0.000004903, -0.000005805},
}};

/// t - start, brought into [0, T).
double since(double t, double start, double T) {
  const double s = t - start - T * std::floor((t - start) / T);
  return std::clamp(s, 0.0, T);  // round-off
}

/// Sum of the harmonics by the recurrence of cos(n x) and sin(n x).
double harmonics(double mean, const std::vector<double>& a, const std::vector<double>& b, double x) {
  const double c = std::cos(x), s = std::sin(x);
  double sum = mean, cn = c, sn = s;
  for (size_t n = 0; n < std::max(a.size(), b.size()); ++n) {
    sum += (n < a.size() ? a[n] * cn : 0) + (n < b.size() ? b[n] * sn : 0);
    const double next = cn * c - sn * s;
    sn = sn * c + cn * s;
    cn = next;
  }
  return sum;
}

/// Largest value of f on [0, T]: the best of many samples, refined by golden sections around it.
template <class F>
double maximum(F f, double T) {
  constexpr int n = 2000;
  constexpr double golden = 0.6180339887498949;
  int best = 0;
  for (int i = 1; i <= n; ++i)
    if (f(T * i / n) > f(T * best / n)) best = i;
  double a = T * std::max(best - 1, 0) / n, b = T * std::min(best + 1, n) / n;
  for (int i = 0; i < 60; ++i) {
    const double left = b - golden * (b - a), right = a + golden * (b - a);
    (f(left) < f(right) ? a : b) = f(left) < f(right) ? left : right;
  }
  return f(0.5 * (a + b));
}

double raised_cosine(double s, double duration) {
  return s < duration ? 0.5 * (1 - std::cos(2 * pi * s / duration)) : 0.0;
}

double hill(const Activation& a, double s) {
  if (s <= 0) return 0;
  const double g1 = std::pow(s / *a.tau_1, *a.m1), g2 = std::pow(s / *a.tau_2, *a.m2);
  return (std::isinf(g1) ? 1 : g1 / (1 + g1)) / (1 + g2);
}

double piecewise(const Activation& a, double t) {
  const double T = *a.period, up = since(t, *a.contract_start, T), down = since(t, *a.relax_start, T);
  if (up < *a.contract_duration) return 0.5 * (1 - std::cos(pi * up / *a.contract_duration));
  if (down < *a.relax_duration) return 0.5 * (1 + std::cos(pi * down / *a.relax_duration));
  return up < down ? 1.0 : 0.0;  // contraction came last: still contracted
}

std::vector<double> ventricular_part(int which) {
  std::vector<double> all;
  for (const auto& c : ventricular) all.push_back(c[which]);
  return all;
}

}  // namespace

Range ventricular_range() {
  const auto a = ventricular_part(0), b = ventricular_part(1);
  const auto value = [&](double x) { return harmonics(ventricular_mean, a, b, x); };
  return {-maximum([&](double x) { return -value(x); }, 2 * pi), maximum(value, 2 * pi)};
}

void Activation::prepare() {
  start_ = form == Form::wrapping_cosine ? *end - *duration : start.value_or(0);
  if (form == Form::double_hill) largest_ = maximum([this](double s) { return hill(*this, s); }, *period);
  constexpr double nothing = 1e-6;
  if (form == Form::double_hill && !(largest_ > nothing))
    user_error(
        "has a double_hill activation that never rises; \"tau_1\" and \"tau_2\" must lie within the beat");
  if (form == Form::fourier) {
    mean_ = mean.value_or(0);
    cos_ = cos.value_or(std::vector<double>{});
    sin_ = sin.value_or(std::vector<double>{});
  }
  check_values();
  if (form != Form::ventricle) return;
  const auto [low, high] = ventricular_range();
  mean_ = (ventricular_mean - low) / (high - low);
  cos_ = ventricular_part(0), sin_ = ventricular_part(1);
  for (auto* list : {&cos_, &sin_})
    for (double& c : *list) c /= high - low;
}

/// A series or a table with a slip in its unit or sign is far outside 0 to 1; an overshoot is not.
void Activation::check_values() const {
  if (form != Form::fourier && form != Form::table) return;
  const Waveform curve = form == Form::table ? *table : Waveform::fourier({mean_, cos_, sin_, *period});
  constexpr double overshoot = 0.5;
  if (curve.min() < -overshoot || curve.max() > 1 + overshoot)
    user_error("has an activation from {:g} to {:g}; it must run between 0 (at rest) and 1", curve.min(),
               curve.max());
}

double Activation::operator()(double t) const {
  switch (form) {
    case Form::half_cosine:
    case Form::wrapping_cosine:
      return raised_cosine(since(t, start_, *period), *duration);
    case Form::piecewise_cosine:
      return piecewise(*this, t);
    case Form::double_hill:
      return hill(*this, since(t, start_, *period)) / largest_;
    case Form::fourier:
    case Form::ventricle:
      return harmonics(mean_, cos_, sin_, 2 * pi * t / *period);
    case Form::table:
      return table->value(t);
  }
  return 0;
}

/// Where pieces meet, in the first beat.
std::vector<double> Activation::corners() const {
  switch (form) {
    case Form::half_cosine:
    case Form::wrapping_cosine:
      return {start_, start_ + *duration};
    case Form::piecewise_cosine:
      return {*contract_start, *contract_start + *contract_duration, *relax_start,
              *relax_start + *relax_duration};
    case Form::double_hill:
      return {start_};
    default:
      return {};
  }
}

std::vector<double> Activation::kinks(double t0, double t1) const {
  if (form == Form::table) return table->kinks(t0, t1);
  std::vector<double> all;
  for (double corner : corners()) {
    const double T = *period;
    corner = std::fmod(corner, T);  // however far away it is given, whole numbers of beats stay exact
    for (double n = std::floor((t0 - corner) / T); corner + n * T < t1; ++n)
      if (corner + n * T > t0) all.push_back(corner + n * T);
  }
  return all;
}

}  // namespace ostium::lumped
