#include "sph3d/openings/slice.hpp"

#include <algorithm>
#include <cmath>

#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/openings/flat_outline.hpp"
#include "sph3d/particles/relax.hpp"

namespace ostium::sph3d {

template <>
Slice<2> slice_of<2>(const Opening<2>& opening, double dp) {
  const int n = std::max(1, static_cast<int>(std::lround(opening.area / dp)));
  Slice<2> slice{{}, n * dp * dp / opening.area};
  const Vec2 a = opening.outline.front(), b = opening.outline.back();
  for (int k = 0; k < n; ++k) slice.sites.push_back(a + (k + 0.5) / n * (b - a));
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
  const auto frame = tangents(opening.normal);
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
  Slice<3> slice{{}, n * dp * dp * dp / opening.area};
  for (const Vec2& p : points) slice.sites.push_back(opening.centre + frame * p);
  return slice;
}

}  // namespace ostium::sph3d
