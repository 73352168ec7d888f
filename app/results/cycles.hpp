/// Mean, least and largest value of a series in each cycle, and how periodic it has become.
///
///   mean = (1/T) int_cycle x dt,  trapezoids, a sample interval across the end of a cycle shared by both cycles
///   change = |mean_n - mean_(n-1)| / (max_n - min_n, or |mean_n| if larger)
///
///   T  s  period; 0: the whole run is one cycle
#pragma once
#include <vector>

#include "core/archive.hpp"

namespace ostium::app {

struct CycleValues {
  double mean = 0, min = 0, max = 0;
  double duration = 0;  // s, less than a period for a cycle cut short
};

class CycleStatistics {
 public:
  explicit CycleStatistics(double period = 0) : period_(period) {}
  void add(double time, double value);  // times must increase
  std::vector<CycleValues> cycles() const;
  /// Change of the mean between the last two complete cycles; 1 when there are fewer.
  double change() const;
  void archive(Archive& a);

 private:
  struct Cycle {
    double integral = 0, min = 0, max = 0, duration = 0;
  };
  void piece(long cycle, double t0, double x0, double t1, double x1);

  long cycle_at(double time) const;

  double period_, time_ = 0, value_ = 0;
  bool started_ = false;
  std::vector<Cycle> cycles_;
  long cycle_ = 0;    // that of the last time, once there were two of them ..
  double turn_ = -1;  // .. and its end: a row before needs no second look
};

}  // namespace ostium::app
