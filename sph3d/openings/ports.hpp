/// What the openings do to the fluid in every acoustic step, between the kick and the density update.
///
///   pressure-driven   v <- v + dt P n.drive n  with P from the law at the new flow (implicit, passive for
///   any resistance),
///                     then v <- (v.n) n: no cross-flow in the duct
///   flow-driven       v <- -n (Q/A) shape: a conveyor, Q with a small trim that makes the counted volume
///   follow exactly
///
///   in the duct       the law holds at the cap, P acts at the outer face: less by the friction of the duct's wall, more by
///                     its weight and, where the law has resistance enough, less by its inertance
///
///   conjugate flow    Q_c = sum V (v.n) drive           beta = sum V drive^2 / rho0
///
/// Serial over the few particles of the ducts, in the order of memory. Source: docs/theory/openings.md.
#pragma once
#include <span>

#include "sph3d/step/state.hpp"
#include "sph3d/step/workspace.hpp"

namespace ostium::sph3d {

/// dt of the acoustic step that ends at state.time + dt; filter_time of the complementary filter, both in s.
template <int D>
void drive_ports(const Model<D>& model, VesselState<D>& state, Workspace<D>& work,
                 std::span<const Drive> drives, double dt, double filter_time);

}  // namespace ostium::sph3d
