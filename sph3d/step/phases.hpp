/// Where the time of a vessel's steps goes, and what limits their length.
///
///   acoustic    kicks and densities of the acoustic steps, what the wall adds to a kernel included
///   driving     of the ports, in every acoustic step
///   advection   what is done once per advection step: neighbours, kernel sums, gradients, shift, motion
///   walls       looking up what the wall fills around every particle, once per advection step; motion of the wall
///   renewal     removal, insertion and counting of particles at the openings, once per advection step
#pragma once
#include <chrono>

namespace ostium::sph3d {

struct PhaseSeconds {
  double acoustic = 0, driving = 0, advection = 0, walls = 0, renewal = 0;  // s of wall time

  PhaseSeconds& operator+=(const PhaseSeconds& other) {
    acoustic += other.acoustic;
    driving += other.driving;
    advection += other.advection;
    walls += other.walls;
    renewal += other.renewal;
    return *this;
  }
  double openings() const { return driving + renewal; }
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
