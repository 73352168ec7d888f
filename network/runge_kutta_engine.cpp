#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"
#include "network/stage_solver.hpp"
#include "network/stages.hpp"

namespace ostium::network {

namespace {

/// 40 bits of the length decide: steps that differ by round-off share one matrix.
double rounded(double x) {
  int exponent = 0;
  const double m = std::frexp(x, &exponent);
  return std::ldexp(std::round(std::ldexp(m, 40)), exponent - 40);
}

class RungeKuttaEngine final : public Engine {
 public:
  RungeKuttaEngine(const System& system, Consistent& consistent, double relative_tolerance, long most_steps)
      : system_(system),
        consistent_(consistent),
        tolerance_(relative_tolerance),
        most_steps_(most_steps),
        third_(system, third_order()),
        fourth_(system, fourth_order()),
        stages_(relative_tolerance > finest_of_third ? &third_ : &fourth_),
        share_(stages_ == &fourth_ ? std::pow(relative_tolerance, 1.0 / 3 - 1.0 / 4) : 1),
        solver_(system.linear() ? make_linear_stages(system)
                                : make_newton_stages(system, relative_tolerance)),
        guard_(system.switch_count()),
        row_(system.size()),
        row_rates_(system.size()) {}

  void begin(double step) override {
    step_ = step;
    solver_->forget();
  }
  double step() const override { return step_; }
  bool dense() const override { return true; }

  void advance(double a, double b, const Flows& flows, double* y, double* dy, Rows* rows) override {
    flows_ = &flows;
    const bool low = share_ < 1 && b - a <= share_ * step_;
    if (share_ < 1) stages_ = low ? &third_ : &fourth_;
    stages_->start(y, dy);
    if (step_ <= 0) step_ = first_step(b - a);
    if (low) step_ *= share_;
    for (double t = a; t < b; t = go(t, b, rows)) {
    }
    if (low) step_ /= share_;
    hand_out(rows, b, [&](double) { return stages_->begin_values(); });
    std::copy_n(stages_->begin_values(), system_.size(), y);
    std::copy_n(stages_->begin_rates(), system_.size(), dy);
  }

 private:
  const Tableau& tableau() const { return stages_->tableau(); }

  /// One accepted step, with the event at its end where there is one; returns the time reached.
  double go(double t, double b, Rows* rows) {
    const double h = accepted_step(t, b);
    int event = none;
    const double end_h = system_.switch_count() ? until_event(t, h, event) : h;
    const double end = end_h == h && last_ ? b : t + end_h;
    if (rows && rows->due(end)) hand_out_between(*rows, t, end_h, end);
    stages_->shift();
    if (++steps_ == most_steps_) refuse_more(end);
    if (event != none) throw_switch(end, event, b);
    return end;
  }

  template <class Values>
  static void hand_out(Rows* rows, double until, Values values) {
    for (; rows && rows->due(until); ++rows->next)
      rows->take(rows->times[rows->next], values(rows->times[rows->next]));
  }

  /// Rows up to the end of a step. Where an algebraic unknown changes faster than the states that govern the length of steps
  /// (a pressure that is prescribed) interpolation misses it, and each row is solved for as one more stage.
  void hand_out_between(Rows& rows, double t, double h, double end) {
    const bool solved = stages_->gap() > looser_between * tolerance_;
    hand_out(&rows, end, [&](double at) {
      const double s = (at - t) / h;
      if (!solved || !solve_between(t, h, s)) stages_->interpolate(s, row_.data());
      return row_.data();
    });
  }

  bool solve_between(double t, double h, double s) {
    const double at = t + s * h;
    flows_->at(at, flow_);
    stages_->guess_between(s, rounded(tableau().gamma * h), row_.data(), row_rates_.data());
    return solver_->solve(at, flow_, stages_->base(), row_.data(), row_rates_.data(), looser_between);
  }

