/// The stress that a wall has in the image it was made from: vessels are imaged under pressure, so the shape of the image
/// is not free of stress but in equilibrium.
///
///   B^T S0 = f(p0) at u = 0,     S0 = C B x,   K x = f(p0)
///
///   symbol   meaning                                                                          unit
///   S0       stress within the wall, constant in its own frame: S = S0 + S(E(u))              Pa
///   p0       pressure of the blood less that of the tissue around, on the face of the model      Pa
///   f(p0)    its forces and moments on the wall in the image's shape                          N, N m
///   x, B, C, K   of linear_shell.hpp: x is no motion, only what names the stress
///
/// Equilibrium at u = 0 is linear in S0, so one linear problem is all there is to solve, to rounding; conjugate gradients do.
/// Of all stresses that carry p0 this is the one of least complementary energy. Where stress alone cannot balance a load of
/// zigzags, the hourglass control keeps its share as well.
///
/// Use: make the model, find_prestress(model, load), then advance() as ever, with the same pressure in its loads.
/// Source: docs/theory/shell.md, section "Pre-stress". Refused: a wall that nothing holds against the load. Not checked: that
/// the equilibrium is stable; that Hooke's law at small strain is fit for the loaded wall.
#pragma once
#include <functional>

#include "sph3d/shell/state.hpp"

namespace ostium::sph3d {

///   tolerance    on what is missing of x, over x, both by the root of their elastic energy          -
struct PrestressOptions {
  double tolerance = 1e-5;
  int most_iterations = 100000;
};

struct PrestressReport {
  int iterations = 0;
  double error = 0;         ///< see tolerance
  double displacement = 0;  ///< largest of x: how far the wall would have moved, m
};

/// The load that a pressure alone is, Pa.
template <int D>
std::vector<ShellLoad<D>> pressure_load(const ShellModel<D>& model, double pressure);

/// Puts the stress into the model, in place of what it had. No load: none. progress(iteration, error), every now and then.
template <int D>
PrestressReport find_prestress(ShellModel<D>& model, const std::vector<ShellLoad<D>>& load,
                               const PrestressOptions& options = {},
                               const std::function<void(int, double)>& progress = {});

}  // namespace ostium::sph3d
