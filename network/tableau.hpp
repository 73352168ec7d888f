/// Coefficients of singly diagonally implicit Runge-Kutta methods with an explicit first stage (ESDIRK).
///
///   Y_i = y_n + h sum_j a_ij K_j,   F(t_n + c_i h, Y_i, K_i) = 0,   a_ii = gamma,   y_(n+1) = Y_s,   K_1 = K_s of the step before
///
///   error   h sum_j (b_j - bhat_j) K_j, of the embedded method that is one order lower
///
/// All stages share one matrix dF/d(dy/dt) + gamma h dF/dy; the last stage is the end of the step, so algebraic
/// equations hold there exactly and stiff parts are damped (L-stable). Stages are of order 2.
/// Source: Kennedy & Carpenter, Appl. Numer. Math. 44 (2003) 139: implicit parts of ARK3(2)4L[2]SA and
/// ARK4(3)6L[2]SA. Not checked: nothing to check.
#pragma once
#include <array>

namespace ostium::network {

struct Tableau {
  static constexpr int most = 6;
  int stages, order;
  double gamma;
  std::array<std::array<double, most>, most> a;
  std::array<double, most> c, error;
  std::array<int, 4> nodes;  // stages whose c are 0 < .. < 1: algebraic unknowns go through them
  int probe;                 // stage that their curve is judged by, itself left out
};

const Tableau& third_order();
const Tableau& fourth_order();

/// Value at x of the Lagrange polynomials through nodes[0 .. n-1].
template <class Nodes, class Weights>
void lagrange(const Nodes& nodes, int n, double x, Weights& weights) {
  for (int i = 0; i < n; ++i) {
    weights[i] = 1;
    for (int j = 0; j < n; ++j)
      if (j != i) weights[i] *= (x - nodes[j]) / (nodes[i] - nodes[j]);
  }
}

}  // namespace ostium::network
