#include <Eigen/LU>
#include <array>
#include <cmath>
#include <unordered_map>

#include "core/error.hpp"
#include "network/engine.hpp"
#include "network/sparse_lu.hpp"
#include "network/state_space.hpp"

namespace ostium::network {

namespace {

constexpr int degree = 3;

using Samples = Eigen::Matrix<double, Eigen::Dynamic, degree + 1>;  // one row per state

/// Coefficients in theta of the cubic through samples at 0, 1/3, 2/3, 1, each times k!.
void cubic(const Samples& samples, Samples& c) {
  static const Eigen::Matrix4d inverse = [] {
    Eigen::Matrix4d v;
    for (int i = 0; i <= degree; ++i)
      for (int k = 0; k <= degree; ++k) v(k, i) = std::pow(i / 3.0, k);
    return Eigen::Matrix4d(v.inverse());
  }();
  c.noalias() = samples * inverse;
  c.col(2) *= 2;
  c.col(3) *= 6;
}

/// 40 bits of the length decide: steps that differ by round-off share one exponential.
double rounded(double h) {
  int exponent = 0;
  const double m = std::frexp(h, &exponent);
  return std::ldexp(std::round(std::ldexp(m, 40)), exponent - 40);
}

/// G with dx/dt = G F(t, 0, 0; Q) at x = 0: rows of M^-1, states over their scales.
Eigen::MatrixXd drive_matrix(const System& s) {
  const std::vector<double> zero(s.size(), 0.0);
  const int* start = s.pattern().outerIndexPtr();
  std::vector<double> d_y(s.pattern().nonZeros()), d_dy(d_y.size());
  s.jacobian(0, zero.data(), zero.data(), d_y.data(), d_dy.data());
  for (int j = 0; j < s.size(); ++j)
    for (int k = start[j]; k < start[j + 1]; ++k)
      d_y[k] = (s.differential(j) ? d_dy[k] : d_y[k]) * s.scale()[j];
  SparseLu lu(s.size(), start, s.pattern().innerIndexPtr());
  OSTIUM_ASSERT(lu.factor(d_y.data()), "singular matrix of {} unknowns", s.size());
  const auto& states = s.differential_unknowns();
  Eigen::MatrixXd g(states.size(), s.size());
  for (size_t i = 0; i < states.size(); ++i) {
    Eigen::VectorXd row = Eigen::VectorXd::Unit(s.size(), states[i]);
    lu.solve_transposed({row.data(), static_cast<size_t>(row.size())});
    g.row(i) = -row;
  }
  return g;
}

class ExactEngine final : public Engine {
 public:
  ExactEngine(const System& system, Consistent& consistent, double tolerance)
      : system_(system), consistent_(consistent), tolerance_(tolerance), forcing_(system.size()) {
    const std::vector<double> zero(system.size(), 0.0);
    A_ = linearise(system, 0, zero.data(), zero.data()).A;
    G_ = drive_matrix(system);
    samples_.resize(A_.rows(), Eigen::NoChange), cubic_.resize(A_.rows(), Eigen::NoChange);
  }

  void advance(double a, double b, const Flows& flows, double* y, double* dy, Rows* rows) override {
    const auto& states = system_.differential_unknowns();
    Eigen::VectorXd x(states.size());
    for (size_t i = 0; i < states.size(); ++i) x[i] = y[states[i]] / system_.scale()[states[i]];
    if (!states.empty()) step(a, b, flows, x, 0);
    for (size_t i = 0; i < states.size(); ++i) y[states[i]] = x[i] * system_.scale()[states[i]];
    flows.at(b, flow_);
    consistent_.settle(b, flow_, y, dy);
    for (; rows && rows->due(b + time_tolerance(b, b)); ++rows->next) rows->take(rows->times[rows->next], y);
  }

 private:
  void step(double a, double b, const Flows& flows, Eigen::VectorXd& x, int depth) {
    const double h = b - a;
    for (int i = 0; i <= degree; ++i) samples_.col(i) = drive(a + h * i / 3.0, flows);
    cubic(samples_, cubic_);
    if (depth < deepest && misses(a, h, flows)) {
      step(a, a + 0.5 * h, flows, x, depth + 1);
      step(a + 0.5 * h, b, flows, x, depth + 1);
      return;
    }
    const auto& phi = phi_of(h);
    end_.noalias() = phi[0] * x;
    for (int k = 0; k <= degree; ++k) end_.noalias() += h * phi[k + 1] * cubic_.col(k);
    x.swap(end_);
  }

  /// Whether the cubic is off between its samples. The places are irrational and not symmetric: a sine can hide from
  /// those that fit its period, and from the middle. Stiff states have large rates whose round-off is no miss.
  bool misses(double a, double h, const Flows& flows) {
    const auto& c = cubic_;
    for (double s : {0.1835034190722739, 0.6180339887498949}) {
      const auto& true_drive = drive(a + s * h, flows);
      fit_ = c.col(0) + s * (c.col(1) + s * (c.col(2) / 2 + s * c.col(3) / 6));
      const double allowed = tolerance_ * (1 + h * true_drive.lpNorm<Eigen::Infinity>());
      if (h * (fit_ - true_drive).lpNorm<Eigen::Infinity>() > allowed) return true;
    }
    return false;
  }

  /// dx/dt at x = 0: what sources and port flows do.
  const Eigen::VectorXd& drive(double t, const Flows& flows) {
    flows.at(t, flow_);
    system_.forcing(t, flow_, forcing_.data());
    drive_.noalias() = G_ * forcing_;
    return drive_;
  }

  const std::array<Eigen::MatrixXd, 5>& phi_of(double h) {
    constexpr size_t most = 1000;
    h = rounded(h);
    if (const auto known = phi_.find(h); known != phi_.end()) return known->second;
    if (phi_.size() >= most) phi_.clear();
    return phi_[h] = phi_functions(A_ * h);
  }

  static constexpr int deepest = 16;
  const System& system_;
  Consistent& consistent_;
  double tolerance_;  // of the states' scales
  Eigen::MatrixXd A_, G_;
  Eigen::VectorXd forcing_, drive_, fit_, end_;  // kept for their memory, as the samples
  Samples samples_, cubic_;
  std::vector<double> flow_;
  std::unordered_map<double, std::array<Eigen::MatrixXd, 5>> phi_;
};

}  // namespace

std::unique_ptr<Engine> make_exact_engine(const System& system, Consistent& consistent, double tolerance) {
  return std::make_unique<ExactEngine>(system, consistent, tolerance);
}

}  // namespace ostium::network
