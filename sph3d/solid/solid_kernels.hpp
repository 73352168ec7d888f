/// The two sums of a solid's step over its pairs, compiled per instruction set. Internal to solid/.
///
///   stresses   H_a = F_a - I, E, S and T_a = F_a S_a B_a - alpha mu H_a        from the displacements
///   forces     rho a_a = sum_b (T_a + T_b) grad W_ab V_b + springs (u_b - u_a)
///
/// Displacements and the columns of T are padded to whole vector registers: one load each, no gathers. Source:
/// docs/theory/solid.md.
#pragma once
#include <cstdint>

#include "sph3d/fluid/instruction_set.hpp"
#include "sph3d/structure/material.hpp"

namespace ostium::sph3d {

template <int D>
inline constexpr int padded = D == 3 ? 4 : 2;

/// Arrays of one step; see SolidModel and SolidState for their shapes.
template <int D>
struct SolidPass {
  const std::int64_t* row;
  const std::int32_t* neighbour;
  const double *weight, *correction, *factor, *fibre;
  std::size_t count;
  double hourglass;  ///< alpha mu, Pa
  double per_time;   ///< viscosity over the time since the strain was last taken, Pa; 0 at the start
  double* strain;
  double* displacement;  ///< padded<D> numbers per particle
  double* stress;        ///< T, D columns of padded<D> numbers per particle
  double* force;         ///< rho a, padded<D> numbers per particle, Pa/m
};

template <int D>
struct SolidKernels {
  void (*stresses)(std::size_t begin, std::size_t end, const SolidPass<D>&,
                   const Material&);                                        ///< groups of four
  void (*forces)(std::size_t begin, std::size_t end, const SolidPass<D>&);  ///< particles
};

/// Those of this processor.
template <int D>
const SolidKernels<D>& solid_kernels();

}  // namespace ostium::sph3d
