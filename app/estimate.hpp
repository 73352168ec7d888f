/// How large and how long a coupled run will be, before it starts: a rough figure, within about a factor of two.
///
///   N     particles    V / dp^D
///   U, c  m/s          largest velocity expected and sound speed, as the run will have them (app/flow_scales)
///   dt    s            acoustic step, acoustic_cfl h / (c + U), h = 1.3 dp
///   wall  s            N (end / dt) / (2e6 particle-steps per second and core)
#pragma once
#include "app/vessel_setup.hpp"

namespace ostium::app {

struct Estimate {
  double particles = 0, steps = 0, wall = 0, memory = 0;  // -, acoustic steps, s, bytes
};

template <int D>
Estimate estimate(const Case& study, const Setup<D>& setup, int threads);

/// "3142", "127 thousand", "1.2 million"
std::string count_text(double count);
/// "45 s", "12 min", "3.5 h"
std::string duration_text(double seconds);

}  // namespace ostium::app
