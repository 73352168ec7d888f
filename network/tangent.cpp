#include "network/tangent.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace ostium::network {

Nearby nearby(const System& system, const Parameter& p) {
  constexpr double step = 1e-5;  // of its size: the square of it and 1e-16 over it are both far below 1e-8
  const auto& block = system.model().entries[p.entry].block;
  if (!block->smooth_in(block->parameters()[p.number].key))
    user_error(
        "{}: {} acts through a fit, whose terms come and go as it changes; there is no sensitivity to it, "
        "compare runs "
        "with different values instead, or use a windkessel",
        system.model().entries[p.entry].where, p.name);
  const auto at = [&](double value) {
    const lumped::Change change{p.number, value};
    return block->with({&change, 1});
  };
  Nearby near{p.entry, at(p.value + step * p.size), at(p.value - step * p.size), 0.5 / step,
              p.unit == "s" ? step * p.size : 0.0};
  const auto now = block->unknowns(), above = near.above->unknowns();
  for (size_t k = 0; k < now.size(); ++k)
    if (now[k].differential != above[k].differential)
      user_error(
          "{}: {} is {:g} {}, and a change of it leaves an element of the block out or adds one; there is no "
          "sensitivity to it{}",
          system.model().entries[p.entry].where, p.name, p.value, p.unit,
          p.value == 0 ? ", give it a value > 0" : "");
  return near;
}

Tangent::Tangent(const System& system, int free, std::vector<Nearby> parameters)
    : system_(system),
      free_(free),
      parameters_(std::move(parameters)),
      d_y_(system.pattern().nonZeros()),
      d_dy_(system.pattern().nonZeros()),
      matrix_(system.pattern()),
      row_scale_(system.size()) {
  lu_.analyzePattern(matrix_);
}

Eigen::MatrixXd Tangent::start() const {
  Eigen::MatrixXd S = Eigen::MatrixXd::Zero(system_.size(), parameters_.size());
  for (size_t p = 0; p < parameters_.size(); ++p) {
    const auto& near = parameters_[p];
    const int n = near.above->unknown_count(), own = system_.own(near.entry);
    std::vector<double> above(n), below(n);
    near.above->initial(above.data()), near.below->initial(below.data());
    for (int i = 0; i < n; ++i)
      if (system_.differential(own + i)) S(own + i, p) = near.weight * (above[i] - below[i]);
  }
  return S;
}

void Tangent::factorise(double t, const double* y, const double* dy) {
  system_.jacobian(t, y, dy, d_y_.data(), d_dy_.data());
  const int *begin = matrix_.outerIndexPtr(), *row = matrix_.innerIndexPtr();
  row_scale_.setZero();
  for (int j = 0; j < system_.size(); ++j)
    for (int k = begin[j]; k < begin[j + 1]; ++k) {
      const double value = (system_.differential(j) ? d_dy_[k] : d_y_[k]) * system_.scale()[j];
      matrix_.valuePtr()[k] = value;
      row_scale_[row[k]] = std::max(row_scale_[row[k]], std::abs(value));
    }
  row_scale_ = row_scale_.unaryExpr([](double r) { return r > 0 ? r : 1.0; });
  for (int k = 0; k < matrix_.nonZeros(); ++k) matrix_.valuePtr()[k] /= row_scale_[row[k]];
  lu_.factorize(matrix_);
  if (lu_.info() != Eigen::Success)
    numerics_error("the network's sensitivities cannot be solved at t = {} s: {}", t, lu_.lastErrorMessage());
}

/// The unknowns of M, in SI.
Eigen::MatrixXd Tangent::solved(const Eigen::MatrixXd& f) const {
  const Eigen::MatrixXd scaled = f.array().colwise() / row_scale_.array();
  Eigen::MatrixXd x = lu_.solve(scaled);
  return x.array().colwise() * system_.scale().array();
}

void Tangent::piece(double a, double b) {
  double reach = 0;
  for (const auto& p : parameters_) reach = std::max(reach, 1.001 * p.reach);
  reach = std::min(reach, 0.25 * (b - a));
  inside_from_ = a + reach, inside_to_ = b - reach;
}

void Tangent::add_parameter(int p, double t, const double* y, const double* dy, double* f) const {
  const auto& near = parameters_[p];
  if (near.reach > 0) t = std::clamp(t, inside_from_, inside_to_);
  system_.add_residual(near.entry, *near.above, near.weight, t, y, dy, f);
  system_.add_residual(near.entry, *near.below, -near.weight, t, y, dy, f);
}

