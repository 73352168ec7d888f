/// The two passes of a shell step over blocks [begin, end), compiled for each instruction set.
///
///   stress   gradients, strains and stresses at a, from the motion around it
///            reads motion, block (n), load (pressure), prestress; writes force (own part), stress, block (strain)
///   kick     balance of force and moment, support, kick, drift
///            reads stress, load; writes block (u, v, n, w), motion, force (accelerations)
///
/// Source: docs/theory/shell.md, section "One step".
#pragma once
#include "sph3d/shell/block.hpp"
#include "sph3d/structure/material.hpp"

namespace ostium::sph3d {

template <int D>
struct ShellArrays {
  const ShellReference<D>* reference;
  ShellRows<D> rows;
  const ShellLoad<D>* load;
  ShellBlock<D>* block;
  ShellMotion* motion;  ///< of each particle
  ShellStress<D>* stress;
  ShellForce<D>* force;                ///< of each block
  const ShellPrestress<D>* prestress;  ///< of each block, or null
};

template <int D>
struct ShellKernels {
  void (*stress)(std::int64_t begin, std::int64_t end, const ShellArrays<D>&, const Material&,
                 const ShellConstants&);
  void (*kick)(std::int64_t begin, std::int64_t end, const ShellArrays<D>&, const ShellConstants&);
  /// Turns and moves without a kick; fills motion.
  void (*drift)(std::int64_t begin, std::int64_t end, const ShellArrays<D>&, const ShellConstants&);
  const char* name;
};

/// The fastest kernels this processor can run.
template <int D>
const ShellKernels<D>& shell_kernels();

}  // namespace ostium::sph3d
