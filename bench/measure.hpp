/// Timing of competing pieces of code in one process: run in turn, again and again, so that a drifting machine slows all
/// of them alike; best and median are quoted, and ratios are taken pair by pair.
#pragma once
#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <vector>

namespace ostium::bench {

inline double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

struct Contender {
  std::string name;
  std::function<void()> run;
  std::vector<double> times = {};  // s

  double best() const { return *std::min_element(times.begin(), times.end()); }
  double median() const { return middle(times); }
  /// Median over the rounds of other's time over this one's.
  double ratio(const Contender& other) const {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < times.size(); ++k) ratios.push_back(other.times[k] / times[k]);
    return middle(ratios);
  }

 private:
  static double middle(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
    return values[values.size() / 2];
  }
};

inline void interleave(std::vector<Contender>& contenders, int rounds) {
  for (int round = -1; round < rounds; ++round)  // the first one warms up
    for (Contender& c : contenders) {
      const double begin = seconds();
      c.run();
      if (round >= 0) c.times.push_back(seconds() - begin);
    }
}

}  // namespace ostium::bench
