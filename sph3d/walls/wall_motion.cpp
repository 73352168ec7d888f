#include "sph3d/walls/wall_motion.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>

#include "sph3d/step/lane_access.hpp"
#include "sph3d/step/shared_loops.hpp"
#include "sph3d/walls/ball_tree.hpp"
#include "sph3d/walls/smallest_rotation.hpp"

namespace ostium::sph3d {

namespace {

constexpr double width = 1.3;  // smoothing length of the weights, in spacings of the wall points

/// The eight places of a cluster, as a ball.
template <int D>
bool ball_around(const FluidState<D>& fluid, std::size_t c, Vec<D>& middle, double& radius) {
  Vec<D> low = Vec<D>::Constant(1e300), high = -low;
  for (std::size_t i = 8 * c; i < 8 * c + 8; ++i)
    if (fluid.filled[i]) low = low.cwiseMin(fluid.position[i]), high = high.cwiseMax(fluid.position[i]);
  if (low[0] > high[0]) return false;
  middle = 0.5 * (low + high), radius = 0.5 * (high - low).norm();
  return true;
}

/// The kernel's shape: 1 at 0, zero from 1 on.
double bell(double r) {
  const double t = std::max(1.0 - r, 0.0), t2 = t * t;
  return t2 * t2 * (1.0 + 4.0 * r);
}

}  // namespace

template <int D>
WallMotion<D>::WallMotion(std::vector<Vec<D>> reference, std::vector<Vec<D>> normal, double spacing,
                          double reach)
    : reference_(std::move(reference)),
      reference_normal_(std::move(normal)),
      spacing_(spacing),
      reach_(reach) {}

/// Weights about the foot, made exact for linear fields along the wall. Returns their number.
template <int D>
int WallMotion<D>::find_weights(const Vec<D>& x, const std::vector<Near>& near,
                                std::vector<Entry>& out) const {
  const Near* nearest = nullptr;
  double least = felt_ * felt_ + spacing_ * spacing_;
  for (const Near& a : near) {
    const Vec<D> apart = a.position - x;
    const double distance2 = apart.squaredNorm();
    if (distance2 >= least || apart.dot(a.normal) < -0.5 * spacing_) continue;
    nearest = &a, least = distance2;
  }
  if (!nearest) return 0;
  const Vec<D>& n = nearest->normal;
  const double depth = (nearest->position - x).dot(n);
  if (depth > felt_) return 0;
  const Vec<D> foot = x + depth * n;
  const double support = 2.0 * width * spacing_;
  const std::size_t begin = out.size();
  double whole = 0;
  Vec<D> first = Vec<D>::Zero();
  Mat<D> second = spacing_ * spacing_ * (1e-3 * Mat<D>::Identity() + 1e6 * n * n.transpose());
  for (const Near& a : near) {
    const Vec<D> apart = a.position - foot;
    const double distance2 = apart.squaredNorm();
    if (distance2 >= support * support || a.normal.dot(n) <= 0.0) continue;
    const double w = bell(std::sqrt(distance2) / support);
    out.push_back({a.index, static_cast<float>(w)});
    whole += w, first += w * apart, second += w * apart * apart.transpose();
  }
  if (whole <= 0.0) return 0;
  const Vec<D> slope = second.inverse() * first;  // no part along the normal
  const double sum = whole - slope.dot(first);
  for (std::size_t k = begin; k < out.size(); ++k)
    out[k].weight = static_cast<float>(
        out[k].weight *
        (sum > 0.2 * whole ? (1.0 - slope.dot(pose_[out[k].index].position - foot)) / sum : 1.0 / whole));
  return static_cast<int>(out.size() - begin);
}

template <int D>
void WallMotion<D>::attach(const FluidState<D>& fluid, const std::vector<Vec<D>>& now,
                           const std::vector<Vec<D>>& normal) {
  pose_.resize(now.size());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < now.size(); ++a)
    pose_[a] = {now[a], normal[a], smallest_rotation<D>(reference_normal_[a], normal[a])};
  felt_ = reach_;
  for (std::size_t a = 0; a < now.size(); ++a)
    felt_ = std::max(felt_, reach_ + (now[a] - reference_[a]).norm());
  const std::size_t clusters = fluid.clusters.size();
  lists_.assign(fluid.places(), {});
  velocity_.assign(clusters, {});
  moved_.assign(clusters, {});
  storage_.resize(omp_get_max_threads());
  const double furthest = std::hypot(felt_, 2.0 * width * spacing_), largest = reach_;
  const BallTree<D> tree(now);
#pragma omp parallel
  {
    const auto me = static_cast<std::int32_t>(omp_get_thread_num());
    auto& mine = storage_[me];
    mine.clear();
    std::vector<Near> near;
#pragma omp for schedule(static)
    for (std::size_t c = 0; c < clusters; ++c) {
      Vec<D> middle;
      double radius = 0;
      if (!ball_around(fluid, c, middle, radius)) continue;
      const bool compact = radius < largest;
      const auto collect = [&](const Vec<D>& x, double within) {
        near.clear();
        tree.near(x, within, [&](std::int32_t a) {
          near.push_back({pose_[a].position, pose_[a].normal, a});
        });
      };
      if (compact) collect(middle, furthest + radius);
      if (compact && near.empty()) continue;
      for (std::size_t i = 8 * c; i < 8 * c + 8; ++i) {
        if (!fluid.filled[i]) continue;
        if (!compact) collect(fluid.position[i], furthest);
        const auto begin = static_cast<std::int64_t>(mine.size());
        lists_[i] = {me, find_weights(fluid.position[i], near, mine), begin};
      }
    }
  }
  transpose();
}

