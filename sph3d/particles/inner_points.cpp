#include "sph3d/particles/inner_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <unordered_map>

#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/neighbours/order.hpp"

namespace ostium::sph3d {

namespace {

/// How far x lies behind the innermost face of the layers around it, in particle spacings; far where there are none.
template <int D>
double beyond_layers(const Model<D>& model, const Vec<D>& x) {
  for (std::size_t k = 0; k < model.ducts.size(); ++k) {
    const Duct<D>& duct = model.ducts[k];
    const int count =
        static_cast<int>(std::ceil((duct.length() + 0.25 * duct.spacing()) / model.slices[k].spacing - 0.5));
    const double s = (duct.depth(x) - count * model.slices[k].spacing) / duct.spacing();
    if (s < 1.0 && duct.depth(x) > -duct.spacing() && duct.holds(duct.at_depth(x, 0.5 * duct.length())) &&
        inside_outline(duct.opening(), x))
      return s;
  }
  return 1e9;
}

/// A cell of the lattice of spacing dp: its middle and the share of it that lies in the domain and outside the layers.
template <int D>
struct Cell {
  Vec<D> x;
  double share;
};

/// The share of a cell, from the distances at the middles of its 2^D parts, each cut by planes.
template <int D>
double share_of(const Model<D>& model, const SignedDistance<D>& phi, const Vec<D>& x, double distance) {
  const double dp = model.options.dp;
  if (distance < -dp && beyond_layers(model, x) > 0.9) return 1.0;
  double share = 0;
  for (int part = 0; part < (1 << D); ++part) {
    Vec<D> y = x;
    for (int d = 0; d < D; ++d) y[d] += (part >> d & 1 ? 0.25 : -0.25) * dp;
    double inside = 1.0;
    Vec<D> foot = y;  // for the layers, which end with the wall: the same height above them, but inside
    if (distance >= -dp) {
      const auto hit = phi(y);
      inside = std::clamp(0.5 - hit.phi / (0.5 * dp), 0.0, 1.0);
      foot -= std::max(hit.phi + 0.1 * dp, 0.0) * hit.normal;
    }
    share += inside * std::clamp(0.5 + beyond_layers(model, foot) / 0.5, 0.0, 1.0);
  }
  return share / (1 << D);
}

template <int D>
std::vector<Cell<D>> cells_of(const Model<D>& model, const SignedDistance<D>& phi) {
  const double dp = model.options.dp;
  Vec<D> lower = model.domain.surface.points.front(), upper = lower;
  for (const Vec<D>& p : model.domain.surface.points) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  std::array<std::int64_t, 3> n{1, 1, 1};
  Vec<D> first;
  for (int d = 0; d < D; ++d) {
    n[d] = static_cast<std::int64_t>((upper[d] - lower[d]) / dp) + 2;
    first[d] = 0.5 * (lower[d] + upper[d] - static_cast<double>(n[d] - 1) * dp);
  }
  std::vector<std::vector<Cell<D>>> found(n[D - 1]);
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t layer = 0; layer < n[D - 1]; ++layer) {
    const std::int64_t size = D == 3 ? n[0] * n[1] : n[0];
    for (std::int64_t k = 0; k < size; ++k) {
      Vec<D> x = first;
      x[0] += dp * static_cast<double>(k % n[0]);
      x[D - 1] += dp * static_cast<double>(layer);
      if constexpr (D == 3) x[1] += dp * static_cast<double>(k / n[0]);
      const double distance = phi(x).phi;
      if (distance > dp) continue;
      if (const double share = share_of(model, phi, x, distance); share > 0.0)
        found[layer].push_back({x, share});
    }
  }
  std::vector<Cell<D>> all;
  for (auto& layer : found) all.insert(all.end(), layer.begin(), layer.end());
  return all;
}

/// Moved away from the wall and from the layers, where too close to them.
template <int D>
Vec<D> moved_inside(const Model<D>& model, const SignedDistance<D>& phi, Vec<D> x) {
  const double dp = model.options.dp;
  for (const auto& duct : model.ducts)
    if (const double s = beyond_layers(model, x);
        s < 0.1 && duct.holds(duct.at_depth(x, 0.5 * duct.length())))
      x = duct.at_depth(x, duct.depth(x) + (0.1 - s) * dp);
  const auto hit = phi(x);
  const double outside = hit.phi + 0.35 * dp;
  return outside > 0.0 ? Vec<D>(x - outside * hit.normal) : x;
}

/// Points in buckets of the size dp.
template <int D>
class Crowd {
 public:
  explicit Crowd(double dp) : dp_(dp) {}

