#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "network/stage_solver.hpp"

namespace ostium::network {

namespace {

class NewtonStages final : public StageSolver {
 public:
  NewtonStages(const System& system, double relative_tolerance)
      : system_(system),
        tolerance_(relative_tolerance),
        lu_(system.size(), system.pattern().outerIndexPtr(), system.pattern().innerIndexPtr()),
        d_y_(system.pattern().nonZeros()),
        d_dy_(d_y_.size()),
        matrix_(d_y_.size()),
        f_(system.size()) {}

  void forget() override { known_ = false; }
  void changed() override { slow_ = true; }

  bool begin_step(double t, const double* y, const double* dy, double hg) override {
    constexpr double alike = 0.1;  // change of hg that only slows the iteration down
    t_ = t, y_ = y, dy_ = dy, hg_ = hg, fresh_ = false, rate_ = 1;
    if (known_ && !slow_ && std::abs(hg - factored_hg_) < alike * factored_hg_) return true;
    return renew();
  }

  bool renew() override {
    if (fresh_) return false;
    system_.jacobian(t_, y_, dy_, d_y_.data(), d_dy_.data());
    const int* start = system_.pattern().outerIndexPtr();
    for (int j = 0; j < system_.size(); ++j)
      for (int k = start[j]; k < start[j + 1]; ++k)
        matrix_[k] = (d_y_[k] + d_dy_[k] / hg_) * system_.scale()[j];
    const bool good = known_ ? lu_.refactor(matrix_.data()) : lu_.factor(matrix_.data());
    known_ = good, fresh_ = true, slow_ = false, factored_hg_ = hg_, rate_ = 1;
    return good;
  }

  bool solve(double t, std::span<const double> port_flow, const double* base, double* y, double* dy,
             double looser) override {
    (void)base;  // in the guess
    double last = 0;
    for (int i = 0; i < most_iterations; ++i) {
      const double size = correct(t, port_flow, y, dy);
      if (!std::isfinite(size)) return false;
      if (i > 0) {
        const double theta = size / last;
        if (theta > 0.9 && size > enough) return false;
        slow_ = slow_ || theta > 0.2;
        rate_ = theta < 0.5 ? std::max(theta / (1 - theta), least_rate) : 1;
      }
      if (rate_ * size < enough * looser) return true;
      last = size;
    }
    return false;
  }

  void damp(double* error) override {
    std::fill(f_.begin(), f_.end(), 0.0);
    const int *start = system_.pattern().outerIndexPtr(), *row = system_.pattern().innerIndexPtr();
    for (int j : system_.states())
      for (int k = start[j]; k < start[j + 1]; ++k) f_[row[k]] += d_dy_[k] * error[j] / factored_hg_;
    lu_.solve(f_);
    for (int j : system_.states()) error[j] = f_[j] * system_.scale()[j];
  }

 private:
  /// One correction; returns its largest part over the tolerance.
  double correct(double t, std::span<const double> port_flow, double* y, double* dy) {
    system_.residual(t, y, dy, port_flow, f_.data());
    lu_.solve(f_);
    const auto scale = system_.scale().array();
    Eigen::Map<Eigen::ArrayXd> change(f_.data(), system_.size()), values(y, system_.size());
    change *= scale;
    values -= change;
    for (int j : system_.differential_unknowns()) dy[j] -= change[j] / hg_;
    const double size = (change.abs() / (values.abs() + scale)).maxCoeff<Eigen::PropagateNaN>();
    return size / tolerance_;
  }

  static constexpr int most_iterations = 8;
  static constexpr double enough = 0.05;      // of the tolerance of a step
  static constexpr double least_rate = 1e-4;  // trusted from one stage of a step to the next

  const System& system_;
  double tolerance_;
  SparseLu lu_;
  std::vector<double> d_y_, d_dy_, matrix_, f_;
  double t_ = 0, hg_ = 0, factored_hg_ = 0, rate_ = 1;
  const double *y_ = nullptr, *dy_ = nullptr;
  bool known_ = false, fresh_ = false, slow_ = false;
};

}  // namespace

std::unique_ptr<StageSolver> make_newton_stages(const System& system, double relative_tolerance) {
  return std::make_unique<NewtonStages>(system, relative_tolerance);
}

}  // namespace ostium::network
