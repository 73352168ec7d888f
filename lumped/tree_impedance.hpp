/// Input impedance of a structured tree: the bed beyond an outlet as an asymmetric, self-similar tree of compliant tubes.
///
///        r_root            a vessel of radius r ends in two of radii alpha r and beta r, ; one with r < r_min is the last
///      o========<==...     length of each: length_ratio r
///
///   alpha = (1 + eta^(xi/2))^(-1/xi),  beta = alpha sqrt(eta)         power law of radii, asymmetry
///   Eh/r = k1 e^(k2 r) + k3,   C = 3 pi r^2/(2 Eh/r)                  compliance per length
///   F = 2 J1(z)/(z J0(z)),     z^2 = -i omega rho r^2/mu              oscillating viscous flow (Womersley)
///   Y = sqrt(C pi r^2 (1 - F)/rho),  gamma = i omega l C/Y            admittance of the wave, propagation
///   Z(0) = (Z(l) + tanh(gamma)/Y)/(1 + Y Z(l) tanh(gamma)),           a vessel; 1/Z(l) = 1/Z_alpha(0) + 1/Z_beta(0)
///   omega = 0:  Z(0) = 8 mu l/(pi r^4) + Z(l)
///
///   r_root, r_min   m        radius of the root, and the one below which a vessel is the last; behind those Z(l) = 0
///   xi, eta         1        exponent of the power law, ratio of the daughters' areas
///   length_ratio    1        length over radius
///   k1, k2, k3      Pa, 1/m, Pa   stiffness of the wall
///   rho, mu         kg/m3, Pa.s   blood
///
/// Source: Olufsen, Am. J. Physiol. 276 (1999) H257; Olufsen et al., Ann. Biomed. Eng. 28 (2000) 1281. Not checked: that
/// blood is a continuum in the smallest vessels.
#pragma once
#include <complex>

namespace ostium::lumped {

struct Tree {
  double r_root = 0, r_min = 0;
  double xi = 2.76, eta = 0.41, length_ratio = 50;
  double k1 = 2e6, k2 = -2253, k3 = 8.65e4;
  double rho = 1060, mu = 0.004;

  double alpha() const;
  double beta() const;
};

/// Pa.s/m3 at omega >= 0 rad/s.
std::complex<double> impedance(const Tree& tree, double omega);

}  // namespace ostium::lumped
