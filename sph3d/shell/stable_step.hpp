/// The longest step a shell may take: a share `cfl` of the least over the particles of
///
///   h_s / c_ps,   c_ps^2 = (E / (1 - nu^2) + s) / rho                  waves within the surface
///   h_s / c_ps / sqrt(2 + pi^2/12 (1 - nu) (1 + 3/2 h_s^2/g))             shear waves; g = 12 x squared radius of gyration
///   h_s / (c_ps + |v|),  sqrt(h_s / |dv/dt|),  1 / |omega|,  1 / sqrt|d omega/dt|
///
///   h_s, t        smoothing length, thickness                               m
///   s             largest tension of the pre-stress, on average over the thickness; 0 if it has none      Pa
///   g             t^2, or max(t^2, h_s^2) with rotary scaling                m2
///
/// Source: docs/theory/shell.md, section "Stable step" (after Tsui & Pian 1971 for Mindlin plates).
#pragma once
#include "sph3d/shell/step.hpp"

namespace ostium::sph3d {

/// Of the reference: what the material and the spacing allow.
template <int D>
double stable_step(const ShellModel<D>& model);

/// With the velocities of the state and the accelerations of the last step.
template <int D>
double stable_step(const ShellModel<D>& model, const ShellState<D>& state, const ShellWorkspace<D>& work);

}  // namespace ostium::sph3d
