/// Wendland C2 kernel of support 2h in D dimensions.
///
///   W(r) = (alpha / h^D) (1 - q/2)^4 (1 + 2q),   dW/dr = -(5 alpha / h^(D+1)) q (1 - q/2)^3,   q = r/h in
///   [0, 2]
///
///   symbol      meaning                            unit
///   h           smoothing length                   m
///   reach       2h, beyond which W = 0             m
///   value       W                                  m^-D
///   slope       dW/dr (not positive)               m^-(D+1)
///
/// Source: Wendland 1995; docs/theory/fluid.md, section "Kernel".
#pragma once
#include <array>
#include <cmath>

#include "core/vec.hpp"

namespace ostium::sph3d {

template <int D>
struct Wendland {
  static_assert(D == 2 || D == 3);
  static constexpr double alpha = D == 2 ? 7.0 / (4.0 * pi) : 21.0 / (16.0 * pi);

  double h = 1.0;

  double reach() const { return 2.0 * h; }
  double normalisation() const { return alpha / std::pow(h, D); }

  double value(double r) const {
    const double q = r / h, t = 1.0 - 0.5 * q;
    return t <= 0.0 ? 0.0 : normalisation() * t * t * t * t * (1.0 + 2.0 * q);
  }

  double slope(double r) const {
    const double q = r / h, t = 1.0 - 0.5 * q;
    return t <= 0.0 ? 0.0 : -5.0 * normalisation() / h * q * t * t * t;
  }
};

/// Sum of W over a square or cubic lattice of spacing dp, the particle itself included, times dp^D
/// (about 1.01).
template <int D>
double lattice_sum(const Wendland<D>& kernel, double dp) {
  const int n = static_cast<int>(std::ceil(kernel.reach() / dp));
  double sum = 0.0;
  const auto line = [&](double offset2) {
    for (int i = -n; i <= n; ++i) sum += kernel.value(std::sqrt(i * i * dp * dp + offset2));
  };
  for (int j = -n; j <= n; ++j) {
    if constexpr (D == 2) {
      line(j * j * dp * dp);
    } else {
      for (int k = -n; k <= n; ++k) line((j * j + k * k) * dp * dp);
    }
  }
  return sum * std::pow(dp, D);
}

}  // namespace ostium::sph3d