  void add(const Vec<D>& x) { buckets_[bucket(x)].push_back(x); }

  /// Distance of the nearest point, at most dp.
  double room(const Vec<D>& x) const {
    double nearest = dp_ * dp_;
    const auto middle = bucket(x);
    for (int k = 0; k < (D == 3 ? 27 : 9); ++k) {
      auto near = middle;
      near[0] += k % 3 - 1, near[1] += k / 3 % 3 - 1;
      if constexpr (D == 3) near[2] += k / 9 - 1;
      if (const auto found = buckets_.find(near); found != buckets_.end())
        for (const Vec<D>& y : found->second) nearest = std::min(nearest, (x - y).squaredNorm());
    }
    return std::sqrt(nearest);
  }

 private:
  using Bucket = std::array<std::int64_t, D>;
  struct Hash {
    std::size_t operator()(const Bucket& b) const {
      std::uint64_t h = 0;
      for (const std::int64_t n : b) h = (h ^ static_cast<std::uint64_t>(n)) * 0x9e3779b97f4a7c15u;
      return h ^ (h >> 29);
    }
  };
  Bucket bucket(const Vec<D>& x) const {
    Bucket b;
    for (int d = 0; d < D; ++d) b[d] = static_cast<std::int64_t>(std::floor(x[d] / dp_));
    return b;
  }
  double dp_;
  std::unordered_map<Bucket, std::vector<Vec<D>>, Hash> buckets_;
};

/// Where in these cells the next point has the most room: at the middle of one of them or at one of its corners, which
/// lie half way between the middles of the lattice.
template <int D>
Vec<D> roomiest(const Model<D>& model, const SignedDistance<D>& phi, const Crowd<D>& crowd,
                const std::vector<Vec<D>>& cells) {
  double most = -1.0;
  Vec<D> best = cells.front();
  const auto look = [&](const Vec<D>& x) {
    const Vec<D> y = moved_inside(model, phi, x);
    if (const double room = crowd.room(y); room > most + 1e-6 * model.options.dp) most = room, best = y;
  };
  for (const Vec<D>& cell : cells) {
    look(cell);
    for (int corner = 0; corner < (1 << D); ++corner) {
      Vec<D> x = cell;
      for (int d = 0; d < D; ++d) x[d] += (corner >> d & 1 ? 0.5 : -0.5) * model.options.dp;
      look(x);
    }
  }
  return best;
}

}  // namespace

template <int D>
std::vector<Vec<D>> inner_points(const Model<D>& model, std::size_t wanted,
                                 const std::vector<Vec<D>>& layers) {
  const SignedDistance<D> phi(model.domain.surface);
  Crowd<D> crowd(model.options.dp);
  for (const Vec<D>& x : layers) crowd.add(x);
  std::vector<Vec<D>> points, cut;
  std::vector<double> share;
  for (const auto& cell : cells_of(model, phi)) {
    if (cell.share >= 1.0 && points.size() < wanted) {
      points.push_back(cell.x);
      crowd.add(cell.x);
    } else if (cell.share < 1.0) {
      cut.push_back(cell.x);
      share.push_back(cell.share);
    }
  }
  const double sum = std::accumulate(share.begin(), share.end(), 0.0);
  const double scale = sum > 0.0 ? static_cast<double>(wanted - points.size()) / sum : 0.0;
  double due = 0.5;
  std::vector<Vec<D>> unit;
  for (const std::int32_t k : bisection_order<D>(cut)) {
    unit.push_back(cut[k]);
    due += scale * share[k];
    if (due < 1.0) continue;
    for (; due >= 1.0 && points.size() < wanted; due -= 1.0) {
      points.push_back(roomiest(model, phi, crowd, unit));
      crowd.add(points.back());
    }
    unit.clear();
  }
  while (points.size() < wanted && !cut.empty()) points.push_back(roomiest(model, phi, crowd, cut));
  return points;
}

template std::vector<Vec<2>> inner_points<2>(const Model<2>&, std::size_t, const std::vector<Vec<2>>&);
template std::vector<Vec<3>> inner_points<3>(const Model<3>&, std::size_t, const std::vector<Vec<3>>&);

}  // namespace ostium::sph3d
