#include "sph3d/shell/bends.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sph3d/shell/lateral.hpp"

namespace ostium::sph3d {

namespace {

/// Where one face of the wall all but comes to a point, whatever the user allows.
constexpr double folding = 1.8;

/// t/R of one curvature of the surface of the lumen.
double bend_ratio(double k, double t) {
  const double opened = 1.0 + 0.5 * k * t;
  return opened > 0.0 ? std::abs(k) * t / opened : 1e300;
}

}  // namespace

template <int D>
std::vector<Curvatures<D>> principal_curvatures(const std::vector<Bending<D>>& bending) {
  std::vector<Curvatures<D>> k;
  for (const auto& S : bending) k.push_back(principal<D>(S));
  return k;
}

template <int D>
WallBends<D> bends_of(const SurfacePoints<D>& p, const std::vector<Curvatures<D>>& curvature,
                      const std::vector<double>& thickness, double allowed) {
  WallBends<D> bends;
  double bent = 0, whole = 0;
  for (std::size_t a = 0; a < curvature.size(); ++a) {
    const double t = thickness[a];
    double ratio = 0;
    for (const double k : curvature[a]) ratio = std::max(ratio, bend_ratio(k, t));
    whole += p.area[a], bent += ratio > allowed ? p.area[a] : 0.0;
    if (ratio > bends.ratio)
      bends = {.ratio = ratio, .radius = t / ratio, .thickness = t, .place = p.position[a]};
  }
  bends.share = bent / whole;
  return bends;
}

template <int D>
void check_bends(const WallBends<D>& b, const ShellWallOptions& o, Notes& warnings) {
  if (b.ratio <= std::min(o.tightest_bend, folding)) return;
  const auto found = fmt::format(
      "the wall is {:.3g} m thick {}, where its middle is bent with a radius of {:.3g} m, and {:.1f} % of "
      "the wall are "
      "bent more tightly than a shell allows, a radius of {:.3g} thicknesses",
      b.thickness, place<D>(b.place), b.radius, 100.0 * b.share, 1.0 / o.tightest_bend);
  if (b.ratio > folding)
    user_error(
        "{}; there it would cross itself. Make the wall thinner, round the surface off, or model the wall as "
        "a solid",
        found);
  if (b.share > o.bent_share)
    user_error(
        "{}; up to {:.1f} % would do. Make the wall thinner, round the surface off, or model the wall as a "
        "solid",
        found, 100.0 * o.bent_share);
  warnings.push_back(found + "; displacements and stresses there are estimates");
}

#define OSTIUM_BENDS(D)                                                                        \
  template std::vector<Curvatures<D>> principal_curvatures<D>(const std::vector<Bending<D>>&); \
  template WallBends<D> bends_of(const SurfacePoints<D>&, const std::vector<Curvatures<D>>&,   \
                                 const std::vector<double>&, double);                          \
  template void check_bends(const WallBends<D>&, const ShellWallOptions&, Notes&);

OSTIUM_BENDS(2)
OSTIUM_BENDS(3)

}  // namespace ostium::sph3d
