/// The fluid as plain data: a checkpoint is this structure written out, a copy is a copy.
///
/// Particles live in places, eight to a cluster; an empty place lies far away and has no volume. All
/// particles carry the same volume V = m/rho0 for ever, so that counted volumes are exact.
///
///   symbol     meaning                                               unit
///   position   of each place, in the frame of the input              m
///   clusters   velocity, density deviation and what steps carry on   see cluster.hpp
///   volume     V of every particle                                   m^D
///   disorder   by how much the order of the particles has raised     -
///              their mean kernel sum since the start, relative
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "core/vec.hpp"
#include "sph3d/fluid/cluster.hpp"

namespace ostium::sph3d {

template <int D>
struct FluidState {
  std::vector<Vec<D>> position;
  std::vector<std::uint8_t> filled;
  std::vector<Cluster<D>> clusters;
  double volume = 0, disorder = 0;

  std::size_t places() const { return position.size(); }
  std::size_t count() const;

  Vec<D> velocity(std::size_t i) const;
  void velocity(std::size_t i, const Vec<D>& v);
  float& psi(std::size_t i) { return clusters[i / 8].psi[i % 8]; }
  float psi(std::size_t i) const { return clusters[i / 8].psi[i % 8]; }

  /// Adds a particle at rest and returns its place; the first empty place of the last cluster, or of a new
  /// one.
  std::size_t insert(const Vec<D>& x);
  void remove(std::size_t i);

  /// Brings the particles into the order of memory that the kernels want and drops the empty places. `spare` is what was used
  /// the last time, for its memory.
  void reorder(FluidState& spare);

 private:
  void clear(std::size_t i);
};

/// A fluid at rest with particles at the given points.
template <int D>
FluidState<D> fluid_at(std::span<const Vec<D>> points, double volume);

}  // namespace ostium::sph3d
