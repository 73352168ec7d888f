/// Mean, least and largest value of some series in each cycle, and how periodic they have become.
///
///   mean = (1/T) int_cycle x dt,  trapezoids, a sample interval across the end of a cycle shared by both cycles
///   change = |mean_n - mean_(n-1)| / (max_n - min_n, or |mean_n| if larger)
///
///   T  s  period; 0: the whole run is one cycle
#pragma once
#include <span>
#include <vector>

#include "core/archive.hpp"

namespace ostium::app {

struct CycleValues {
  double mean = 0, min = 0, max = 0;
  double duration = 0;  // s, less than a period for a cycle cut short
};

class CycleStatistics {
 public:
  explicit CycleStatistics(double period = 0, std::size_t series = 1) : period_(period), last_(series) {}
  std::size_t series() const { return last_.size(); }
  void add(double time, std::span<const double> values);  // one per series; times must increase
  void add(double time, double value) { add(time, {&value, 1}); }
  std::vector<CycleValues> cycles(std::size_t series = 0) const;
  /// Change of the mean between the last two complete cycles; 1 when there are fewer.
  double change(std::size_t series = 0) const;
  void archive(Archive& a);

 private:
  void piece(std::size_t cycle, double t0, const double* x0, double t1, const double* x1);

  double period_, time_ = 0;
  bool started_ = false;
  std::vector<double> last_;                  // value of each series at time_
  std::vector<double> duration_;              // per cycle
  std::vector<double> integral_, min_, max_;  // of all series in the first cycle, in the second one, ..
};

}  // namespace ostium::app
