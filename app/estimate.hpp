/// How large and how long a coupled run will be, before it starts.
///
///   N         particles   V / dp^D, in the vessel;  M  with those of the ducts
///   U, c, nu              largest velocity expected and sound speed, as the run will have them (app/flow_scales), m/s; m2/s
///   dt        s           acoustic step, acoustic_cfl h / (c + U), h = 1.3 dp
///   Dt        s           advection step, advection_cfl h / max((U_ref + U) / 2, nu / h), at most 8 dt
///   wall      s           A / dp^(D-1) modelling + M (filling + (end / dt) acoustic + (end / Dt) advection), A the wall;
///                         speeds from app/calibration; of a wall that moves as for blood, by a fixed ratio
///
/// The mean of the floor U_ref and the peak U stands for the velocity over a heart beat. Not counted: network, fields, tables;
/// what else the machine does at the time.
#pragma once
#include "app/calibration.hpp"
#include "app/vessel_setup.hpp"

namespace ostium::app {

struct Estimate {
  double particles = 0, steps = 0, advection_steps = 0;  // -, acoustic steps, advection steps
  double wall = 0, memory = 0;                           // s, bytes
};

template <int D>
Estimate estimate(const Case& study, const Setup<D>& setup, const Calibration& speed);

/// "3142", "127 thousand", "1.2 million"
std::string count_text(double count);
/// "0.4 s", "45 s", "12 min", "3.5 h"; never "0 s"
std::string duration_text(double seconds);

}  // namespace ostium::app
