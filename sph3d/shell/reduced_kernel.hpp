/// Wendland C2 kernel over a surface: the polynomial of the fluid's kernel, normalised for one dimension less.
///
///   W(r) = (alpha / h^T) (1 - q/2)^4 (1 + 2q),   -W'(r)/r = (5 alpha / h^(T+2)) (1 - q/2)^3,   q = r/h, T = D - 1
///
///   symbol        meaning                             unit
///   h             smoothing length                    m
///   value         W                                   m^-T
///   pull          -W'/r, not negative                 m^-(T+2)
///
/// r is the chord, not the way along the surface. Source: docs/theory/shell.md, section "Gradients".
#pragma once
#include <cmath>

#include "core/vec.hpp"

namespace ostium::sph3d {

template <int D>
struct ReducedKernel {
  static constexpr int T = D - 1;
  static constexpr double alpha = T == 1 ? 0.75 : 7.0 / (4.0 * pi);

  double h = 1.0;

  double reach() const { return 2.0 * h; }
  double value(double r) const {
    const double q = r / h, t = 1.0 - 0.5 * q;
    return t <= 0.0 ? 0.0 : alpha / std::pow(h, T) * t * t * t * t * (1.0 + 2.0 * q);
  }
  double pull(double r) const {
    const double t = 1.0 - 0.5 * r / h;
    return t <= 0.0 ? 0.0 : 5.0 * alpha / std::pow(h, T + 2) * t * t * t;
  }
};

}  // namespace ostium::sph3d
