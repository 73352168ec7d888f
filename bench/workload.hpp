/// What is measured: a straight tube of about so many particles, or a vessel from a file; both with blood in motion.
#pragma once
#include <vector>

#include "bench/bench.hpp"
#include "sph3d/step/workspace.hpp"
#include "sph3d/vessel.hpp"

namespace ostium::bench {

/// Four diameters long.
sph3d::Lumen<3> tube_of(double particles, double spacing);
/// The file of the options, or a generated arch.
sph3d::Lumen<3> engine_vessel(const Options& options, std::string& name);

/// Filled, with an inflow at the first opening, and some steps old.
sph3d::Vessel<3> flowing(const sph3d::Lumen<3>& lumen, double spacing);
/// Flow into the first opening; every other one answers with its own acoustic impedance.
std::vector<sph3d::Drive> drives_of(const sph3d::Vessel<3>& vessel);

/// A fluid in motion with its advection step prepared: what the parts of a step are measured on.
struct Prepared {
  const sph3d::Model<3>& model;
  sph3d::FluidState<3> fluid;
  sph3d::Workspace<3> work;

  explicit Prepared(const sph3d::Vessel<3>& vessel);
  std::int64_t clusters() const { return static_cast<std::int64_t>(fluid.clusters.size()); }

  void sums(const sph3d::FluidKernels<3>& kernels, std::int64_t begin, std::int64_t end);
  void corrections(const sph3d::FluidKernels<3>& kernels, std::int64_t begin, std::int64_t end);
  void corrected_sums(const sph3d::FluidKernels<3>& kernels, std::int64_t begin, std::int64_t end);
  void kick(const sph3d::FluidKernels<3>& kernels, std::int64_t begin, std::int64_t end);
  void density(const sph3d::FluidKernels<3>& kernels, std::int64_t begin, std::int64_t end);
  void show_pressures();
};

inline constexpr float still = 1e-9f;  // s, of an acoustic step: repeated steps leave the fluid as it is

}  // namespace ostium::bench
