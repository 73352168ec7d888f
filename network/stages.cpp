#include "network/stages.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace ostium::network {

namespace {
constexpr int remembered = 2;  // stages of the step before

using Row = Eigen::Map<Eigen::ArrayXd>;
using ConstRow = Eigen::Map<const Eigen::ArrayXd>;

}  // namespace

Stages::Stages(const System& system, const Tableau& tableau)
    : system_(system),
      tableau_(tableau),
      n_(system.size()),
      values_(n_ * (tableau.stages + remembered)),
      rates_(values_.size()),
      base_(n_),
      error_(n_) {
  std::array<double, 4> c{};
  int n = 0;
  for (int node : tableau.nodes)
    if (node != tableau.probe) gap_.stage[n] = node, c[n++] = tableau.c[node];
  lagrange(c, n, tableau.c[tableau.probe], gap_.weight);
}

/// The polynomial goes through the nearest ones in the order of solution: i-1, .., 0, then the last ones of the step before.
Stages::Guess Stages::guess_from_before(int i) const {
  Guess g;
  std::array<double, 3> at{};
  const int known = last_h_ > 0 ? i + remembered : i, n = std::min(known, 3);
  for (int k = 0; k < n; ++k) {
    const int back = i - 1 - k;  // -1, -2: of the step before
    g.stage[k] = back >= 0 ? back : tableau_.stages - 1 - back;
    at[k] = back >= 0 ? tableau_.c[back] : (tableau_.c[tableau_.stages - 1 + back] - 1) * last_h_ / h_;
  }
  lagrange(at, n, tableau_.c[i], g.weight);
  return g;
}

void Stages::begin_step(double h) {
  h_ = h;
  for (int i = 1; i < tableau_.stages; ++i) guesses_[i] = guess_from_before(i);
}

void Stages::start(const double* y, const double* dy) {
  std::copy_n(y, n_, values(0));
  std::fill(rates_.begin(), rates_.end(), 0.0);
  for (int j : system_.differential_unknowns()) rates_[j] = dy[j];
  forget();
}

void Stages::shift() {
  last_h_ = h_;
  for (int k = 1; k <= remembered; ++k) {
    std::copy_n(values(tableau_.stages - 1 - k), n_, values(tableau_.stages - 1 + k));
    std::copy_n(rates(tableau_.stages - 1 - k), n_, rates(tableau_.stages - 1 + k));
  }
  std::copy_n(values(tableau_.stages - 1), n_, values(0));
  std::copy_n(rates(tableau_.stages - 1), n_, rates(0));
}

void Stages::stay() {
  std::copy_n(values(0), n_, values(tableau_.stages - 1));
  std::copy_n(rates(0), n_, rates(tableau_.stages - 1));
}

void Stages::guess(int i, double h, double hg) {
  const auto& [before, w] = guesses_[i];
  // All unknowns alike: rates of algebraic ones are zero.
  const auto row = [this](std::vector<double>& of, int k) { return Row(&of[k * n_], static_cast<int>(n_)); };
  const auto guess = [&](std::vector<double>& of) {
    row(of, i) = w[0] * row(of, before[0]) + w[1] * row(of, before[1]) + w[2] * row(of, before[2]);
  };
  guess(values_), guess(rates_);
  auto base = row(base_, 0);
  base = row(values_, 0);
  for (int k = 0; k < i; ++k)
    if (tableau_.a[i][k] != 0) base += h * tableau_.a[i][k] * row(rates_, k);
  double *y = values(i), *dy = rates(i);
  for (int j : system_.differential_unknowns()) y[j] = base_[j] + hg * dy[j];
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

double Stages::gap() const {
  const auto row = [&](int i) { return ConstRow(&values_[i * n_], static_cast<int>(n_)); };
  const auto& [of, w] = gap_;
  const auto there = w[0] * row(of[0]) + w[1] * row(of[1]) + w[2] * row(of[2]) + w[3] * row(of[3]);
  const auto here = row(tableau_.probe);
  return ((there - here).abs() / (here.abs() + system_.scale().array())).maxCoeff();
}

void Stages::interpolate(double s, double* y) const {
  const std::size_t end = (tableau_.stages - 1) * n_;
  const double a = (1 + 2 * s) * (1 - s) * (1 - s), b = s * s * (3 - 2 * s);
  const double c = h_ * s * (1 - s) * (1 - s), d = h_ * s * s * (s - 1);
  const auto row = [&](int i) { return ConstRow(&values_[i * n_], static_cast<int>(n_)); };
  const auto& of = tableau_.nodes;
  std::array<double, 4> at{}, w{};
  for (int k = 0; k < 4; ++k) at[k] = tableau_.c[of[k]];
  lagrange(at, 4, s, w);
  Row(y, static_cast<int>(n_)) =
      w[0] * row(of[0]) + w[1] * row(of[1]) + w[2] * row(of[2]) + w[3] * row(of[3]);
  for (int j : system_.differential_unknowns())
    y[j] = a * values_[j] + b * values_[end + j] + c * rates_[j] + d * rates_[end + j];
}

void Stages::guess_between(double s, double hg, double* y, double* dy) {
  interpolate(s, y);
  std::fill_n(dy, n_, 0.0);
  std::copy_n(y, n_, base_.data());
  const std::size_t end = (tableau_.stages - 1) * n_;
  const double a = 6 * s * (s - 1) / h_, c = (1 - s) * (1 - 3 * s), d = s * (3 * s - 2);
  for (int j : system_.differential_unknowns()) {
    dy[j] = a * (values_[j] - values_[end + j]) + c * rates_[j] + d * rates_[end + j];
    base_[j] -= hg * dy[j];
  }
}

}  // namespace ostium::network
