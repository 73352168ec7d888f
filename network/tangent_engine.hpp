/// Integrates a network together with its sensitivities: SUNDIALS IDAS, staggered corrector.
///
/// The steps are those the trajectory needs at its tolerance; sensitivities are kept to `sensitivity_tolerance` of
/// their own sizes. Events, kinks and failures are treated as by the engine without sensitivities (network/engine);
/// at an event the sensitivities jump (network/tangent). No port flows: for networks alone or closed on themselves.
/// Source: Hindmarsh et al., ACM TOMS 31 (2005) 363; Feehery, Tolsma & Barton, Appl. Numer. Math. 25 (1997) 41.
#pragma once
#include <memory>

#include "network/consistent.hpp"
#include "network/network.hpp"
#include "network/tangent.hpp"

namespace ostium::network {

/// The trajectory over the last step, by the integrator's own polynomials.
class Interpolant {
 public:
  virtual ~Interpolant() = default;
  /// y or its first derivative.
  virtual const Eigen::VectorXd& y(double t, int derivative) = 0;
  virtual const Eigen::MatrixXd& S(double t) = 0;
};

/// Sees every step.
class Watcher {
 public:
  virtual ~Watcher() = default;
  /// The step from a to b. fresh: it begins after a stop; tau: dtau/dp of the event there, nothing where it was none.
  virtual void step(Interpolant& trajectory, double a, double b, bool fresh,
                    const std::optional<Eigen::RowVectorXd>& tau) = 0;
};

class TangentEngine {
 public:
  TangentEngine(const System& system, Consistent& consistent, Tangent& tangent);
  ~TangentEngine();

  /// From state.time to `end`. S: on entry the rows of the states count, on return it is complete.
  void march(double end, State& state, Eigen::MatrixXd& S, Watcher* watcher = nullptr);

 private:
  class Ida;
  std::unique_ptr<Ida> ida_;
};

}  // namespace ostium::network
