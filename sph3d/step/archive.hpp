/// The state of a vessel and its parts as named arrays (core/archive): what a checkpoint holds of it.
#pragma once
#include "core/archive.hpp"
#include "sph3d/step/state.hpp"

namespace ostium::sph3d {

void archive(Archive& a, Drive& drive);
void archive(Archive& a, PortState& port);
void archive(Archive& a, PressureDatum& datum);
template <int D>
void archive(Archive& a, FluidState<D>& fluid);
template <int D>
void archive(Archive& a, VesselState<D>& state);
template <int D>
void archive(Archive& a, SavedVessel<D>& saved);

}  // namespace ostium::sph3d
