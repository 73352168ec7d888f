/// The preparation of an advection step (docs/theory/fluid.md, "One advection step", A), in this order:
///
///   freeze, find_zones, look_around, kernel_sums    see workspace.hpp
///   correct             source = (theta / dt) (sigma/sigma_0 - 1 - psi), sigma = sum W V + filling, sigma_0 with the
///                       disorder there is: spread over the acoustic steps, so that pressure never jumps;
///                       B = M^-1, M = -sum r (x) grad W V + outside moments; rate of the wall friction
///                       writes source, B, friction; then psi takes the half step of density that the last acoustic
///                       step has left, of acoustic_dt, and the records their pressures
///   prepare_forces      viscous acceleration, what pressure acts on, imbalance, drive of the ports
///                       writes prior, G, imbalance, drive; the transport shift is -zeta h^2 times the imbalance
///
/// Density is left alone where the support ends (within reach of an outer face) and where flow is prescribed.
#pragma once
#include "sph3d/step/phases.hpp"
#include "sph3d/step/state.hpp"
#include "sph3d/step/workspace.hpp"

namespace ostium::sph3d {

template <int D>
void correct(const Model<D>& model, FluidState<D>& fluid, Workspace<D>& work, double dt, double acoustic_dt);
template <int D>
void prepare_forces(const Model<D>& model, FluidState<D>& fluid, Workspace<D>& work);

/// All of it, for an advection step of dt in acoustic steps of acoustic_dt.
template <int D>
void prepare_step(const Model<D>& model, FluidState<D>& fluid, Workspace<D>& work, double dt,
                  double acoustic_dt, PhaseSeconds& seconds);

}  // namespace ostium::sph3d
