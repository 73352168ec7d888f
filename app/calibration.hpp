/// How fast this machine runs the fluid: a short run of a small duct with the kernels and threads of a production run.
///
///   modelling   s                  wall field and ducts, per dp^(D-1) of wall; an upper figure, the ducts of a large vessel
///                                  are small
///   filling     s/particle         lattice and relaxation
///   acoustic    s/particle/step    one acoustic step
///   advection   s/particle/step    one advection step, without its acoustic steps
///
/// Seconds are wall time, with all threads at work and nothing else on the machine (the fastest steps count). The duct
/// holds some thousand particles, which lie in the caches of most processors: a large vessel is up to a fifth slower.
/// Not measured: network, fields and tables.
#pragma once

namespace ostium::app {

struct Calibration {
  double modelling = 0, filling = 0, acoustic = 0, advection = 0;
};

/// Runs for at most about two seconds; slow machines measure fewer steps.
template <int D>
Calibration calibrate(int threads);

/// An ordinary core's figures, for where nothing may be run; threads share the work evenly.
Calibration nominal_speed(int threads);

}  // namespace ostium::app
