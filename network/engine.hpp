/// Integrators of a network over an interval without kinks.
///
///   exact   x(t+h) = e^{Ah} x(t) + int_0^h e^{A(h-s)} g(t+s) ds, linear networks only;
///           g a cubic through four samples, the interval halved until two more samples agree
///   ida     SUNDIALS IDA: variable-order BDF, sparse direct solver, exact Jacobian; where the guard of a switch
///           passes zero it stops, throws the switch, finds consistent values and starts anew; the same where its
///           Newton iteration fails after some steps
///
/// Source: Moler & van Loan, SIAM Rev. 45 (2003) 3; van Loan, IEEE TAC 23 (1978) 395; Hindmarsh et al., ACM
/// TOMS 31 (2005) 363.
/// Not checked: that no kink lies inside the interval.
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "network/consistent.hpp"

namespace ostium::network {

/// Port flows going linearly from q0 at t0 to q1 at t1.
struct Flows {
  double t0 = 0, t1 = 1;
  std::span<const double> q0, q1;
  std::vector<double> at(double t) const;
};

class Engine {
 public:
  virtual ~Engine() = default;
  /// Advances consistent (y, dy) from a to b; leaves the states right, Consistent does the rest.
  virtual void advance(double a, double b, const Flows& flows, double* y, double* dy) = 0;
};

std::unique_ptr<Engine> make_exact_engine(const System& system, Consistent& consistent);
std::unique_ptr<Engine> make_ida_engine(const System& system, Consistent& consistent,
                                        double relative_tolerance);

}  // namespace ostium::network
