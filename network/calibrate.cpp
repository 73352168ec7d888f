#include "network/calibrate.hpp"

#include <Eigen/Cholesky>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.hpp"

namespace ostium::network {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

void check(const Model& model, const std::vector<Target>& targets, const std::vector<FreeParameter>& free) {
  if (targets.empty()) user_error("{}: a calibration needs at least one target", model.where);
  if (free.empty()) user_error("{}: a calibration needs at least one parameter", model.where);
  for (const auto& t : targets)
    if (!(t.tolerance > 0) || !(t.weight > 0))
      user_error("{}: the target \"{}\" has the tolerance {:g} and the weight {:g}; both must be > 0",
                 model.where, t.index.text, t.tolerance, t.weight);
  for (const auto& f : free) {
    const auto& p = f.parameter;
    if (!(f.low < f.high))
      user_error("{}: low is {:g} and high {:g} {}; low must be below high", p.name, f.low, f.high, p.unit);
    if (f.logarithmic && !(f.low > 0))
      user_error(
          "{}: low is {:g} {}, and a logarithmic scale needs low > 0; raise it, or choose `scale: linear`",
          p.name, f.low, p.unit);
    check_value(p, f.low), check_value(p, f.high);
    if (p.value < f.low || p.value > f.high)
      user_error("{} starts at {:g} {}, outside its bounds {:g} .. {:g}; widen them or start elsewhere",
                 p.name, p.value, p.unit, f.low, f.high);
  }
}

/// The model at x, its results there and how they change.
struct Evaluation {
  VectorXd x, r;
  MatrixXd J;
  std::vector<double> indices;
  double cost() const { return r.squaredNorm(); }
};

class Problem {
 public:
  Problem(const Model& model, const std::vector<Target>& targets, const std::vector<FreeParameter>& free,
          const SensitivityRun& run)
      : model_(model), targets_(targets), free_(free), run_(run) {
    for (const auto& t : targets) indices_.push_back(t.index);
  }

  VectorXd start() const {
    return each([&](const FreeParameter& f) { return to_x(f, f.parameter.value); });
  }
  VectorXd low() const {
    return each([&](const FreeParameter& f) { return to_x(f, f.low); });
  }
  VectorXd high() const {
    return each([&](const FreeParameter& f) { return to_x(f, f.high); });
  }
  double value(int j, double x) const {
    const auto& f = free_[j];
    return std::clamp(f.logarithmic ? std::exp(x) : x * f.parameter.size, f.low, f.high);
  }

  Model at(const VectorXd& x) const {
    Model changed = model_;
    Changes changes(model_);
    for (int j = 0; j < x.size(); ++j) {
      const auto& p = free_[j].parameter;
      changed.entries[p.entry].block = changes.block(p, value(j, x[j]));
      changes.keep(p, value(j, x[j]));
    }
    return changed;
  }

  Evaluation evaluate(const VectorXd& x) const {
    const Model changed = at(x);
    std::vector<Parameter> now;
    for (const auto& f : free_) now.push_back(parameter(changed, f.parameter.name, model_.where));
    const auto s = sensitivities(changed, indices_, now, run_);
    Evaluation e{x, VectorXd(targets_.size()), s.gradients, s.values};
    for (std::size_t i = 0; i < targets_.size(); ++i) {
      const auto& t = targets_[i];
      const double share = std::sqrt(t.weight) / t.tolerance;
      e.r[i] = share * (s.values[i] - t.value);
      e.J.row(i) *= share;
    }
    for (std::size_t j = 0; j < free_.size(); ++j)
      e.J.col(j) *= free_[j].logarithmic ? now[j].value : free_[j].parameter.size;
    if (!e.r.allFinite() || !e.J.allFinite()) numerics_error("the results of the calibration are not finite");
    return e;
  }

 private:
  template <class F>
  VectorXd each(F f) const {
    VectorXd v(free_.size());
    for (std::size_t j = 0; j < free_.size(); ++j) v[j] = f(free_[j]);
    return v;
  }
  static double to_x(const FreeParameter& f, double value) {
    return f.logarithmic ? std::log(value) : value / f.parameter.size;
  }

