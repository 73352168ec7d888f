#include "network/consistent.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"

namespace ostium::network {

Consistent::Consistent(const System& system)
    : system_(system),
      lu_(system.size(), system.pattern().outerIndexPtr(), system.pattern().innerIndexPtr()),
      d_y_(system.pattern().nonZeros()),
      d_dy_(d_y_.size()),
      matrix_(d_y_.size()),
      row_scale_(system.size()),
      residual_(system.size()) {}

void Consistent::factorise(double t, const double* y, const double* dy) {
  if (factorised_ && system_.linear()) return;
  system_.jacobian(t, y, dy, d_y_.data(), d_dy_.data());
  row_scale_.setZero();
  const int *start = system_.pattern().outerIndexPtr(), *row = system_.pattern().innerIndexPtr();
  for (int j = 0; j < system_.size(); ++j)
    for (int k = start[j]; k < start[j + 1]; ++k) {
      const double value = (system_.differential(j) ? d_dy_[k] : d_y_[k]) * system_.scale()[j];
      matrix_[k] = value;
      row_scale_[row[k]] = std::max(row_scale_[row[k]], std::abs(value));
    }
  row_scale_ = row_scale_.unaryExpr([](double r) { return r > 0 ? r : 1.0; });
  for (std::size_t k = 0; k < matrix_.size(); ++k) matrix_[k] /= row_scale_[row[k]];
  const bool good = factorised_ ? lu_.refactor(matrix_.data()) : lu_.factor(matrix_.data());
  if (!good)
    numerics_error("the network's algebraic equations cannot be solved at t = {} s: their matrix is singular",
                   t);
  factorised_ = true;
}

void Consistent::solve_scaled(Eigen::VectorXd& residual) const {
  residual.array() /= row_scale_.array();
  lu_.solve({residual.data(), static_cast<std::size_t>(residual.size())});
}

/// One Newton correction with the matrix as it is; returns its size in the unknowns' scales.
double Consistent::correct(double t, std::span<const double> port_flow, double* y, double* dy) {
  system_.residual(t, y, dy, port_flow, residual_.data());
  solve_scaled(residual_);
  for (int j = 0; j < system_.size(); ++j)
    (system_.differential(j) ? dy : y)[j] -= residual_[j] * system_.scale()[j];
  return residual_.lpNorm<Eigen::Infinity>();
}

void Consistent::solve(double t, std::span<const double> port_flow, double* y, double* dy) {
  for (int j = 0; j < system_.size(); ++j)
    if (!system_.differential(j)) dy[j] = 0;
  constexpr int most = 50;
  constexpr double small = 1e-12, fast = 0.01;  // fast: worth more than a new matrix
  factorise(t, y, dy);
  double last = INFINITY, before = INFINITY;
  for (int i = 0; i < most; ++i) {
    if (i > 1 && last > fast * before) factorise(t, y, dy);
    const double size = correct(t, port_flow, y, dy);
    if (!std::isfinite(size)) break;
    // Rates of stiff states are large against their scale: round-off then stops the decrease above `small`.
    if (size < small || (size > 0.5 * last && size < 1e-6)) return;
    before = std::exchange(last, size);
  }
  numerics_error(
      "the network finds no consistent pressures and flows at t = {} s (last correction {:.3g} of their "
      "scale)",
      t, last);
}

void Consistent::settle(double t, std::span<const double> port_flow, double* y, double* dy,
                        std::vector<int> thrown) {
  constexpr int most = 10;
  solve(t, port_flow, y, dy);
  thrown.resize(system_.switch_count(), 0);
  while (const auto worst = misplaced(t, port_flow, y, dy, thrown)) {
    if (thrown[*worst]++ > most) refuse_chatter(t, *worst);
    system_.throw_switch(*worst, y);
    solve(t, port_flow, y, dy);
  }
}

/// The switch whose guard is farthest on the wrong side, or about to go there: an event is found to within the
/// integrator's tolerance, and there the direction tells more than the sign. What has been thrown at zero stays.
std::optional<int> Consistent::misplaced(double t, std::span<const double> port_flow, const double* y,
                                         const double* dy, const std::vector<int>& thrown) {
  const int n = system_.switch_count();
  if (n == 0) return std::nullopt;
  std::vector<double> now(n), soon(n, 0.0);
  system_.guards(t, y, dy, now.data());
  const auto at_zero = [](double g) { return std::abs(g) <= guard_tolerance; };
  if (std::any_of(now.begin(), now.end(), at_zero)) soon = guards_after(moment, t, port_flow, y, dy);
  std::optional<int> worst;
  double most = 1e-13;  // less is round-off
  for (int k = 0; k < n; ++k) {
    const double g = !at_zero(now[k]) ? now[k] : thrown[k] ? 0.0 : soon[k] - now[k];
    const double wrong = system_.on(k, y) ? -g : g;
    if (wrong > most) worst = k, most = wrong;
  }
  return worst;
}

/// Guards a little later: the states go on at their rates.
std::vector<double> Consistent::guards_after(double dt, double t, std::span<const double> port_flow,
                                             const double* y, const double* dy) {
  std::vector<double> y1(y, y + system_.size()), dy1(dy, dy + system_.size()), g(system_.switch_count());
  for (int j : system_.states()) y1[j] += dt * dy[j];
  solve(t + dt, port_flow, y1.data(), dy1.data());
  system_.guards(t + dt, y1.data(), dy1.data(), g.data());
  return g;
}

void Consistent::refuse_chatter(double t, int k) const {
  numerics_error(
      "the network finds no position of its valves at t = {} s: {} is thrown back and forth; two valves "
      "without "
      "resistance may act on each other: give them one, or a small compliance to the node between them",
      t, system_.switch_name(k));
}

Eigen::VectorXd Consistent::rates(double t, std::span<const double> port_flow, const double* y,
                                  const double* dy) {
  begin();
  factorise(t, y, dy);
  system_.jacobian(t, y, dy, d_y_.data(), d_dy_.data());
  constexpr double step = 1e-6;  // s: sources are smooth between kinks
  Eigen::VectorXd now(system_.size()), then(system_.size());
  system_.residual(t, y, dy, port_flow, now.data());
  system_.residual(t + step, y, dy, port_flow, then.data());
  Eigen::VectorXd f = (then - now) / step;
  const int *start = system_.pattern().outerIndexPtr(), *row = system_.pattern().innerIndexPtr();
  for (int j : system_.differential_unknowns())
    for (int k = start[j]; k < start[j + 1]; ++k) f[row[k]] += d_y_[k] * dy[j];
  solve_scaled(f);
  Eigen::VectorXd rate = -f.cwiseProduct(system_.scale());
  for (int j : system_.differential_unknowns()) rate[j] = dy[j];
  return rate;
}

}  // namespace ostium::network
