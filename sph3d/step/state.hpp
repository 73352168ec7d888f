/// The whole state of a vessel, plain data: a checkpoint is this written out, a copy is a copy, a restart is
/// exact.
///
/// Volumes and flows are positive when leaving the vessel; pressures are relative to the datum of the fluid
/// solver.
#pragma once
#include <cstdint>
#include <vector>

#include "sph3d/fluid/fluid_state.hpp"
#include "sph3d/openings/port_law.hpp"
#include "sph3d/openings/pressure_datum.hpp"
#include "sph3d/walls/deformable_wall_state.hpp"

namespace ostium::sph3d {

/// What an opening is told until the next exchange: a pressure law, or a flow.
struct Drive {
  double since = 0;                    ///< time of the last exchange                                        s
  PortLaw law;                         ///< pressure-driven
  double flow_in = 0, flow_slope = 0;  ///< flow-driven: into the vessel at `since`, and its rate m3/s, m3/s2
};

struct PortState {
  double inserted = 0, deleted = 0;  ///< volumes of the particles made and deleted                        m3
  double counted = 0;                ///< M = sum V crossed + deleted - inserted                            m3
  double counted_at_start = 0;       ///< m3
  double asked = 0;                  ///< flow-driven: volume asked to leave so far                         m3
  double flow_scale = 0;         ///< flow-driven: largest recent flow, measure of the trim             m3/s
  double conjugate = 0;          ///< Q_c after the last acoustic step                                  m3/s
  double pressure = 0;           ///< of the law (pressure-driven), measured (flow-driven); at the cap  Pa
  double face_pressure = 0;      ///< imposed at the outer face, relative to the datum                  Pa
  double cap_pressure = 0;       ///< mean over the fluid at the cap                                    Pa
  double insertion_level = 0.5;  ///< usual free depth of a site when it receives a particle, in layers   -
  double flow_rate = 0;          ///< slow rate of change of the flow                                   m3/s2
  ComplementaryFilter filter;
};

template <int D>
struct VesselState {
  FluidState<D> fluid;
  std::vector<PortState> ports;
  PressureDatum datum;
  double time = 0;                             ///< s
  double max_speed = 0, max_acceleration = 0;  ///< of the last step, outside the ducts; m/s, m/s2
  double travelled = 0;                        ///< by the fastest particle of every step so far; m
  double reference_content = 0;                ///< at pressure 0, see follow_content; 0: not followed; m3
  DeformableWallState<D> wall;                 ///< empty where the wall is rigid
  std::int64_t steps = 0, acoustic_steps = 0;
  std::int64_t mirrored = 0, escaped = 0;  ///< particles put back inside the wall; lost through it
};

/// What a vessel goes on from in another run of the program.
template <int D>
struct SavedVessel {
  VesselState<D> state;
  double number_density = 0;  ///< of the undisturbed fluid, see Model
  double rest_volume = 1;     ///< likewise
};

}  // namespace ostium::sph3d
