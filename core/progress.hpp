/// How far a run is: one updating line on a terminal, a plain line every few seconds in a pipe
/// (none for a run shorter than that).
///
///   0.412 / 1.32 s  cycle 1  31 %  212 steps/s  ETA 2:41  max 0.83 m/s
#pragma once
#include <chrono>
#include <cstdio>
#include <limits>
#include <string>

namespace ostium {

class Progress {
 public:
  struct Options {
    double start = 0, end = 1;  // s, simulated time
    double period = 0;          // s; 0: no cycles
    std::FILE* stream = stdout;
    bool quiet = false;
    std::string task =
        {};  // named instead of times and steps where there are none: "filling the vessel  40 %  ETA 0:08"
    double pipe_interval = 5, terminal_interval = 0.2;  // s of wall time between two lines
  };
  explicit Progress(Options options);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Call after each step; cheap when no line is due. `extra` is appended ("max 0.83 m/s, mean 91 mmHg").
  void update(double time, long steps, const std::string& extra = {});
  /// Whether the next update will print: lets the caller skip preparing `extra`.
  bool due() const;
  void finish();

  /// The line for a given state and wall time in s; what update prints.
  static std::string line(const Options& options, double time, long steps, double wall,
                          const std::string& extra);

 private:
  using Clock = std::chrono::steady_clock;
  double seconds_since(Clock::time_point t) const;

  Options options_;
  bool terminal_;
  Clock::time_point started_, printed_;
  std::string last_;
};

}  // namespace ostium
