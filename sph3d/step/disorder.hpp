/// What the order of the particles does to their kernel sums, told from density by the blood that is counted.
///
///   mean_sum            <sum W V + filling> of the particles between the caps                         -
///   undisturbed_sum     the same of fluid of density 1 + psi, over that density                       -
///   content             volume of the blood between the caps, at rho0: what came in less what went    m^D
///                       out, to round-off
///   follow_content      d disorder/dt = (<sum>/sigma_0 - N/N_0) / settling_time, for rigid walls; while particles
///                       find their places at the start, N_0 follows instead
///
/// Sums are those of the last kernel_sums. Source: docs/theory/fluid.md, "Density from positions".
#pragma once
#include "sph3d/step/state.hpp"
#include "sph3d/step/workspace.hpp"

namespace ostium::sph3d {

/// `otherwise`: where there is no particle between the caps.
template <int D>
double mean_sum(const Model<D>& model, const FluidState<D>& fluid, const Workspace<D>& work,
                double otherwise);

template <int D>
double undisturbed_sum(const Model<D>& model, FluidState<D>& fluid, Workspace<D>& work, double psi);

template <int D>
double content(const VesselState<D>& state);

template <int D>
void follow_content(const Model<D>& model, VesselState<D>& state, const Workspace<D>& work, double dt);

}  // namespace ostium::sph3d
