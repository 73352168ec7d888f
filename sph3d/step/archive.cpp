#include "sph3d/step/archive.hpp"

#include <fmt/format.h>

#include "sph3d/shell/archive.hpp"

namespace ostium::sph3d {

// A structure that has grown is not to be saved without what is new in it.
static_assert(sizeof(Drive) == 7 * sizeof(double) && sizeof(PortState) == 14 * sizeof(double));

void archive(Archive& a, Drive& drive) {
  a("since", drive.since);
  a("p_star", drive.law.p_star);
  a("slope", drive.law.slope);
  a("resistance", drive.law.resistance);
  a("q_star", drive.law.q_star);
  a("flow_in", drive.flow_in);
  a("flow_slope", drive.flow_slope);
}

void archive(Archive& a, PortState& port) {
  a("inserted", port.inserted);
  a("deleted", port.deleted);
  a("counted", port.counted);
  a("counted_at_start", port.counted_at_start);
  a("asked", port.asked);
  a("flow_scale", port.flow_scale);
  a("conjugate", port.conjugate);
  a("pressure", port.pressure);
  a("face_pressure", port.face_pressure);
  a("cap_pressure", port.cap_pressure);
  a("insertion_level", port.insertion_level);
  a("flow_rate", port.flow_rate);
  a("filter_counted", port.filter.q_counted);
  a("filter_conjugate", port.filter.q_conjugate);
}

void archive(Archive& a, PressureDatum& datum) {
  a("reference", datum.reference);
  a("background", datum.background);
  a("tau", datum.tau);
  a("weights", datum.weights);
}

template <int D>
void archive(Archive& a, FluidState<D>& fluid) {
  a("volume", fluid.volume);
  a("disorder", fluid.disorder);
  a("filled", fluid.filled);
  a.template records<double>("position", fluid.position);
  a.template records<float>("clusters", fluid.clusters);
  if (fluid.filled.size() != fluid.places() || 8 * fluid.clusters.size() != fluid.places())
    a.misfit("clusters",
             fmt::format("{} clusters of eight for {} places", fluid.clusters.size(), fluid.places()));
}

/// Without the blocks of a shell the wall is a solid.
template <int D>
void archive(Archive& a, DeformableWallState<D>& wall) {
  a.part("shell", [&] { archive(a, wall.shell); });
  if (wall.shell.blocks.empty()) a.part("solid", [&] { archive(a, wall.solid); });
  a.template records<double>("velocity", wall.velocity);
  a.template records<double>("impact", wall.impact);
  a("withheld", wall.withheld);
}

template <int D>
void archive(Archive& a, VesselState<D>& state) {
  a("time", state.time);
  a("max_speed", state.max_speed);
  a("max_acceleration", state.max_acceleration);
  a("travelled", state.travelled);
  a("reference_content", state.reference_content);
  a("steps", state.steps);
  a("acoustic_steps", state.acoustic_steps);
  a("mirrored", state.mirrored);
  a("escaped", state.escaped);
  a.part("fluid", [&] { archive(a, state.fluid); });
  a.part("datum", [&] { archive(a, state.datum); });
  a.list("ports", state.ports, [&](PortState& port) { archive(a, port); });
  bool moves = !state.wall.empty();
  a("wall_moves", moves);
  if (moves) a.part("wall", [&] { archive(a, state.wall); });
}

template <int D>
void archive(Archive& a, SavedVessel<D>& saved) {
  a("number_density", saved.number_density);
  a("rest_volume", saved.rest_volume);
  a.part("state", [&] { archive(a, saved.state); });
}

template void archive(Archive&, FluidState<2>&);
template void archive(Archive&, FluidState<3>&);
template void archive(Archive&, VesselState<2>&);
template void archive(Archive&, VesselState<3>&);
template void archive(Archive&, SavedVessel<2>&);
template void archive(Archive&, SavedVessel<3>&);

}  // namespace ostium::sph3d
