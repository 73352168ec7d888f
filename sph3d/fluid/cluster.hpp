/// The layout of the fluid kernels: what belongs to a cluster of eight particles, and what a neighbour shows
/// of itself.
///
/// Particles lie in an order in which every eight consecutive ones are close to each other. The side that is
/// summed for (i) is one aligned block per cluster; the side that is summed over (j) is a 16-byte record per
/// particle. During one advection step the positions in both are frozen: weights are recomputed, never
/// stored.
///
///   symbol   meaning                                                                   unit
///   x        frozen position relative to a local origin, over the reach 2h             -
///   v        velocity                                                                  m/s
///   psi      density deviation rho/rho0 - 1;  pressure over density P = c^2 psi        -, m2/s2
///   rate     d psi/dt left by the last acoustic step                                   1/s
///   diss     acceleration by the velocity-jump dissipation of the last acoustic step   m/s2
///   prior    acceleration frozen for the advection step (viscosity, gravity)           m/s2
///   G        sum_j B_j grad W V_j + 2 B_i grad S (wall) - along (1 - nn) B_i sum_j grad W V_j     1/m
///   B        correction matrix, upper triangle row by row                              -
///   k0       sum_j W' V_j                                                              1/m
///   wall     grad S of the wall                                                        1/m
///   along    m/(1 - m), m the share of gradients along the wall that lies in it, at most 1; 0 near outer faces    -
///   moved    displacement since the positions were frozen                              m
///   friction rate at which the wall slows the particle, taken implicitly                 1/s
///   source   rate at which psi returns to the number density                             1/s
///   acceleration   its square, of the last kick                                           m2/s4
///   kV       (10 alpha / h^(D+1)) V:  grad W V = -kV (1 - r)^3 x_ij with x over 2h     1/m
///
/// Source: docs/theory/fluid.md, section "Discrete equations".
#pragma once
#include <cstdint>

