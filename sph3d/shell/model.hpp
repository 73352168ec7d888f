/// Everything about a shell that does not change while it moves: reference neighbours, gradients, material, supports.
///
///   symbol            meaning                                                                    unit
///   spacing           dp_s, distance of the particles; h_s = smoothing dp_s                      m
///   density           rho_s of the wall                                                          kg/m3
///   material          law of the wall under plane stress (structure/material.hpp)
///   gauss_points      through the thickness: 1 (no bending stiffness), 2, 3 or 5                       -
///   damping           a: artificial viscosity a rho c h_s, c of extension and of shear           -
///   viscosity         of the wall itself, eta: S += 2 eta dE/dt                                  Pa s
///   hourglass         gamma: stiffness against zigzags over the wall's own, see theory            -
///   rotary_scaling    rotary inertia of a wall at least h_s thick: longer steps for thin walls
///   face              where pressure acts: -1 inner face, 0 mid-surface, 1 outer face            -
///   spring, dashpot   tissue around the wall: traction -spring u - dashpot v         Pa/m, Pa s/m
///   fibre_angle       of both families to the circumference of the cloud                         rad
///   cfl               share of the stable step that is taken                                     -
///
/// Gradient of f at a along the local tangents:  f,a = sum_b (f_b - f_a) g_ab,  g = M^-1 xi w,  M = sum_b w xi (x) xi,
/// w = -W'/r A_b,  xi the tangential part of X_b - X_a. The eigenvalues of M are kept above `least_moment` (a straight edge
/// has 0.48, a square corner about 0.3); where they would be less the gradient is no longer exact for linear fields: counted
/// in `guarded`. Source: docs/theory/shell.md. Not checked: that supports leave the shell something to stand on.
#pragma once
#include <span>

#include "sph3d/shell/block.hpp"
#include "sph3d/shell/cloud.hpp"
#include "sph3d/shell/reduced_kernel.hpp"
#include "sph3d/shell/strain.hpp"
#include "sph3d/structure/material.hpp"

namespace ostium::sph3d {

struct ShellOptions {
  double spacing = 0, density = 1000;
  Material material = SaintVenantKirchhoff({.E = 1e6, .nu = 0.3});
  int gauss_points = 3;
  double smoothing = 1.15, damping = 0.5, viscosity = 0, hourglass = 1.0;
  bool rotary_scaling = false;
  double face = 0;
  double spring = 0, dashpot = 0;
  double fibre_angle = 0;
  double cfl = 0.6;
};

/// What a wall carries in its reference, in equilibrium with a load there (prestress.hpp). Empty: nothing.
template <int D>
struct ShellPrestressField {
  std::vector<ShellPrestress<D>> blocks;               // what the steps read
  std::vector<ShellStrains<D - 1, double>> prestrain;  // of each particle: the stress at chi is Hooke's of it

  bool empty() const { return blocks.empty(); }
};

template <int D>
struct ShellModel {
  static constexpr double least_moment = 0.15;

  /// The cloud as it is, in its order.
  ShellModel(ShellCloud<D> cloud, const ShellOptions& options);

  std::size_t count() const { return cloud.count(); }
  std::size_t blocks() const { return reference.size(); }
  ShellRows<D> rows() const;
  std::span<const std::int32_t> neighbours(std::size_t a) const;
  double mass(std::size_t a) const { return options.density * cloud.thickness[a] * cloud.area[a]; }
  /// Squared radius of gyration of the rotary inertia, m2.
  double gyration2(std::size_t a) const;

  ShellCloud<D> cloud;
  ShellOptions options;
  ReducedKernel<D> kernel;
  std::vector<ShellReference<D>> reference;
  std::vector<std::int64_t> row_begin;  // of each particle
  std::vector<std::int32_t> neighbour;
  std::vector<ShellWeight<D>> forward, backward;
  ShellPrestressField<D> prestress;
  std::size_t guarded = 0;  // particles whose gradient is not exact
};

extern template struct ShellModel<2>;
extern template struct ShellModel<3>;

}  // namespace ostium::sph3d
