/// Where particles come from and go: deletion and insertion at the outer faces of the ducts, and the counted
/// volumes.
///
/// Deletion. A particle of the duct that has passed the outer face (s < 0) is removed.
///
/// Insertion. Every particle of the duct fills a depth V / (area per site) of the sites of the relaxed slice it stands on,
/// shared so that nothing is counted twice; what then is missing below the brim (3/4 of a layer inside the outer face) is
/// the free depth of each site. As soon as the free depths add up to more than nothing, the emptiest site receives a
/// particle: at the brim, farther in or out by what its free depth is more or less than usual. With insertions at the brim
/// on the mean, and the void there kept, the fluid enters at its own density: void is neither made nor lost whatever the
/// profile. There is no memory of who crossed what: reversal, shear and arrival of disordered fluid leave no holes
/// and no overlaps.
///
/// Counting. M = sum V crossed + deleted - inserted is smooth in time and conserves volume to round-off.
/// Deterministic: everything runs in the order of memory and of the sites. Source: docs/theory/openings.md.
#pragma once
#include <span>

#include "sph3d/step/state.hpp"
#include "sph3d/step/workspace.hpp"

namespace ostium::sph3d {

/// After the particles have moved: delete, insert, count (PortState::deleted, inserted, counted,
/// cap_pressure).
template <int D>
void renew_ports(const Model<D>& model, VesselState<D>& state, Workspace<D>& work);

/// Only the counting.
template <int D>
void count_ports(const Model<D>& model, VesselState<D>& state, Workspace<D>& work);

}  // namespace ostium::sph3d
