/// The indices of network/indices from rows of the series: as fine as the rows are, as in the summary of a run.
///
///   mean, stroke volume of a flow    trapezoids over the rows;      max, min    the largest and the least row
///
/// For runs without derivatives. Not checked: that the rows resolve the series.
#pragma once
#include <limits>
#include <span>
#include <vector>

#include "network/indices.hpp"

namespace ostium::network {

class RowIndices {
 public:
  explicit RowIndices(const std::vector<Index>& indices);
  /// Forgets all rows.
  void clear();
  /// y: all series of the network, SI.
  void add(double time, std::span<const double> y);
  /// One value per index, SI.
  void write(std::span<double> values) const;

 private:
  struct Series {
    int unknown = 0;
    double integral = 0, last = 0;
    double max = -std::numeric_limits<double>::infinity(), min = std::numeric_limits<double>::infinity();
  };
  int watch(int unknown);
  double value(std::size_t index) const;

  std::vector<Index> indices_;
  std::vector<int> at_, of_;  // places in series_
  std::vector<Series> series_;
  double begin_ = 0, time_ = 0;
  bool begun_ = false;
};

}  // namespace ostium::network
