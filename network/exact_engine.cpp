#include <Eigen/LU>
#include <cmath>

#include "network/engine.hpp"
#include "network/state_space.hpp"

namespace ostium::network {

std::vector<double> Flows::at(double t) const {
  std::vector<double> q(q0.size());
  const double w = t1 > t0 ? (t - t0) / (t1 - t0) : 1.0;
  for (size_t k = 0; k < q.size(); ++k) q[k] = (1 - w) * q0[k] + w * q1[k];
  return q;
}

namespace {

constexpr int degree = 3;

/// Coefficients in theta of the cubic through samples at 0, 1/3, 2/3, 1, each times k!.
Eigen::MatrixXd cubic(const Eigen::MatrixXd& samples) {
  static const Eigen::Matrix4d inverse = [] {
    Eigen::Matrix4d v;
    for (int i = 0; i <= degree; ++i)
      for (int k = 0; k <= degree; ++k) v(k, i) = std::pow(i / 3.0, k);
    return Eigen::Matrix4d(v.inverse());
  }();
  Eigen::MatrixXd c = samples * inverse;
  c.col(2) *= 2;
  c.col(3) *= 6;
  return c;
}

class ExactEngine final : public Engine {
 public:
  ExactEngine(const System& system, Consistent& consistent) : system_(system), consistent_(consistent) {
    const std::vector<double> zero(system.size(), 0.0);
    A_ = linearise(system, 0, zero.data(), zero.data()).A;
  }

  void advance(double a, double b, const Flows& flows, double* y, double*) override {
    const auto& states = system_.differential_unknowns();
    if (states.empty()) return;
    Eigen::VectorXd x(states.size());
    for (size_t i = 0; i < states.size(); ++i) x[i] = y[states[i]] / system_.scale()[states[i]];
    step(a, b, flows, x, 0);
    for (size_t i = 0; i < states.size(); ++i) y[states[i]] = x[i] * system_.scale()[states[i]];
  }

 private:
  void step(double a, double b, const Flows& flows, Eigen::VectorXd& x, int depth) {
    const double h = b - a;
    Eigen::MatrixXd g(x.size(), degree + 1);
    for (int i = 0; i <= degree; ++i) g.col(i) = drive(a + h * i / 3.0, flows);
    const Eigen::MatrixXd c = cubic(g);
    if (depth < deepest && misses(a, h, c, flows)) {
      step(a, a + 0.5 * h, flows, x, depth + 1);
      step(a + 0.5 * h, b, flows, x, depth + 1);
      return;
    }
    x = propagated(x, c * h, h);
  }

  /// Whether the cubic is off between its samples. The places are irrational and not symmetric: a sine can hide from
  /// those that fit its period, and from the middle. Stiff states have large rates whose round-off is no miss.
  bool misses(double a, double h, const Eigen::MatrixXd& c, const Flows& flows) {
    for (double s : {0.1835034190722739, 0.6180339887498949}) {
      const Eigen::VectorXd fit = c.col(0) + s * (c.col(1) + s * (c.col(2) / 2 + s * c.col(3) / 6));
      const Eigen::VectorXd true_drive = drive(a + s * h, flows);
      const double allowed = tolerance * (1 + h * true_drive.lpNorm<Eigen::Infinity>());
      if (h * (fit - true_drive).lpNorm<Eigen::Infinity>() > allowed) return true;
    }
    return false;
  }

  /// dx/dt at x = 0: what sources and port flows do.
  Eigen::VectorXd drive(double t, const Flows& flows) {
    std::vector<double> y(system_.size(), 0.0), dy(system_.size(), 0.0);
    consistent_.solve(t, flows.at(t), y.data(), dy.data());
    const auto& states = system_.differential_unknowns();
    Eigen::VectorXd g(states.size());
    for (size_t i = 0; i < states.size(); ++i) g[i] = dy[states[i]] / system_.scale()[states[i]];
    return g;
  }

  /// The exponential of the system joined with the chain 1, theta, theta^2/2, theta^3/6.
  Eigen::VectorXd propagated(const Eigen::VectorXd& x, const Eigen::MatrixXd& c, double h) const {
    const auto n = x.size();
    Eigen::MatrixXd joined = Eigen::MatrixXd::Zero(n + degree + 1, n + degree + 1);
    joined.topLeftCorner(n, n) = A_ * h;
    joined.topRightCorner(n, degree + 1) = c;
    for (int k = 1; k <= degree; ++k) joined(n + k, n + k - 1) = 1;
    const Eigen::MatrixXd e = matrix_exponential(joined);
    return e.topLeftCorner(n, n) * x + e.block(0, n, n, 1);
  }

  static constexpr double tolerance = 1e-12;  // of the states' scales
  static constexpr int deepest = 16;
  const System& system_;
  Consistent& consistent_;
  Eigen::MatrixXd A_;
};

}  // namespace

std::unique_ptr<Engine> make_exact_engine(const System& system, Consistent& consistent) {
  return std::make_unique<ExactEngine>(system, consistent);
}

}  // namespace ostium::network
