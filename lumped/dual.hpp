/// Forward-mode derivative number: a value and its N partial derivatives.
///
///   x = v + sum_k d[k] e_k,   e_k e_l = 0,   f(x) = f(v) + f'(v) sum_k d[k] e_k
///
/// A block's residual written for a scalar T is run with double for its value and with Dual for its exact
/// Jacobian. Source: Griewank & Walther, Evaluating Derivatives, 2nd ed. (2008), ch. 3. Not checked: points
/// where a function has no derivative (sqrt, pow and abs at 0).
#pragma once
#include <array>
#include <cmath>

namespace ostium::lumped {

template <int N>
struct Dual {
  double v = 0;
  std::array<double, N> d{};

  Dual() = default;
  Dual(double value) : v(value) {}  // NOLINT: constants mix freely with derivatives
  static Dual variable(double value, int k) {
    Dual x(value);
    x.d[k] = 1;
    return x;
  }

  /// The chain rule: value f and derivative df of a function of this number.
  Dual chain(double f, double df) const {
    Dual r(f);
    for (int k = 0; k < N; ++k) r.d[k] = df * d[k];
    return r;
  }

  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend Dual operator-(const Dual& a) { return a.chain(-a.v, -1); }
  friend Dual operator+(const Dual& a, const Dual& b) { return join(a, b, a.v + b.v, 1, 1); }
  friend Dual operator-(const Dual& a, const Dual& b) { return join(a, b, a.v - b.v, 1, -1); }
  friend Dual operator*(const Dual& a, const Dual& b) { return join(a, b, a.v * b.v, b.v, a.v); }
  friend Dual operator/(const Dual& a, const Dual& b) {
    return join(a, b, a.v / b.v, 1 / b.v, -a.v / (b.v * b.v));
  }

  friend bool operator<(const Dual& a, const Dual& b) { return a.v < b.v; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.v > b.v; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.v <= b.v; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.v >= b.v; }

 private:
  static Dual join(const Dual& a, const Dual& b, double f, double fa, double fb) {
    Dual r(f);
    for (int k = 0; k < N; ++k) r.d[k] = fa * a.d[k] + fb * b.d[k];
    return r;
  }
};

template <int N>
Dual<N> sqrt(const Dual<N>& x) {
  const double s = std::sqrt(x.v);
  return x.chain(s, 0.5 / s);
}
template <int N>
Dual<N> exp(const Dual<N>& x) {
  const double e = std::exp(x.v);
  return x.chain(e, e);
}
template <int N>
Dual<N> log(const Dual<N>& x) {
  return x.chain(std::log(x.v), 1 / x.v);
}
template <int N>
Dual<N> sin(const Dual<N>& x) {
  return x.chain(std::sin(x.v), std::cos(x.v));
}
template <int N>
Dual<N> cos(const Dual<N>& x) {
  return x.chain(std::cos(x.v), -std::sin(x.v));
}
template <int N>
Dual<N> tanh(const Dual<N>& x) {
  const double t = std::tanh(x.v);
  return x.chain(t, 1 - t * t);
}
template <int N>
Dual<N> pow(const Dual<N>& x, double n) {
  return x.chain(std::pow(x.v, n), n * std::pow(x.v, n - 1));
}
template <int N>
Dual<N> abs(const Dual<N>& x) {
  return x.v < 0 ? -x : x;
}

}  // namespace ostium::lumped
