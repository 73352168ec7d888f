#include "wall_rivals.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

namespace ostium::sph3d {

using bench::Layers;
using bench::Shell;
using bench::WallSums;

namespace {

constexpr double h = 1.3, reach = 2 * h;

/// Off the lattice by up to half a spacing.
template <int D>
void disorder(std::vector<Vec<D>>& points) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-0.5, 0.5);
  for (auto& x : points)
    for (int d = 0; d < D; ++d) x[d] += any(random);
}

/// Lattice points of [lower, upper).
template <int D>
std::vector<Vec<D>> lattice(const Vec<D>& lower, const Vec<D>& upper) {
  std::vector<Vec<D>> points;
  for (double z = D == 3 ? lower[D - 1] + 0.5 : 0.0; z < (D == 3 ? upper[D - 1] : 1.0); ++z)
    for (double y = lower[1] + 0.5; y < upper[1]; ++y)
      for (double x = lower[0] + 0.5; x < upper[0]; ++x) {
        Vec<D> p;
        p[0] = x, p[1] = y;
        if constexpr (D == 3) p[2] = z;
        points.push_back(p);
      }
  return points;
}

}  // namespace

template <int D>
WallShape<D> channel_shape(int height, int length) {
  WallShape<D> shape{.distance = [=](const Vec<D>& x) { return std::min(x[D - 1], height - x[D - 1]); },
                     .shells =
                         [=](double spacing) {
                           auto shells = bench::plane_shells<D>(0, -1, -reach, length + reach, spacing);
                           const auto top =
                               bench::plane_shells<D>(height, 1, -reach, length + reach, spacing);
                           shells.insert(shells.end(), top.begin(), top.end());
                           return shells;
                         },
                     .lower = Vec<D>::Zero(),
                     .upper = Vec<D>::Constant(length),
                     .area = 2 * std::pow(length, D - 1),
                     .velocity = [=](const Vec<D>& x) { return 0.5 * x[D - 1] * (height - x[D - 1]); }};
  shape.upper[D - 1] = height;
  shape.fluid.period = Vec<D>::Constant(length);
  shape.fluid.period[D - 1] = 0;
  shape.fluid.points = lattice<D>(shape.lower, shape.upper);
  disorder<D>(shape.fluid.points);
  for (auto& x : shape.fluid.points) x[D - 1] = std::clamp(x[D - 1], 0.1, height - 0.1);
  return shape;
}

template <int D>
WallShape<D> tube_shape(double R, double length) {
  const auto count = static_cast<std::size_t>(std::round(pi * R * R * (D == 3 ? length : 1)));
  (D == 3 ? length : R) = D == 3 ? count / (pi * R * R) : std::sqrt(count / pi);
  WallShape<D> shape{.distance = [=](const Vec<D>& x) { return R - std::hypot(x[0], x[1]); },
                     .shells =
                         [=](double spacing) {
                           // whole rings in a period, so that the wall is as periodic as the fluid
                           const int rings = static_cast<int>(std::ceil(length / spacing));
                           const double step = length / rings;
                           const int more = static_cast<int>(std::ceil(reach / step));
                           return bench::tube_shells<D>(R, spacing, -more * step, length + more * step,
                                                        rings + 2 * more);
                         },
                     .lower = Vec<D>::Constant(-R),
                     .upper = Vec<D>::Constant(R),
                     .area = 2 * pi * R * (D == 3 ? length : 1),
                     .velocity = [=](const Vec<D>& x) { return 0.25 * (R * R - x[0] * x[0] - x[1] * x[1]); }};
  Vec<D> corner = Vec<D>::Constant(std::ceil(R) + 1), other = -corner;
  if constexpr (D == 3) {
    shape.lower[2] = other[2] = 0;
    shape.upper[2] = corner[2] = shape.fluid.period[2] = length;
  }
  auto& points = shape.fluid.points = lattice<D>(other, corner);
  disorder<D>(points);
  std::sort(points.begin(), points.end(),
            [&](const Vec<D>& a, const Vec<D>& b) { return shape.distance(a) > shape.distance(b); });
  points.resize(count);
  return shape;
}

