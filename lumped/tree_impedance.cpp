#include "lumped/tree_impedance.hpp"

#include <cmath>
#include <map>
#include <numbers>
#include <utility>

namespace ostium::lumped {
namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;
constexpr Complex i(0, 1);

/// J1(z)/J0(z) by its continued fraction from behind, which converges for every complex z off the real axis.
Complex bessel_ratio(Complex z) {
  Complex r = 0;
  for (int n = static_cast<int>(2 * std::abs(z)) + 40; n > 0; --n) r = 1.0 / (2.0 * n / z - r);
  return r;
}

/// One frequency of one tree; vessels of equal radius are computed once.
class AtFrequency {
 public:
  AtFrequency(const Tree& tree, double omega)
      : tree_(tree), omega_(omega), alpha_(tree.alpha()), beta_(tree.beta()) {}

  /// Of the vessel that is m times the larger and n times the smaller daughter.
  Complex at(int m, int n) {
    const double r = tree_.r_root * std::pow(alpha_, m) * std::pow(beta_, n);
    if (const auto known = known_.find({m, n}); known != known_.end()) return known->second;
    const Complex end = r < tree_.r_min ? 0.0 : 1.0 / (1.0 / at(m + 1, n) + 1.0 / at(m, n + 1));
    return known_[{m, n}] = vessel(r, end);
  }

 private:
  Complex vessel(double r, Complex end) const {
    const double l = tree_.length_ratio * r, A = pi * r * r;
    if (omega_ == 0) return 8 * pi * tree_.mu * l / (A * A) + end;
    const double stiffness = tree_.k1 * std::exp(tree_.k2 * r) + tree_.k3, C = 1.5 * A / stiffness;
    const Complex z = r * std::sqrt(omega_ * tree_.rho / tree_.mu) * std::polar(1.0, 0.75 * pi);
    const Complex F = 2.0 * bessel_ratio(z) / z;
    const Complex Y = std::sqrt(C * A * (1.0 - F) / tree_.rho), gamma = i * omega_ * l * C / Y;
    const Complex t = std::tanh(gamma);
    return (end + t / Y) / (1.0 + Y * end * t);
  }

  const Tree& tree_;
  double omega_, alpha_, beta_;
  std::map<std::pair<int, int>, Complex> known_;
};

}  // namespace

double Tree::alpha() const { return std::pow(1 + std::pow(eta, xi / 2), -1 / xi); }
double Tree::beta() const { return alpha() * std::sqrt(eta); }

std::complex<double> impedance(const Tree& tree, double omega) { return AtFrequency(tree, omega).at(0, 0); }

}  // namespace ostium::lumped
