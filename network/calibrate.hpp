/// Values of parameters with which the results of a network meet targets: Levenberg and Marquardt's method.
///
///   minimise  sum_i r_i^2,   r_i = sqrt(w_i) (I_i(p) - I_i*)/tol_i          over low <= p <= high
///   (J^T J + lambda diag(J^T J)) d = -J^T r,   J = dr/dx
///   p_j = size_j x_j,   or e^{x_j} on a logarithmic scale
///
///   I, I*   index of the run (network/indices.hpp) and what it should be, SI
///   tol     how near is near, SI: a deviation of tol counts as 1
///   w       weight, 1 if all count alike
///   lambda  damping, less behind a step that helped, more behind one that did not
///
/// J comes from the sensitivities, so that a step costs one run whatever the number of parameters. A parameter at a bound
/// that would leave it is held there. Afterwards the singular values of J say what the targets determine: along a right
/// singular vector with value s a relative change of 1 moves the targets by s tolerances. From (J^T J)^-1 follow each
/// parameter's uncertainty where the targets are uncertain by their tolerances, and which pairs trade places.
/// Source: Levenberg, Q. Appl. Math. 2 (1944) 164; Marquardt, SIAM J. Appl. Math. 11 (1963) 431; Transtrum & Sethna,
/// arXiv:1201.5885. Not checked: that the minimum is the only one.
#pragma once
#include <functional>

#include "network/sensitivities.hpp"

namespace ostium::network {

struct Target {
  Index index;
  double value = 0, tolerance = 1, weight = 1;
};

struct FreeParameter {
  Parameter parameter;
  double low = 0, high = 0;  // SI
  bool logarithmic = true;
};

/// Two parameters whose changes the targets can hardly tell apart.
struct Correlation {
  int first = 0, second = 0;  // numbers of free parameters
  double value = 0;           // -1 .. 1
};

struct Calibration {
  Model model;  // with the values found
  std::vector<double> values,
      uncertainty;             // per parameter: SI; ratio of the value (or of the size), infinite: unknown
  std::vector<bool> at_bound;  // per parameter
  std::vector<double> before, after;      // per target, SI
  Eigen::VectorXd residuals;              // per target: r_i
  Eigen::VectorXd singular_values;        // of J, falling
  Eigen::MatrixXd directions;             // one column per singular value, over the parameters
  std::vector<Correlation> correlations;  // of 0.95 and more, strongest first
  double misfit_before = 0, misfit = 0;   // root mean square of r
  int runs = 0, steps = 0;
  std::string stopped;  // why: "met", "no step helps", "steps are small", "too many runs"

  /// Singular values below this mean: the targets do not determine that direction.
  static constexpr double undetermined = 1e-3;
};

struct CalibrationOptions {
  int most_runs = 60;
  /// Called behind every run: number, misfit, whether the step was taken.
  std::function<void(int, double, bool)> progress = {};
};

/// Throws UserError: no targets or parameters, a start outside the bounds, a logarithmic scale that reaches 0.
Calibration calibrate(const Model& model, const std::vector<Target>& targets,
                      const std::vector<FreeParameter>& parameters, const SensitivityRun& run,
                      const CalibrationOptions& options = {});

}  // namespace ostium::network
