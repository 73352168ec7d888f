/// Where the time of a vessel's steps goes, and what limits their length.
///
///   advection   what is done once per advection step: neighbours, kernel sums, gradients, shift, motion
///   acoustic    kicks and densities of the acoustic steps
///   openings    driving of the ports in every acoustic step, removal, insertion and counting of particles
///
/// Walls are part of the kernels and of the preparation: their time stands in `advection` and `acoustic` and is not told
/// apart.
#pragma once
#include <chrono>

namespace ostium::sph3d {

struct PhaseSeconds {
  double advection = 0, acoustic = 0, openings = 0;  // s of wall time

  PhaseSeconds& operator+=(const PhaseSeconds& other) {
    advection += other.advection;
    acoustic += other.acoustic;
    openings += other.openings;
    return *this;
  }
};

/// Adds the time it lives to a sum of seconds.
class Stopwatch {
 public:
  explicit Stopwatch(double& sum) : sum_(sum) {}
  ~Stopwatch() { sum_ += std::chrono::duration<double>(Clock::now() - begin_).count(); }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  using Clock = std::chrono::steady_clock;
  double& sum_;
  Clock::time_point begin_ = Clock::now();
};

/// What set the length of an advection step.
///   reference, speed      share of h travelled with the reference speed, with the largest speed
///   acceleration          h over the largest acceleration
///   viscosity             h^2 / nu
///   acoustic              most acoustic steps with the same neighbours
///   stop                  an exchange or the end of the run
enum class StepBound { none, reference, speed, acceleration, viscosity, acoustic, stop };
inline constexpr int step_bounds = 7;

inline const char* name(StepBound bound) {
  constexpr const char* names[step_bounds] = {"none",      "reference", "speed", "acceleration",
                                              "viscosity", "acoustic",  "stop"};
  return names[static_cast<int>(bound)];
}

}  // namespace ostium::sph3d
