/// Where particles come from and go: deletion and insertion at the outer faces of the ducts, and the counted
/// volumes.
///
/// Deletion. A particle of the duct that has passed the outer face (s < 0) is removed.
///
/// Insertion. The sites of the relaxed slice stand half a spacing inside the outer face. A site receives a
/// particle as soon as the particle would find the number density of the undisturbed fluid there, emptiest
/// site first; it is then moved inward to the depth where that density is met exactly. There is no memory of
/// who crossed what: flow reversal, shear and arrival of disordered fluid leave no holes and no overlaps. The
/// threshold follows the mean density in the duct slowly (density_trim), so that the inserted fluid is as
/// dense as that of the vessel.
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
