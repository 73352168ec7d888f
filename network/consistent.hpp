/// Consistent values: the algebraic unknowns, the rates and the positions of switches that belong to given states.
///
///   given x (differential unknowns), t, Q:   find (dx/dt, z) with F(t, x, z, dx/dt; Q) = 0
///   M = [dF/d(dx/dt) | dF/dz],   regular exactly where the equations are of index 1
///
/// Newton's iteration with a sparse LU of M, scaled by rows and columns; one factorisation for a linear
/// network. Throws NumericsError where it does not converge. Source: Brown, Hindmarsh & Petzold, SIAM J. Sci.
/// Comput. 19 (1998) 1495. Not checked: index (StateSpace does).
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "network/sparse_lu.hpp"
#include "network/system.hpp"

namespace ostium::network {

class Consistent {
 public:
  explicit Consistent(const System& system);

  /// y: states in, all unknowns out. dy: rates of the states out, 0 for algebraic unknowns.
  void solve(double t, std::span<const double> port_flow, double* y, double* dy);

  /// solve, and throws the switches whose guards say so until none does. `thrown`: one per switch, what an event
  /// has just thrown.
  void settle(double t, std::span<const double> port_flow, double* y, double* dy,
              std::vector<int> thrown = {});

  /// The parameters have changed.
  void forget() { factorised_ = false; }
  /// What follows does not depend on what came before: a restart has the same bits as a run that goes on. Until then the
  /// pivots of earlier states serve later ones.
  void begin() { factorised_ = factorised_ && system_.linear(); }

  /// Derivatives of y for port flows held, at consistent (y, dy): rates of the states and of the algebraic
  /// unknowns.
  Eigen::VectorXd rates(double t, std::span<const double> port_flow, const double* y, const double* dy);

 private:
  void factorise(double t, const double* y, const double* dy);
  void solve_scaled(Eigen::VectorXd& residual) const;
  double correct(double t, std::span<const double> port_flow, double* y, double* dy);
  std::optional<int> misplaced(double t, std::span<const double> port_flow, const double* y, const double* dy,
                               const std::vector<int>& thrown);
  std::vector<double> guards_after(double dt, double t, std::span<const double> port_flow, const double* y,
                                   const double* dy);
  [[noreturn]] void refuse_chatter(double t, int k) const;

  static constexpr double moment = 1e-6;           // s, far below any time of the circulation
  static constexpr double guard_tolerance = 1e-6;  // of the scale of what the guard watches

  const System& system_;
  SparseLu lu_;
  std::vector<double> d_y_, d_dy_, matrix_;
  Eigen::VectorXd row_scale_, residual_;
  bool factorised_ = false;
};

}  // namespace ostium::network