namespace ostium::sph3d {

template <int D>
inline constexpr int symmetric_size = D*(D + 1) / 2;

template <int D>
struct alignas(64) Cluster {
  float x[D][8], v[D][8];
  float psi[8], rate[8];
  float diss[D][8], prior[D][8], G[D][8], B[symmetric_size<D>][8];
  float k0[8], wall[D][8], along[8], moved[D][8];
  float friction[8], source[8], acceleration[8];
};

/// Kernel sums of the advection step that the acoustic steps do not need.
template <int D>
struct alignas(64) ClusterSums {
  float density[8];                    ///< sum_j W V_j, the particle itself included          -
  float gradient[D][8];                ///< sum_j grad W V_j                                   1/m
  float moment[symmetric_size<D>][8];  ///< -sum_j r_ij (x) grad W V_j                         -
  float imbalance[D][8];               ///< B_i gradient + G_i, wall included: where room is not even   1/m
};

/// What stands around each particle besides others: the wall, as the half-space that fills as much, and the outside of
/// an opening.
template <int D>
struct alignas(64) ClusterSurroundings {
  float filling[8];                    ///< share of the kernel support in the wall            -
  float moment_n[8], moment_t[8];      ///< moment matrix of that half-space, along its normal and across  -
  float friction_n[8], friction_t[8];  ///< what its friction makes of B, see half_space.hpp   1/m2
  float open_filling[8];               ///< share beyond the outer face of a duct              -
  float open_flux[D][8];               ///< its gradient, out of the vessel                    1/m
};

struct alignas(16) PlaceRecord {
  float x, y, z, w;  ///< position over 2h; w = kV P during the acoustic steps
};
struct alignas(16) VelocityRecord {
  float x, y, z, unused;
};
struct alignas(32) MatrixRecord {
  float b[8];  ///< B of the neighbour (3 or 6 numbers)
};

/// Rows of one cluster: indices of every particle within reach of any of the eight. Some entries past the
/// end can be read too, and are places.
struct Rows {
  const std::int32_t* begin;
  std::int32_t count;
};

/// Coordinates of an empty place, out of everybody's reach.
inline constexpr float far_away = 1e6f;

/// Positions of a cluster side by side, for searches; empty places are where nobody finds them.
template <int D>
struct alignas(32) Points {
  float x[D][8];
};

/// Eight boxes side by side: corners of clusters, or of groups of eight of them, and so on.
template <int D>
struct alignas(32) Boxes {
  float low[D][8], high[D][8];
};
template <int D>
struct Box {
  float low[D], high[D];
};

/// Velocity of the wall as the particles of a cluster feel it, m/s.
template <int D>
struct alignas(32) WallVelocity {
  float v[D][8] = {};
};

/// Constants of a step, the same for all clusters.
struct FluidConstants {
  float c = 0, c2 = 0;       ///< sound speed, its square                       m/s
  float reach = 0;           ///< 2h                                            m
  float kV = 0;              ///< of every particle, see above                  1/m
  float density_factor = 0;  ///< W V = density_factor kV (1-r)^4 (1+4r)        m
  float viscosity = 0;       ///< kinematic viscosity                           m2/s
  float limiter = 0;         ///< of the pressure dissipation, 3; 0 turns it off
  float damping = 0;         ///< 2 nu / 2h, the speed with which viscosity damps jumps over a reach  m/s
  float gravity[3] = {};     ///< body force per mass                           m/s2
  float number_density = 1;  ///< of the undisturbed fluid                      -
  float rest_volume = 1;     ///< of a particle at the pressure of the start, over that at pressure 0
  float correction = 0;      ///< rate at which psi returns to the sum, theta/dt 1/s
};

/// The fluid kernels of one dimension, compiled for one instruction set.
template <int D>
struct FluidKernels {
  /// density, gradient, moment and k0 of the clusters [begin, end).
  void (*sums)(std::int64_t begin, std::int64_t end, Cluster<D>*, ClusterSums<D>*, const Rows*,
               const PlaceRecord*, const FluidConstants&);
  /// B from the moments of fluid and wall, with its record; friction; source. Then psi advances by half an acoustic step
  /// of dt, the half that `density` has left, and place.w shows the pressure.
  void (*corrections)(std::int64_t begin, std::int64_t end, Cluster<D>*, const ClusterSums<D>*,
                      const ClusterSurroundings<D>*, MatrixRecord*, PlaceRecord*, const FluidConstants&,
                      float dt);
  /// G, prior and imbalance.
  void (*corrected_sums)(std::int64_t begin, std::int64_t end, Cluster<D>*, ClusterSums<D>*, const Rows*,
                         const PlaceRecord*, const VelocityRecord*, const MatrixRecord*,
                         const FluidConstants&);
  /// First half of an acoustic step: pressure forces and the pressure-jump part of the density rate, then the
  /// kick. Reads place (w = kV P) and writes velocity; `moved` receives half a drift before and after the
  /// kick. The wall's velocity is that of every cluster, or null where walls are at rest.
  void (*kick)(std::int64_t begin, std::int64_t end, Cluster<D>*, const Rows*, const PlaceRecord*,
               VelocityRecord*, const WallVelocity<D>*, const FluidConstants&, float dt);
  /// Second half: divergence and dissipation, then density and pressure. Reads velocity and writes place.w;
  /// psi advances by `weight` dt (1, or 1/2 at the end of an advection step).
  void (*density)(std::int64_t begin, std::int64_t end, Cluster<D>*, const Rows*, PlaceRecord*,
                  const VelocityRecord*, const WallVelocity<D>*, const FluidConstants&, float dt,
                  float weight);
  /// Points and boxes of clusters; an empty one has low above high.
  void (*bound)(std::int64_t begin, std::int64_t end, const Cluster<D>*, Points<D>*, Boxes<D>*);
  /// Of the boxes in these eights, the indices (8 eight + lane) of those within reach of a box; returns their number.
  std::int32_t (*boxes_within_reach)(const Box<D>&, const Boxes<D>*, const std::int32_t* eights,
                                     std::int32_t count, std::int32_t* out);
  /// Of the particles in these clusters, the indices of those within reach of any of the eight in a cluster, which has that
  /// box; returns their number. out has room for all of them.
  std::int32_t (*within_reach)(const Cluster<D>&, const Box<D>&, const Points<D>*,
                               const std::int32_t* clusters, std::int32_t count, std::int32_t* out);
  const char* name;
};

/// The fastest kernels this processor can run.
template <int D>
const FluidKernels<D>& fluid_kernels();

}  // namespace ostium::sph3d
