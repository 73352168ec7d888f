/// The elastic constants of a law at small strain, and what follows from them.
///
///   E = 2 mu (1 + nu) = 3 K (1 - 2 nu),   lambda = K - 2 mu / 3
///
///   E           Young's modulus                    Pa
///   nu          Poisson's ratio                    -
///   mu          shear modulus                      Pa
///   K           bulk modulus                       Pa
///   p_wave      K + 4/3 mu, of waves in a volume   Pa
///   plate       E / (1 - nu^2), of waves in a plate under plane stress   Pa
///   c = sqrt(modulus / rho)                        m/s
///
/// Source: docs/theory/materials.md. Refused by elastic(): moduli that are not positive, ratios outside (-1, 0.5).
#pragma once

namespace ostium::sph3d {

struct Moduli {
  double E, nu;

  double mu() const { return E / (2.0 * (1.0 + nu)); }
  double K() const { return E / (3.0 * (1.0 - 2.0 * nu)); }
  double lambda() const { return E * nu / ((1.0 + nu) * (1.0 - 2.0 * nu)); }
  double p_wave() const { return K() + 4.0 / 3.0 * mu(); }
  double plate() const { return E / (1.0 - nu * nu); }
};

/// Checked constants; `what` names the thing they belong to in the sentence.
Moduli elastic(double E, double nu, const char* what = "the wall");

/// From shear and bulk modulus, both positive.
Moduli elastic_from_mu_K(double mu, double K, const char* what = "the wall");

/// sqrt(modulus / density), m/s.
double wave_speed(double modulus, double density);

}  // namespace ostium::sph3d
