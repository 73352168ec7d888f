#include "sph3d/fluid/fluid_state.hpp"

#include <algorithm>

#include "core/large_pages.hpp"
#include "sph3d/neighbours/order.hpp"

namespace ostium::sph3d {

namespace {

constexpr double nowhere = 1e6;  // far outside any vessel, in metres

/// All floats of one lane of a cluster, whatever they mean: a cluster is rows of eight floats.
template <int D>
constexpr std::size_t rows_of_eight = sizeof(Cluster<D>) / (8 * sizeof(float));

template <int D>
void copy_lane(const Cluster<D>& from, std::size_t a, Cluster<D>& to, std::size_t b) {
  const float* source = reinterpret_cast<const float*>(&from) + a;
  float* target = reinterpret_cast<float*>(&to) + b;
  for (std::size_t row = 0; row < rows_of_eight<D>; ++row) target[8 * row] = source[8 * row];
}

}  // namespace

template <int D>
std::size_t FluidState<D>::count() const {
  return static_cast<std::size_t>(std::count(filled.begin(), filled.end(), 1));
}

template <int D>
Vec<D> FluidState<D>::velocity(std::size_t i) const {
  Vec<D> v;
  for (int d = 0; d < D; ++d) v[d] = clusters[i / 8].v[d][i % 8];
  return v;
}

template <int D>
void FluidState<D>::velocity(std::size_t i, const Vec<D>& v) {
  for (int d = 0; d < D; ++d) clusters[i / 8].v[d][i % 8] = static_cast<float>(v[d]);
}

template <int D>
void FluidState<D>::clear(std::size_t i) {
  static const Cluster<D> nothing{};
  copy_lane(nothing, 0, clusters[i / 8], i % 8);
  position[i] = Vec<D>::Constant(nowhere);
  filled[i] = 0;
}

template <int D>
std::size_t FluidState<D>::insert(const Vec<D>& x) {
  std::size_t i = places() < 8 ? places() : places() - 8;
  while (i < places() && filled[i]) ++i;
  if (i == places()) {
    clusters.emplace_back();
    position.resize(places() + 8, Vec<D>::Constant(nowhere));
    filled.resize(places(), 0);
    for (std::size_t k = i; k < places(); ++k) clear(k);
  }
  clear(i);
  position[i] = x;
  filled[i] = 1;
  return i;
}

template <int D>
void FluidState<D>::remove(std::size_t i) {
  clear(i);
}

template <int D>
void FluidState<D>::reorder(FluidState& spare) {
  std::vector<Vec<D>> points;
  std::vector<std::size_t> place;
  points.reserve(places());
  place.reserve(places());
  for (std::size_t i = 0; i < places(); ++i)
    if (filled[i]) {
      points.push_back(position[i]);
      place.push_back(i);
    }
  if (points.empty()) return;
  const auto order = bisection_order<D>(points);
  const std::size_t total = (points.size() + 7) / 8 * 8;
  spare.volume = volume;
  spare.disorder = disorder;
  resize_in_large_pages(spare.position, total);
  spare.filled.assign(total, 1);
  resize_in_large_pages(spare.clusters, total / 8);
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::size_t i = place[order[k]];
    spare.position[k] = position[i];
    copy_lane(clusters[i / 8], i % 8, spare.clusters[k / 8], k % 8);
  }
  for (std::size_t k = points.size(); k < total; ++k) spare.clear(k);
  std::swap(*this, spare);
}

template <int D>
FluidState<D> fluid_at(std::span<const Vec<D>> points, double volume) {
  FluidState<D> state;
  state.volume = volume;
  for (const Vec<D>& x : points) state.insert(x);
  FluidState<D> spare;
  state.reorder(spare);
  return state;
}

template struct FluidState<2>;
template struct FluidState<3>;
template FluidState<2> fluid_at<2>(std::span<const Vec<2>>, double);
template FluidState<3> fluid_at<3>(std::span<const Vec<3>>, double);

}  // namespace ostium::sph3d
