/// Timing of rivals in one process: taken in turn, again and again, so that all of them see the same machine.
///
///   median, best   s   of the rounds after a first one that does not count
///
/// Rivals run on one thread and are timed by its processor time: other work on the machine costs them their caches, not
/// their turn. seconds_of() is wall time.
#pragma once
#include <time.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <vector>

namespace ostium::bench {

struct Timing {
  double median = 0, best = 0;
};

inline double seconds_of(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

inline double thread_seconds() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

inline Timing timing_of(std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  return {seconds[seconds.size() / 2], seconds.front()};
}

inline std::vector<Timing> in_turn(const std::vector<std::function<void()>>& rivals, int rounds) {
  std::vector<std::vector<double>> seconds(rivals.size());
  for (int round = 0; round <= rounds; ++round)
    for (std::size_t k = 0; k < rivals.size(); ++k) {
      const double begin = thread_seconds();
      rivals[k]();
      const double s = thread_seconds() - begin;
      if (round > 0) seconds[k].push_back(s);
    }
  std::vector<Timing> timings;
  for (auto& s : seconds) timings.push_back(timing_of(std::move(s)));
  return timings;
}

}  // namespace ostium::bench
