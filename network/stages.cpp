#include "network/stages.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::network {

Stages::Stages(const System& system, const Tableau& tableau)
    : system_(system),
      tableau_(tableau),
      n_(system.size()),
      values_(n_ * tableau.stages),
      rates_(n_ * tableau.stages),
      base_(n_),
      error_(n_) {
  for (int j = 0; j < system.size(); ++j)
    if (!system.differential(j)) algebraic_.push_back(j);
  for (int i = 0; i < tableau.stages; ++i) {
    std::array<int, 3> before{};
    std::array<double, 3> at{}, weight{};
    const int n = std::min(i, 3);
    for (int k = 0; k < n; ++k) before[k] = i - 1 - k, at[k] = tableau.c[before[k]];
    lagrange(at, n, tableau.c[i], weight);
    before_.push_back(before), weights_.push_back(weight);
  }
}

void Stages::start(const double* y, const double* dy) {
  std::copy_n(y, n_, values(0));
  std::fill(rates_.begin(), rates_.end(), 0.0);
  for (int j : system_.differential_unknowns()) rates_[j] = dy[j];
}

void Stages::shift() {
  std::copy_n(values(tableau_.stages - 1), n_, values(0));
  std::copy_n(rates(tableau_.stages - 1), n_, rates(0));
}

void Stages::stay() {
  std::copy_n(values(0), n_, values(tableau_.stages - 1));
  std::copy_n(rates(0), n_, rates(tableau_.stages - 1));
}

void Stages::guess(int i, double h, double hg) {
  h_ = h;
  const auto& before = before_[i];
  const auto& w = weights_[i];
  const auto known = [&](const std::vector<double>& all, int j) {
    return w[0] * all[before[0] * n_ + j] + w[1] * all[before[1] * n_ + j] + w[2] * all[before[2] * n_ + j];
  };
  double *y = values(i), *dy = rates(i);
  for (int j : system_.differential_unknowns()) {
    double sum = 0;
    for (int k = 0; k < i; ++k) sum += tableau_.a[i][k] * rates_[k * n_ + j];
    base_[j] = values_[j] + h * sum;
    dy[j] = known(rates_, j);
    y[j] = base_[j] + hg * dy[j];
  }
  for (int j : algebraic_) y[j] = known(values_, j);
}

double* Stages::error(double h) {
  for (int j : system_.states()) {
    double sum = 0;
    for (int k = 0; k < tableau_.stages; ++k) sum += tableau_.error[k] * rates_[k * n_ + j];
    error_[j] = h * sum;
  }
  return error_.data();
}

double Stages::largest(const double* error, double tolerance) const {
  const std::size_t end = (tableau_.stages - 1) * n_;
  double worst = 0;
  for (int j : system_.states()) {
    const double size = std::max(std::abs(values_[j]), std::abs(values_[end + j])) + system_.scale()[j];
    worst = std::max(worst, std::abs(error[j]) / size);
  }
  return worst / tolerance;
}

void Stages::interpolate(double s, double* y) const {
  const std::size_t end = (tableau_.stages - 1) * n_;
  const double a = (1 + 2 * s) * (1 - s) * (1 - s), b = s * s * (3 - 2 * s);
  const double c = h_ * s * (1 - s) * (1 - s), d = h_ * s * s * (s - 1);
  for (int j : system_.differential_unknowns())
    y[j] = a * values_[j] + b * values_[end + j] + c * rates_[j] + d * rates_[end + j];
  std::array<double, 4> at{}, w{};
  for (int k = 0; k < 4; ++k) at[k] = tableau_.c[tableau_.nodes[k]];
  lagrange(at, 4, s, w);
  for (int j : algebraic_) {
    y[j] = 0;
    for (int k = 0; k < 4; ++k) y[j] += w[k] * values_[tableau_.nodes[k] * n_ + j];
  }
}

}  // namespace ostium::network
