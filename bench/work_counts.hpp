/// What an acoustic step costs by its equations (sph3d/fluid/kernels.inc, D = 3), counted, not measured.
///
///   flop per pair, kick      x 3, r^2 6, root 1, t 2, cube 2, times w 1, force 6, jump 2                            23
///   flop per pair, density   x 3, r^2 6, root 1, t 2, cube 2, approach 8, speed 2, divergence 2, limited 4,
///                            dissipation 6                                                                          36
///   Each of the eight lanes of a cluster meets every entry of its rows; the closing of the sums (about 100 flop) is left out.
///
///   bytes per particle       rows 4 / 8 per entry and pass; the cluster's own fields and the records, once per pass:
///     kick      reads x v psi B G diss prior friction k0 moved (27 floats) and place; writes v moved acceleration rate (8),
///               velocity                                                                                           172
///     density   reads x v wall psi rate source (12) and place; writes diss psi rate (5), place                      100
///   Records of neighbours come from the cache and are counted once.
#pragma once

namespace ostium::bench {

inline constexpr double flop_per_pair = 23 + 36;

inline double flop_per_particle(double row_length) { return flop_per_pair * row_length; }

inline double bytes_per_particle(double row_length) {
  constexpr double index = 4, lanes = 8, passes = 2;
  constexpr double kick = 4 * (27 + 8) + 16 + 16, density = 4 * (12 + 5) + 16 + 16;
  return passes * index * row_length / lanes + kick + density;
}

}  // namespace ostium::bench
