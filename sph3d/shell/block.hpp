/// The layout of the shell kernels: blocks of eight particles, and what a neighbour shows of itself.
///
/// T = D - 1 tangents. Symmetric tensors over the tangents: their upper triangle row by row.
///
///   symbol     meaning                                                               unit
///   u          displacement of the mid-surface                                       m
///   v          velocity                                                              m/s
///   n          pseudo-normal, unit                                                   -
///   w          its rate, perpendicular to n:  w = omega x n                          1/s
///   N          n of the reference                                                    -
///   G_a        discrete tangents of the reference, dX/dxi_a                           -
///   dN_a       dN/dxi_a                                                              1/m
///   strain     membrane, bending, shear of the last step, for their rates           -, 1/m, -
///
/// Source: docs/theory/shell.md, section "Layout".
#pragma once
#include <cstdint>

#include "core/vec.hpp"

namespace ostium::sph3d {

template <int D>
inline constexpr int tangents = D - 1;
template <int D>
inline constexpr int tangent_pairs = D*(D - 1) / 2;
template <int D>
inline constexpr int strain_size = 2 * tangent_pairs<D> + tangents<D>;

/// What moves: the state of eight particles.
template <int D>
struct alignas(64) ShellBlock {
  double u[D][8], v[D][8], n[D][8], w[D][8];
  double strain[strain_size<D>][8];
};

/// What stays.
template <int D>
struct alignas(64) ShellReference {
  static constexpr int T = tangents<D>;
  double N[D][8], G[T][D][8], dN[T][D][8];
  double curvature[T][T][8];         ///< dN_a . e_b                                            1/m
  double sum[T][8];                  ///< of the gradient weights                               1/m
  double hourglass_sum[8];           ///< of the hourglass weights                              -
  double hourglass_turn[8];          ///< what they make of the reference, along N              m
  double hourglass_stiffness[2][8];  ///< within the surface, across it                         Pa/m
  double area[8], thickness[8], stiffness[8];
  double inverse_mass[8];              ///< 1 / (rho t A)                                         1/kg
  double inverse_rotary[8];            ///< 1 / (rho t^3/12 A)                                    1/(kg m2)
  double viscosity[3][8];              ///< times t: shear, extension less shear, transverse      Pa s m
  double spring[8], dashpot[8];        ///< of the tissue around, times A                         N/m, N s/m
  double face[8];                      ///< where pressure acts, from the mid-surface along n     m
  double keep[2][8], keep_axis[2][8];  ///< constraint: x <- keep x + keep_axis (x . axis) axis for v and w
  double axis[D][8];
  double fibre[2][T][8];  ///< directions of two families in the local frame         -
};

/// A particle as its neighbours see it before and after the stress: one and three cache lines.
struct alignas(64) ShellMotion {
  double u[4], turned[4];  ///< displacement; n - N
};
template <int D>
struct alignas(64) ShellStress {
  double row[tangents<D>][8];  ///< A dPsi/d(dx_a) in 0..3, A dPsi/d(dn_a) in 4..7    N, N m
  double hourglass[8];         ///< A dPsi/dh in 0..3                                 N
};

/// Weights of a pair (a, b). Forward: what b gives to the gradients at a. Backward: what a gives to those at b. In single
/// precision, which halves what has to come from memory: everything of the reference is computed with the weights as they
/// are, so that rounding costs linear fields 1e-7 of their gradient and rotations nothing.
template <int D>
struct ShellWeight {
  float gradient[tangents<D>];  ///< 1/m
  float hourglass;
};

template <int D>
struct alignas(64) ShellLoad {
  double force[D][8];  ///< on each particle, N
  double pressure[8];  ///< on the inner face, along the current normal, Pa
};

/// The stress that a wall carries in its reference: derivatives of the energy per reference area by the strains of strain.hpp
/// and by the zigzag, there and for ever after.
template <int D>
struct alignas(64) ShellPrestress {
  static constexpr int P = tangent_pairs<D>, T = tangents<D>;
  double traction[3 * P + T][8];  ///< membrane, bending, second, shear       N/m, N, N m, N/m
  double zigzag[D][8];            ///< along n, then along the tangents x_a   Pa
};

/// Between the two halves of a step the particle's own part of force and moment; after it the accelerations.
template <int D>
struct alignas(64) ShellForce {
  double force[D][8], moment[D][8];
};

template <int D>
struct ShellRows {
  const std::int64_t* begin;  ///< of each particle, count + 1 of them (whole blocks)
  const std::int32_t* neighbour;
  const ShellWeight<D>*forward, *backward;
};

struct ShellConstants {
  int gauss_points = 3;
  double per_time = 0;          ///< inverse of the time since the strains were stored       1/s
  double kick = 0, drift = 0;   ///< lengths of both                                         s
  double keep = 1, weight = 1;  ///< v <- (keep v + kick a) / weight: mass-proportional damping
};

/// The vector of one lane.
template <int D>
Vec<D> at(const double (&field)[D][8], std::size_t lane) {
  Vec<D> x;
  for (int d = 0; d < D; ++d) x[d] = field[d][lane];
  return x;
}

}  // namespace ostium::sph3d
