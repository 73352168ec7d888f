#include "sph3d/openings/slice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/openings/flat_outline.hpp"
#include "sph3d/particles/relax.hpp"

namespace ostium::sph3d {

template <int D>
std::array<int, D> Slice<D>::bin_of(const Vec<D>& x) const {
  std::array<int, D> bin;
  for (int d = 0; d < D; ++d)
    bin[d] = std::clamp(static_cast<int>(std::floor((x[d] - lower_[d]) / width_)), 0, bins_[d] - 1);
  return bin;
}

template <int D>
void Slice<D>::bin(double width) {
  width_ = width;
  Vec<D> upper = lower_ = sites.front();
  for (const Vec<D>& x : sites) lower_ = lower_.cwiseMin(x), upper = upper.cwiseMax(x);
  std::size_t total = 1;
  for (int d = 0; d < D; ++d) total *= bins_[d] = static_cast<int>((upper[d] - lower_[d]) / width) + 1;
  around_.assign(total, {});
  for (std::size_t b = 0; b < total; ++b) {
    Vec<D> low = lower_;
    for (std::size_t d = 0, rest = b; d < D; rest /= bins_[d++])
      low[d] += width * static_cast<double>(rest % bins_[d]);
    std::size_t nearest = 0;
    double nearest2 = std::numeric_limits<double>::max();
    for (std::size_t a = 0; a < sites.size(); ++a) {
      const Vec<D> outside =
          (low - sites[a]).cwiseMax(sites[a] - low - Vec<D>::Constant(width)).cwiseMax(0.0);
      if (outside.maxCoeff() < width) around_[b].push_back(static_cast<std::int32_t>(a));
      if (outside.squaredNorm() < nearest2) nearest = a, nearest2 = outside.squaredNorm();
    }
    if (around_[b].empty()) around_[b].push_back(static_cast<std::int32_t>(nearest));
  }
}

template <int D>
const std::vector<std::int32_t>& Slice<D>::near(const Vec<D>& x) const {
  const auto bin = bin_of(x);
  std::size_t b = 0;
  for (int d = D - 1; d >= 0; --d) b = b * bins_[d] + bin[d];
  return around_[b];
}

template struct Slice<2>;
template struct Slice<3>;

template <>
Slice<2> slice_of<2>(const Opening<2>& opening, double dp) {
  const int n = std::max(1, static_cast<int>(std::lround(opening.area / dp)));
  Slice<2> slice;
  slice.spacing = n * dp * dp / opening.area;
  const Vec2 a = opening.outline.front(), b = opening.outline.back();
  for (int k = 0; k < n; ++k) slice.sites.push_back(a + (k + 0.5) / n * (b - a));
  slice.bin(2.0 * dp);
  return slice;
}

namespace {

/// The n lattice points deepest inside.
std::vector<Vec2> deepest(const SignedDistance<2>& phi, const Vec2& lower, const Vec2& upper, double dp,
                          std::size_t n) {
  std::vector<std::pair<double, Vec2>> candidates;
  for (double y = lower[1] - dp; y < upper[1] + dp; y += dp)
    for (double x = lower[0] - dp; x < upper[0] + dp; x += dp) {
      const Vec2 p(x + 0.31 * dp, y + 0.17 * dp);  // off the symmetry axes
      candidates.emplace_back(phi(p).phi, p);
    }
  std::sort(candidates.begin(), candidates.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  candidates.resize(std::min(n, candidates.size()));
  std::vector<Vec2> points;
  for (const auto& [distance, p] : candidates) points.push_back(p);
  return points;
}

}  // namespace

template <>
Slice<3> slice_of<3>(const Opening<3>& opening, double dp) {
  const auto frame = plane_frame(opening.normal);
  const Surface<2> outline = flat_outline(opening, frame);
  const SignedDistance<2> phi(outline);
  Vec2 lower = outline.points.front(), upper = lower;
  for (const Vec2& p : outline.points) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  const auto n = static_cast<std::size_t>(std::max(1L, std::lround(opening.area / (dp * dp))));
  const Wendland<2> kernel{1.3 * dp};
  const WallField<2> wall([&](const Vec2& x) { return phi(x).phi; }, lower, upper, kernel, dp);
  std::vector<Vec2> points = deepest(phi, lower, upper, dp, n);
  relax<2>(points, std::vector<std::uint8_t>(points.size(), 0),
           {.outside = [&](const Vec2& x) { return wall(x); },
            .kernel = kernel,
            .volume = opening.area / n,
            .iterations = 400});
  Slice<3> slice;
  slice.spacing = n * dp * dp * dp / opening.area;
  for (const Vec2& p : points) slice.sites.push_back(opening.centre + frame * p);
  slice.bin(2.0 * dp);
  return slice;
}

}  // namespace ostium::sph3d