  /// Tries steps until the error of one is small enough; sets the length of the next. Returns its length.
  double accepted_step(double t, double b) {
    for (int failures = 0;; ++failures) {
      const double h = fitted(t, b);
      if (!(t + h > t) || failures > most_failures) give_up(t);
      if (!attempt(t, h)) {
        step_ = h * 0.25;
        if (failures == resettled_after) resettle(t, b);
        continue;
      }
      double* const errors = stages_->error(h);
      solver_->damp(errors);
      const double error = stages_->largest(errors, tolerance_);
      const double factor = std::clamp(0.9 * std::pow(error + 1e-12, -1.0 / tableau().order), 0.2, 5.0);
      if (error <= 1) {
        const bool cut = h < step_;
        step_ = cut ? std::max(step_ * std::min(factor, 1.0), h * factor)
                    : h * (failures ? std::min(factor, 1.0) : factor);
        return h;
      }
      step_ = h * factor;
    }
  }

  /// Where an equation turns within less than a step (a steep smooth valve) the end of a step may satisfy it only to within
  /// the iteration's tolerance, and from there no step is small enough; from consistent values it is.
  void resettle(double t, double b) {
    flows_->at(t, flow_);
    consistent_.settle(t, flow_, stages_->begin_values(), stages_->begin_rates());
    solver_->changed(), stages_->forget();
    step_ = first_step(b - t);
  }

  /// The wanted length, or what fits a whole number of times: between kinks at equal distances steps of one length return,
  /// and the matrix with them.
  double fitted(double t, double b) {
    const double left = b - t;
    const double steps = std::ceil(left / (step_ * (1 + 1e-6)));
    last_ = steps <= 1;
    return last_ ? left : left / steps;
  }

  bool attempt(double t, double h) {
    const double hg = rounded(tableau().gamma * h);
    if (!solver_->begin_step(t + 0.5 * h, stages_->begin_values(), stages_->begin_rates(), hg)) return false;
    stages_->begin_step(h);
    for (int i = 1; i < tableau().stages; ++i) {
      if (stage(i, t, h, hg)) continue;
      if (!solver_->renew()) return false;
      i = 0;  // all stages anew with the new matrix
    }
    return true;
  }

  bool stage(int i, double t, double h, double hg) {
    const double ti = t + tableau().c[i] * h;
    flows_->at(ti, flow_);
    stages_->guess(i, h, hg);
    return solver_->solve(ti, flow_, stages_->base(), stages_->values(i), stages_->rates(i));
  }

  /// A tenth of what the fastest state needs to change by its scale; the control of the error does the rest.
  double first_step(double interval) const {
    double fastest = 0;
    for (int j : system_.states()) {
      const double size = std::abs(stages_->begin_values()[j]) + system_.scale()[j];
      fastest = std::max(fastest, std::abs(stages_->begin_rates()[j]) / size);
    }
    const double reach = std::cbrt(tolerance_);
    return fastest > 0 ? std::min(interval, reach / fastest) : interval;
  }

  // --- events ---

  /// By how far the guard of switch k is on the wrong side at a stage's values.
  double wrong(int k, double t, const double* y, const double* dy) {
    system_.guards(t, y, dy, guard_.data());
    return system_.on(k, stages_->begin_values()) ? -guard_[k] : guard_[k];
  }

  /// The first stage in time at which some guard is on the wrong side, and that switch.
  std::optional<std::pair<double, int>> first_wrong(double t, double h) {
    for (int node : tableau().nodes) {
      if (node == 0) continue;
      const double c = tableau().c[node];
      system_.guards(t + c * h, stages_->values(node), stages_->rates(node), guard_.data());
      int worst = -1;
      double most = at_zero;
      for (int k = 0; k < system_.switch_count(); ++k) {
        const double w = system_.on(k, stages_->begin_values()) ? -guard_[k] : guard_[k];
        if (w > most) worst = k, most = w;
      }
      if (worst >= 0) return std::pair{c, worst};
    }
    return std::nullopt;
  }

  /// Shortens the step until the first guard to pass zero is at zero where it ends: after each shortening all are asked again,
  /// as the one that was farthest on the wrong side need not be the first.
  double until_event(double t, double h, int& event) {
    for (int i = 0; i < most_shortenings; ++i) {
      const auto found = first_wrong(t, h);
      if (!found) return h;
      const auto [c, k] = *found;
      const double theta = zero(t, h, c, k);
      if (theta * h <= 1e-15 * (1 + std::abs(t))) return at_once(event, k);
      h *= theta;
      last_ = false;
      if (!attempt(t, h)) give_up(t);
      const double w =
          wrong(k, t + h, stages_->values(tableau().stages - 1), stages_->rates(tableau().stages - 1));
      event = std::abs(w) <= at_zero ? k : none;  // where the step ends before the zero the next one finds it
    }
    give_up(t);
  }

