#include "network/row_indices.hpp"

#include <algorithm>

namespace ostium::network {

RowIndices::RowIndices(const std::vector<Index>& indices) : indices_(indices) {
  for (const auto& index : indices_) {
    at_.push_back(watch(index.series));
    of_.push_back(index.kind == Index::Kind::flow_split ? watch(index.of) : at_.back());
  }
}

int RowIndices::watch(int unknown) {
  for (std::size_t i = 0; i < series_.size(); ++i)
    if (series_[i].unknown == unknown) return static_cast<int>(i);
  series_.push_back({.unknown = unknown});
  return static_cast<int>(series_.size()) - 1;
}

void RowIndices::clear() {
  for (auto& s : series_) s = {.unknown = s.unknown};
  begun_ = false;
}

void RowIndices::add(double time, std::span<const double> y) {
  if (!begun_) begin_ = time_ = time;
  const double dt = time - time_;
  for (auto& s : series_) {
    const double value = y[s.unknown];
    if (begun_) s.integral += 0.5 * dt * (s.last + value);
    s.last = value, s.max = std::max(s.max, value), s.min = std::min(s.min, value);
  }
  time_ = time, begun_ = true;
}

double RowIndices::value(std::size_t i) const {
  const auto& s = series_[at_[i]];
  switch (indices_[i].kind) {
    case Index::Kind::mean:
      return s.integral / (time_ - begin_);
    case Index::Kind::max:
      return s.max;
    case Index::Kind::min:
      return s.min;
    case Index::Kind::pulse:
      return s.max - s.min;
    case Index::Kind::stroke_volume:
      return indices_[i].of_volume ? s.max - s.min : s.integral;
    case Index::Kind::ejection_fraction:
      return (s.max - s.min) / s.max;
    case Index::Kind::flow_split:
      return s.integral / series_[of_[i]].integral;
  }
  return 0;
}

void RowIndices::write(std::span<double> values) const {
  for (std::size_t i = 0; i < indices_.size(); ++i) values[i] = value(i);
}

}  // namespace ostium::network
