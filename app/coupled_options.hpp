/// From the case and its scales to the options of the fluid and of the coupling.
#pragma once
#include "app/flow_scales.hpp"
#include "coupling/run.hpp"

namespace ostium::app {

template <int D>
sph3d::FluidOptions<D> fluid_options(const Case& study, const FlowScales& scales);

coupling::CoupledOptions coupled_options(const Case& study, const FlowScales& scales);

}  // namespace ostium::app