void Tangent::settle(double t, const double* y, const double* dy, Eigen::MatrixXd& S, Eigen::MatrixXd& dS) {
  if (count() == 0) return;
  factorise(t, y, dy);
  Eigen::MatrixXd f = Eigen::MatrixXd::Zero(system_.size(), count());
  const int *begin = matrix_.outerIndexPtr(), *row = matrix_.innerIndexPtr();
  for (int j : system_.differential_unknowns())
    for (int k = begin[j]; k < begin[j + 1]; ++k) f.row(row[k]) += d_y_[k] * S.row(j);
  for (size_t p = 0; p < parameters_.size(); ++p) add_parameter(p, t, y, dy, f.col(free_ + p).data());
  const Eigen::MatrixXd x = -solved(f);
  dS.setZero(system_.size(), count());
  for (int j = 0; j < system_.size(); ++j) (system_.differential(j) ? dS : S).row(j) = x.row(j);
}

void Tangent::residual(double t, const double* y, const double* dy, const std::vector<const double*>& s,
                       const std::vector<const double*>& ds, const std::vector<double*>& f) {
  system_.jacobian(t, y, dy, d_y_.data(), d_dy_.data());
  const int *begin = matrix_.outerIndexPtr(), *row = matrix_.innerIndexPtr();
  for (int i = 0; i < count(); ++i) {
    std::fill(f[i], f[i] + system_.size(), 0.0);
    for (int j = 0; j < system_.size(); ++j)
      for (int k = begin[j]; k < begin[j + 1]; ++k) f[i][row[k]] += d_y_[k] * s[i][j] + d_dy_[k] * ds[i][j];
    if (i >= free_) add_parameter(i - free_, t, y, dy, f[i]);
  }
}

Eigen::VectorXd Tangent::rates(double t, std::span<const double> port_flow, const double* y,
                               const double* dy) {
  factorise(t, y, dy);
  constexpr double step = 1e-6;  // s: sources are smooth between kinks
  const int n = system_.size();
  Eigen::VectorXd before(n), after(n);
  system_.residual(t - step, y, dy, port_flow, before.data());
  system_.residual(t + step, y, dy, port_flow, after.data());
  Eigen::VectorXd f = (after - before) / (2 * step);
  const int *begin = matrix_.outerIndexPtr(), *row = matrix_.innerIndexPtr();
  for (int j : system_.differential_unknowns())
    for (int k = begin[j]; k < begin[j + 1]; ++k) f[row[k]] += d_y_[k] * dy[j];
  Eigen::VectorXd rate = -solved(f);
  for (int j : system_.differential_unknowns()) rate[j] = dy[j];
  return rate;
}

double Tangent::guard(int k, double t, const Eigen::VectorXd& y, const double* dy) const {
  std::vector<double> g(system_.switch_count());
  system_.guards(t, y.data(), dy, g.data());
  return g[k];
}

Eigen::RowVectorXd Tangent::event_time(int k, double t, std::span<const double> port_flow, const double* y,
                                       const double* dy, const Eigen::MatrixXd& S) {
  const Eigen::VectorXd y0 = Eigen::Map<const Eigen::VectorXd>(y, system_.size());
  // guards are linear in the unknowns: a difference of any length is their derivative
  const auto along = [&](const Eigen::VectorXd& v, double dt) {
    const double size = v.cwiseQuotient(system_.scale()).lpNorm<Eigen::Infinity>();
    const double e = size > 0 ? 1e-2 / size : 1e-2;
    const double step = dt == 0 ? e : std::min(e, 1e-6);
    return (guard(k, t + dt * step, y0 + step * v, dy) - guard(k, t - dt * step, y0 - step * v, dy)) /
           (2 * step);
  };
  const double rate = along(rates(t, port_flow, y, dy), 1);
  constexpr double touches = 1e-9;  // 1/s
  Eigen::RowVectorXd tau = Eigen::RowVectorXd::Zero(count());
  if (std::abs(rate) < touches) return tau;
  for (int i = 0; i < count(); ++i) {
    double g = along(S.col(i), 0);
    if (i >= free_) {
      const auto& near = parameters_[i - free_];
      std::vector<double> own(system_.switch_count(), 0.0);
      system_.add_guards(near.entry, *near.above, near.weight, t, y, dy, own.data());
      system_.add_guards(near.entry, *near.below, -near.weight, t, y, dy, own.data());
      g += own[k];
    }
    tau[i] = -g / rate;
  }
  return tau;
}

}  // namespace ostium::network
