/// Integrators of a network over an interval without kinks.
///
///   exact         x(t+h) = e^{Ah} x(t) + int_0^h e^{A(h-s)} g(t+s) ds, small linear networks only;
///                 g a cubic through four samples, the interval halved until two more samples agree
///   runge_kutta   ESDIRK of order 3 or 4 (network/tableau) with steps of controlled error; a step that meets a kink or an
///                 event costs no more than another one. Constant matrices of linear networks are factored once
///                 per length of step. Where the guard of a switch passes zero the step is shortened to end there, the
///                 switch thrown, consistent values found
///   ida           SUNDIALS IDA: variable-order BDF, sparse direct solver, exact Jacobian; events as above; starts
///                 anew where its Newton iteration fails after some steps
///
/// Source: Moler & van Loan, SIAM Rev. 45 (2003) 3; van Loan, IEEE TAC 23 (1978) 395; Hairer & Wanner, Solving
/// Ordinary Differential Equations II (1996), ch. IV.6 and VI.1; Hindmarsh et al., ACM TOMS 31 (2005) 363.
/// Not checked: that no kink lies inside the interval.
#pragma once
#include <cmath>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "network/consistent.hpp"

namespace ostium::network {

/// Port flows going linearly from q0 at t0 to q1 at t1.
struct Flows {
  double t0 = 0, t1 = 1;
  std::span<const double> q0, q1;
  std::vector<double> at(double t) const;
  void at(double t, std::vector<double>& q) const;
};

/// s, times closer together are one time, up to round-off.
inline double time_tolerance(double t0, double t1) { return 1e-12 * (std::abs(t1) + (t1 - t0)); }

/// Times at which the solution is wanted on the way, increasing, and who takes it: the engine interpolates.
struct Rows {
  std::span<const double> times;
  std::function<void(double t, const double* y)> take;
  std::size_t next = 0;
  bool due(double t) const { return next < times.size() && times[next] <= t; }
};

class Engine {
 public:
  virtual ~Engine() = default;
  /// Forgets what came before; the first step has the given length, s, 0: of its own choice.
  virtual void begin(double step) { (void)step; }
  /// s, length with which the next step would be tried; 0 where there is none.
  virtual double step() const { return 0; }
  /// True where rows between two stops are interpolated; else every row must be a stop.
  virtual bool dense() const { return false; }
  /// Advances consistent (y, dy) from a to b, consistent there.
  virtual void advance(double a, double b, const Flows& flows, double* y, double* dy,
                       Rows* rows = nullptr) = 0;
};

/// tolerance: of the sources' integrals over a step, in the states' scales.
std::unique_ptr<Engine> make_exact_engine(const System& system, Consistent& consistent, double tolerance);
/// most_steps: see NetworkOptions.
std::unique_ptr<Engine> make_runge_kutta_engine(const System& system, Consistent& consistent,
                                                double relative_tolerance, long most_steps);
std::unique_ptr<Engine> make_ida_engine(const System& system, Consistent& consistent,
                                        double relative_tolerance);

/// Guards for a root finder: one that is zero is a little on its own side, so that it passes zero when it leaves.
/// (SUNDIALS does not watch a root function that is zero at the start until it has moved, to whichever side.)
void guards_to_cross(const System& system, double t, const double* y, const double* dy, double* g);
/// A switch that is thrown again and again at one time; throws NumericsError.
[[noreturn]] void refuse_endless_switching(const System& system, double t, int k);
/// The unknown whose equation is violated most.
std::string worst_equation(const System& system, double t, const Flows& flows, const double* y,
                           const double* dy);

}  // namespace ostium::network
