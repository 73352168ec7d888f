/// Fills a vessel and its ducts with fluid particles.
///
/// The ducts receive copies of their slices, layer by layer; the rest a cubic lattice, of which exactly as
/// many points are kept as the volume asks for; then the rest is relaxed with the layers fixed
/// (docs/theory/particles.md). Every particle has the volume dp^D, and their number times it is the volume of
/// the domain to half a particle.
#pragma once
#include "sph3d/fluid/fluid_state.hpp"
#include "sph3d/openings/slice.hpp"
#include "sph3d/step/model.hpp"

namespace ostium::sph3d {

struct FillOptions {
  int iterations = 0;                         ///< of the relaxation; 0: 200 in 3D, 1000 in 2D
  std::function<void(double)> progress = {};  ///< share done, 0 to 1
};

template <int D>
FluidState<D> fill(const Model<D>& model, const FillOptions& options = {});

}  // namespace ostium::sph3d
