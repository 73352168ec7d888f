#include "sph3d/structure/moduli.hpp"

#include <cmath>

#include "core/error.hpp"

namespace ostium::sph3d {

namespace {

void require_positive(double x, const char* name, const char* what) {
  if (!(x > 0.0 && std::isfinite(x)))
    user_error("The {} of {} must be positive; found {:g} Pa.", name, what, x);
}

}  // namespace

Moduli elastic(double E, double nu, const char* what) {
  require_positive(E, "Young's modulus", what);
  if (nu >= 0.5)
    user_error(
        "Poisson's ratio of {} must be below 0.5; found {:g}. At 0.5 the volume cannot change and pressure "
        "travels "
        "infinitely fast, which no explicit step can follow. Use 0.49: a thin wall under pressure then moves "
        "within "
        "1.3 % of what it would at 0.5.",
        what, nu);
  if (!(nu > -1.0)) user_error("Poisson's ratio of {} must lie between -1 and 0.5; found {:g}.", what, nu);
  return {E, nu};
}

Moduli elastic_from_mu_K(double mu, double K, const char* what) {
  require_positive(mu, "shear modulus", what);
  require_positive(K, "bulk modulus", what);
  return {9.0 * K * mu / (3.0 * K + mu), (3.0 * K - 2.0 * mu) / (2.0 * (3.0 * K + mu))};
}

double wave_speed(double modulus, double density) { return std::sqrt(modulus / density); }

}  // namespace ostium::sph3d