  const Model& model_;
  const std::vector<Target>& targets_;
  const std::vector<FreeParameter>& free_;
  const SensitivityRun& run_;
  std::vector<Index> indices_;
};

/// The damped step within the bounds.
VectorXd step(const Evaluation& e, double lambda, const VectorXd& low, const VectorXd& high) {
  const VectorXd g = e.J.transpose() * e.r;
  std::vector<int> moves;
  for (int j = 0; j < g.size(); ++j) {
    const bool leaves = (e.x[j] <= low[j] && g[j] > 0) || (e.x[j] >= high[j] && g[j] < 0);
    if (!leaves) moves.push_back(j);
  }
  VectorXd d = VectorXd::Zero(g.size());
  if (moves.empty()) return d;
  const MatrixXd J = e.J(Eigen::all, moves);
  MatrixXd A = J.transpose() * J;
  const double least = 1e-12 * A.diagonal().maxCoeff() + 1e-300;
  A.diagonal() += lambda * A.diagonal().cwiseMax(least);
  const VectorXd rhs = -g(moves), moved = A.ldlt().solve(rhs);
  for (std::size_t k = 0; k < moves.size(); ++k) d[moves[k]] = moved[static_cast<Eigen::Index>(k)];
  return (e.x + d).cwiseMax(low).cwiseMin(high) - e.x;
}

/// Nothing where these values cannot be run or are refused.
std::optional<Evaluation> attempt(const Problem& problem, const VectorXd& x) {
  try {
    return problem.evaluate(x);
  } catch (const NumericsError&) {
  } catch (const UserError&) {
  }
  return std::nullopt;
}

Evaluation descend(const Problem& problem, Evaluation now, const CalibrationOptions& options,
                   Calibration& result) {
  const VectorXd low = problem.low(), high = problem.high();
  constexpr double met = 1e-6, small = 1e-9, most_damping = 1e10;  // of a tolerance; of a parameter
  double lambda = 1e-3;
  result.stopped = "too many runs";
  while (result.runs < options.most_runs) {
    if (now.r.lpNorm<Eigen::Infinity>() < met) return result.stopped = "met", now;
    const VectorXd d = step(now, lambda, low, high);
    if (!(d.lpNorm<Eigen::Infinity>() > small)) return result.stopped = "steps are small", now;
    const auto next = attempt(problem, now.x + d);
    ++result.runs;
    const bool helps = next && next->cost() < now.cost();
    if (options.progress)
      options.progress(result.runs,
                       std::sqrt((helps ? *next : now).cost() / static_cast<double>(now.r.size())), helps);
    if (!helps) {
      lambda *= 10;
      if (lambda > most_damping) return result.stopped = "no step helps", now;
      continue;
    }
    const bool stands = now.cost() - next->cost() < 1e-10 * now.cost();
    now = *next, ++result.steps, lambda = std::max(lambda / 10, 1e-12);
    if (stands) return result.stopped = "steps are small", now;
  }
  return now;
}

/// What the targets say of the parameters.
void identify(const Evaluation& e, Calibration& c) {
  const Eigen::JacobiSVD<MatrixXd> svd(e.J, Eigen::ComputeThinU | Eigen::ComputeFullV);
  const auto n = e.J.cols();
  c.singular_values = VectorXd::Zero(n);
  c.singular_values.head(svd.singularValues().size()) = svd.singularValues();
  c.directions = svd.matrixV();
  const VectorXd inverse =
      c.singular_values.unaryExpr([](double s) { return s > Calibration::undetermined ? 1 / s : 1e6; });
  const MatrixXd root = c.directions * inverse.asDiagonal();
  const MatrixXd covariance = root * root.transpose();
  for (int j = 0; j < n; ++j) {
    const double sigma = std::sqrt(covariance(j, j));
    c.uncertainty.push_back(sigma < 1 / Calibration::undetermined ? sigma : INFINITY);
    for (int k = 0; k < j; ++k) {
      const double rho = covariance(j, k) / std::sqrt(covariance(j, j) * covariance(k, k));
      constexpr double noticeable = 0.95;
      if (std::abs(rho) >= noticeable) c.correlations.push_back({k, j, rho});
    }
  }
  std::sort(c.correlations.begin(), c.correlations.end(),
            [](const auto& a, const auto& b) { return std::abs(a.value) > std::abs(b.value); });
}

}  // namespace

Calibration calibrate(const Model& model, const std::vector<Target>& targets,
                      const std::vector<FreeParameter>& free, const SensitivityRun& run,
                      const CalibrationOptions& options) {
  check(model, targets, free);
  const Problem problem(model, targets, free, run);
  const Evaluation begin = problem.evaluate(problem.start());
  const auto rms = [&](const Evaluation& e) {
    return std::sqrt(e.cost() / static_cast<double>(targets.size()));
  };
  Calibration c;
  c.before = begin.indices, c.misfit_before = rms(begin), c.runs = 1;
  const Evaluation end = descend(problem, begin, options, c);
  c.model = problem.at(end.x);
  c.after = end.indices, c.misfit = rms(end), c.residuals = end.r;
  const VectorXd low = problem.low(), high = problem.high();
  for (int j = 0; j < end.x.size(); ++j) {
    c.values.push_back(problem.value(j, end.x[j]));
    c.at_bound.push_back(end.x[j] <= low[j] || end.x[j] >= high[j]);
  }
  identify(end, c);
  return c;
}

}  // namespace ostium::network
