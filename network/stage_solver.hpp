/// The equations of one implicit stage of a Runge-Kutta step.
///
///   F(t, Y, K; Q) = 0   with   Y = base + hg K for the states, Y free for the algebraic unknowns
///
///   hg     s   step length times the diagonal coefficient
///   base       what the stages before give the states
///
///   newton   simplified Newton iteration on dF/dy + 1/hg dF/d(dy/dt), whose LU is kept from step to step while
///            it converges fast
///   linear   the same matrix is constant per hg: its LU is kept for the last few lengths, and a stage is one
///            solution, (dF/dy + 1/hg dF/d(dy/dt)) Y = 1/hg dF/d(dy/dt) base - F(t, 0, 0; Q)
///
/// Source: Hairer & Wanner, Solving Ordinary Differential Equations II (1996), sec. IV.8. Not checked: index.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "network/engine.hpp"

namespace ostium::network {

class StageSolver {
 public:
  virtual ~StageSolver() = default;
  /// Forgets everything of the steps before.
  virtual void forget() = 0;
  /// The equations have changed: a switch was thrown.
  virtual void changed() = 0;
  /// A step from consistent (y, dy); t: of its middle, where coefficients that change with time are nearest to those of all
  /// stages. False: the matrix is singular.
  virtual bool begin_step(double t, const double* y, const double* dy, double hg) = 0;
  /// y, dy: a guess in, the stage's values and rates out, to within `looser` times what a step needs. False: no
  /// convergence.
  virtual bool solve(double t, std::span<const double> port_flow, const double* base, double* y, double* dy,
                     double looser = 1) = 0;
  /// An error of the states (in) as the stiff parts damp it: (dF/dy + 1/hg dF/d(dy/dt))^-1 1/hg dF/d(dy/dt) error.
  virtual void damp(double* error) = 0;
  /// After no convergence: false where the matrix was that of this step already.
  virtual bool renew() = 0;
};

std::unique_ptr<StageSolver> make_newton_stages(const System& system, double relative_tolerance);
std::unique_ptr<StageSolver> make_linear_stages(const System& system);

}  // namespace ostium::network
