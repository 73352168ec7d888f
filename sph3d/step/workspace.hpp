/// What an advection step derives from the state and forgets again: neighbour rows, records, kernel sums,
/// zones.
#pragma once
#include <cstdint>
#include <vector>

#include "sph3d/fluid/fluid_state.hpp"
#include "sph3d/neighbours/row_lists.hpp"
#include "sph3d/step/model.hpp"
#include "sph3d/walls/wall_motion.hpp"

namespace ostium::sph3d {

/// The particles in a duct, in the order of memory.
template <int D>
struct Zone {
  struct Member {
    std::int32_t index;
    float depth;
    /// Pressure-driven: 2 n.B grad(open filling) as the particles see it, what a unit of pressure does, 1/m.
    /// Flow-driven: velocity over Q/A, scaled so that the particles of the duct carry exactly Q.
    float drive;
  };
  std::vector<Member> members;
  std::vector<std::int32_t> before_cap;  ///< particles of the vessel next to the cap
};

template <int D>
struct Workspace {
  std::vector<PlaceRecord> place;
  std::vector<VelocityRecord> velocity;
  std::vector<MatrixRecord> matrix;
  std::vector<ClusterSums<D>> sums;
  std::vector<ClusterSurroundings<D>> around;
  std::vector<std::int8_t> duct_of;  ///< of each place; negative outside the ducts
  std::vector<Zone<D>> zones;        ///< one per duct
  /// Of each duct: clusters that may have a particle in its zone this step.
  std::vector<std::vector<std::int32_t>> near_duct;
  RowLists<D> rows;
  FluidState<D> spare;                         ///< memory for the next ordering
  const WallMotion<D>* wall_motion = nullptr;  ///< where the wall moves
};

/// Copies the positions into clusters and records (over the reach, from the model's origin), rebuilds the rows and finds
/// the clusters near the ducts.
template <int D>
void freeze(const Model<D>& model, FluidState<D>& state, Workspace<D>& work);

/// Which particles stand in which duct; they may have moved by three spacings since they were frozen.
template <int D>
void find_zones(const Model<D>& model, const FluidState<D>& state, Workspace<D>& work);

/// What lies beyond the outer face of duct k, as seen from x: the product of that half-space with what the wall leaves.
/// Its flux is the exact gradient, so that filling and flux agree at the rim.
template <int D>
WallSample<D> beyond_face(const Model<D>& model, int k, const Vec<D>& x, const WallSample<D>& wall);

/// Filling by the wall for the particle in place i, at x when the step began.
template <int D>
WallSample<D> wall_at(const Model<D>& model, const Workspace<D>& work, std::size_t i, const Vec<D>& x);

/// Filling by walls and by the outside of the openings, for every particle.
template <int D>
void look_around(const Model<D>& model, FluidState<D>& state, Workspace<D>& work);

/// Density, gradient and moment sums over the rows (Workspace::sums).
template <int D>
void kernel_sums(const Model<D>& model, FluidState<D>& state, Workspace<D>& work);

/// Constants the kernels share.
template <int D>
FluidConstants constants_of(const Model<D>& model);

}  // namespace ostium::sph3d
