/// Structured tree: the bed beyond an outlet as a self-similar tree of small compliant arteries.
///
///        r_root         each vessel of radius r and length `length_ratio` r ends in two, of radii alpha r and beta r;
///   o======<====..      the first one below r_min is the last, at the distal pressure Pd
///
///   p_from - Pd = Z q,   Z the impedance of the tree (lumped/tree_impedance has its equations)
///
/// Z is computed at 0 and at frequencies up to f_max and met by a passive rational impedance with at most 12 states
/// (lumped/impedance_fit; lumped/fitted_outlet has the equations and the series); Z(0) is exact, the rest is met to a
/// percent or so for roots up to 3 mm, less well for larger ones. An error above 5 % is told.
///
///   q              m3/s   flow entering at `from`
///   r_root, r_min  m      radius at the outlet; radius below which a vessel is the last
///   xi, eta        1      r^xi = (alpha r)^xi + (beta r)^xi,  eta = (beta/alpha)^2
///   length_ratio   1      length over radius
///   k1, k2, k3     Pa, 1/m, Pa    wall: Eh/r = k1 e^(k2 r) + k3
///   density, viscosity   kg/m3, Pa.s
///   f_max          Hz     highest frequency met
///
/// Example:
///   arm: {type: structured_tree, from: brachial, r_root: 2 mm, r_min: 0.1 mm, Pd: 20 mmHg}
///
/// Source: Olufsen, Am. J. Physiol. 276 (1999) H257; Olufsen et al., Ann. Biomed. Eng. 28 (2000) 1281. Not checked: that
/// r_min suits the bed.
#pragma once
#include "lumped/fitted_outlet.hpp"
#include "lumped/tree_impedance.hpp"

namespace ostium::lumped {

struct StructuredTree : FittedOutlet {
  Tree tree;
  double r_root = 0, r_min = 0, xi = 0, eta = 0, length_ratio = 0;
  double k1 = 0, k2 = 0, k3 = 0, density = 0, viscosity = 0, f_max = 0;

  static constexpr const char* type = "structured_tree";

  template <class T>
  void equations(const In<StructuredTree, T>& x, Out<StructuredTree, T>& f) const {
    outlet(x, f);
  }
  void prepare();
};

void declare(config::Fields<StructuredTree>& f);

}  // namespace ostium::lumped