  /// A guard that is wrong from the start: the switch is thrown without a step.
  double at_once(int& event, int k) {
    event = k;
    last_ = false;
    stages_->stay();
    return 0;
  }

  /// Where guard k passes zero before c, by bisection and secants on the interpolated step.
  double zero(double t, double h, double c, int k) {
    double low = 0, high = c;
    double w_low = interpolated_wrong(t, h, low, k), w_high = interpolated_wrong(t, h, high, k);
    if (w_low >= 0) w_low = -at_zero;  // just thrown, and zero by its tolerance
    for (int i = 0; i < 60 && high - low > 1e-12; ++i) {
      const double secant = low + (high - low) * w_low / (w_low - w_high);
      const double s = i % 3 == 2 ? 0.5 * (low + high) : std::clamp(secant, low, high);
      const double w = interpolated_wrong(t, h, s, k);
      if (std::abs(w) < 1e-3 * at_zero) return s;
      (w > 0 ? high : low) = s;
      (w > 0 ? w_high : w_low) = w;
    }
    return high;
  }

  double interpolated_wrong(double t, double h, double s, int k) {
    stages_->interpolate(s, row_.data());
    return wrong(k, t + s * h, row_.data(), stages_->begin_rates());
  }

  void throw_switch(double t, int k, double b) {
    events_ = t - last_event_ < 1e-9 ? events_ + 1 : 0;
    last_event_ = t;
    if (events_ > most_events) refuse_endless_switching(system_, t, k);
    std::vector<int> thrown(system_.switch_count(), 0);
    thrown[k] = 1;
    double *y = stages_->begin_values(), *dy = stages_->begin_rates();
    system_.throw_switch(k, y);
    flows_->at(t, flow_);
    consistent_.settle(t, flow_, y, dy, thrown);
    solver_->changed(), stages_->forget();
    step_ = std::min(step_, first_step(b - t));
    if (step_ <= 0) step_ = b - t;
  }

  [[noreturn]] void give_up(double t) const {
    numerics_error(
        "the network stopped at t = {:.9g} s after {} steps, the last one of {:.3g} s; {} holds the worst "
        "residual: look at the blocks there for parameters that are off by orders of magnitude",
        t, steps_, step_,
        worst_equation(system_, t, *flows_, stages_->begin_values(), stages_->begin_rates()));
  }

  [[noreturn]] void refuse_more(double t) const {
    numerics_error("the network needs more than {} steps, at t = {:.3g} s steps of {:.2g} s", most_steps_, t,
                   step_);
  }

  static constexpr int none = -1;  // no switch
  static constexpr int most_failures = 80, resettled_after = 12, most_shortenings = 40, most_events = 1000;
  static constexpr double finest_of_third = 3e-5;  // relative tolerance above which order 3 does
  static constexpr double looser_between = 300;  // times the tolerance: about what errors of steps add up to
  static constexpr double at_zero = 1e-6;        // of the scale of what a guard watches, as in Consistent

  const System& system_;
  Consistent& consistent_;
  double tolerance_;
  long most_steps_;
  /// Order 4, but between kinks so near that one step of order 3 reaches from one to the next: it has two stages less. What
  /// both can reach, (tolerance)^(1/order) of the time in which the states change, tells how near.
  Stages third_, fourth_;
  Stages* stages_;
  double share_;  // step of order 3 over that of order 4; 1: order 3 alone
  std::unique_ptr<StageSolver> solver_;
  const Flows* flows_ = nullptr;
  std::vector<double> guard_, row_, row_rates_, flow_;
  double step_ = 0, last_event_ = -1;
  long steps_ = 0;
  int events_ = 0;
  bool last_ = false;
};

}  // namespace

std::unique_ptr<Engine> make_runge_kutta_engine(const System& system, Consistent& consistent,
                                                double relative_tolerance, long most_steps) {
  return std::make_unique<RungeKuttaEngine>(system, consistent, relative_tolerance, most_steps);
}

}  // namespace ostium::network