/// The same weights by wall points, places in their order.
template <int D>
void WallMotion<D>::transpose() {
  of_point_begin_.assign(pose_.size() + 1, 0);
  for (std::size_t i = 0; i < lists_.size(); ++i)
    for (int n = 0; n < lists_[i].count; ++n) ++of_point_begin_[entries(i)[n].index + 1];
  for (std::size_t a = 0; a < pose_.size(); ++a) of_point_begin_[a + 1] += of_point_begin_[a];
  of_point_.resize(of_point_begin_.back());
  std::vector<std::int64_t> next(of_point_begin_.begin(), of_point_begin_.end() - 1);
  for (std::size_t i = 0; i < lists_.size(); ++i)
    for (int n = 0; n < lists_[i].count; ++n)
      of_point_[next[entries(i)[n].index]++] = {static_cast<std::int32_t>(i), entries(i)[n].weight};
}

template <int D>
WallSample<D> WallMotion<D>::sample(const WallField<D>& field, std::size_t i, const Vec<D>& x) const {
  if (!attached(i)) return field(x);
  Vec<D> X = Vec<D>::Zero(), before = Vec<D>::Zero(), now = Vec<D>::Zero();
  for (int n = 0; n < lists_[i].count; ++n) {
    const auto [a, weight] = entries(i)[n];
    const double w = weight;
    X += w * (reference_[a] + pose_[a].turn.transpose() * (x - pose_[a].position));
    before += w * reference_normal_[a], now += w * pose_[a].normal;
  }
  WallSample<D> sample = field(X);
  sample.flux = smallest_rotation<D>(before.normalized(), now.normalized()) * sample.flux;
  return sample;
}

template <int D>
void WallMotion<D>::set_velocities(const std::vector<Vec<D>>& velocity) {
  for_clusters(velocity_.size(), [&](std::size_t c) {
    for (std::size_t lane = 0; lane < 8; ++lane) {
      const std::size_t i = 8 * c + lane;
      if (!attached(i)) continue;
      Vec<D> v = Vec<D>::Zero();
      for (int n = 0; n < lists_[i].count; ++n)
        v += double(entries(i)[n].weight) * velocity[entries(i)[n].index];
      lane_assign<D>(velocity_[c].v, lane, v);
    }
  });
}

template <int D>
void WallMotion<D>::drift(double dt) {
  for_clusters(velocity_.size(), [&](std::size_t c) {
    for (int d = 0; d < D; ++d)
      for (int lane = 0; lane < 8; ++lane)
        moved_[c].v[d][lane] += static_cast<float>(dt) * velocity_[c].v[d][lane];
  });
}

template <int D>
Vec<D> WallMotion<D>::moved(std::size_t i) const {
  return lane_vector<D>(moved_[i / 8].v, i % 8);
}

template class WallMotion<2>;
template class WallMotion<3>;

}  // namespace ostium::sph3d