namespace {

/// kappa = div n over the shells with the kernel of a line and no correction.
void set_curvature(std::vector<Shell<2>>& shells, double spacing) {
  const auto slope = [](double r) {
    const double q = r / h, t = 1 - 0.5 * q;
    return t > 0 ? -5 * 0.75 / (h * h) * q * t * t * t : 0.0;
  };
  for (auto& a : shells) {
    double kappa = 0;
    for (const auto& b : shells)
      if (const Vec2 r = a.x - b.x; r.norm() > 0)
        kappa -= (a.n - b.n).dot(r.normalized()) * slope(r.norm()) * b.area;
    a.curvature[0] = std::clamp(kappa, -0.9 / (3 * spacing), 2 / spacing);
  }
}

}  // namespace

WallShape<2> apex_shape(double half_angle) {
  const double c = std::cos(half_angle), s = std::sin(half_angle);
  return {.distance =
              [=](const Vec2& x) {
                const Vec2 y(x[0], std::abs(x[1])), along(-c, s), normal(s, c);
                return y.dot(along) > 0 ? y.dot(normal) : y.norm();
              },
          .shells =
              [=](double spacing) {
                std::vector<Shell<2>> shells;
                for (const int side : {-1, 1}) {
                  const Vec2 along(-c, side * s), into(-s, -side * c);
                  // the first where those of both sides meet
                  for (double l = 0.5 * spacing * (c / s + 1); l < 3 * reach; l += spacing)
                    shells.push_back({.x = l * along + 0.5 * spacing * into, .n = into, .area = spacing});
                }
                set_curvature(shells, spacing);
                return shells;
              },
          .lower = Vec2::Constant(-2 * reach),
          .upper = Vec2::Constant(2 * reach)};
}

template <int D>
Rival<D> layers(const WallShape<D>& shape, double spacing, const bench::LayerFriction& friction) {
  const auto wall =
      std::make_shared<Layers<D>>(shape.shells(spacing), spacing, Wendland<D>{h}, 1.0, friction);
  const std::string law = friction.mirror       ? "mirror"
                          : friction.most < 1e6 ? fmt::format("linear <= {:g}", friction.most)
                                                : "linear";
  return {fmt::format("layers dp/{:g}, {}{}", 1 / spacing, law, friction.own_distance ? "" : ", layer 0"),
          [wall, distance = shape.distance](const Vec<D>& x) {
            const double s = distance(x);
            return s < reach ? (*wall)(x, s) : WallSums<D>{};
          }};
}

template <int D>
Rival<D> field(const WallShape<D>& shape, double most, bool true_distance) {
  const Wendland<D> kernel{h};
  const auto phi = [distance = shape.distance](const Vec<D>& x) { return -distance(x); };
  if (!shape.table)
    shape.table = std::make_shared<const WallField<D>>(phi, shape.lower, shape.upper, kernel, 1.0);
  const auto wall = shape.table;
  const auto space = std::make_shared<HalfSpace<D>>(kernel, 1.0, most);
  return {fmt::format("field, linear <= {:g}{}", most, true_distance ? ", true distance" : ""),
          [wall, space, true_distance, distance = shape.distance](const Vec<D>& x) {
            const auto sample = (*wall)(x);
            return bench::sums_of(sample, true_distance ? distance(x) : space->distance(sample.filling),
                                  *space);
          }};
}

#define OSTIUM_INSTANTIATE(D)                                                         \
  template WallShape<D> channel_shape(int, int);                                      \
  template WallShape<D> tube_shape(double, double);                                   \
  template Rival<D> layers(const WallShape<D>&, double, const bench::LayerFriction&); \
  template Rival<D> field(const WallShape<D>&, double, bool);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
