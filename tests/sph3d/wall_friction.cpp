// The limit of the wall's friction with particles that move: docs/theory/walls.md, "With particles that move".
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "sph3d/step/lane_access.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {
namespace {

/// A tube or a channel of half width R, four widths long, with a given flow; a force as large as the exact pressure gradient
/// drives it, so that no density changes along it. Over its middle, in the mean over time:
struct Moving {
  double shear = 0;   // of the wall, over the exact one: the resistance
  double first = 0;   // error of the velocity within a spacing from the wall
  double linear = 0;  // stress that a linear profile would make, over the exact one
  double near = 0;  // of the particles within a spacing from the wall, the share nearer than a quarter of it
};

template <int D>
class Developed {
 public:
  Developed(int across_half, double reynolds, double limit, double limiter)
      : dp_(R / across_half),
        nu_(mean * 2 * R / reynolds),
        vessel_(lumen(), options(limit, limiter), {{true, Profile::parabolic}, {}}) {
    auto state = vessel_.save();
    for (std::size_t i = 0; i < state.fluid.places(); ++i)
      if (state.fluid.filled[i])
        state.fluid.velocity(i, std::max(exact(state.fluid.position[i]), 0.0) * Vec<D>::Unit(0));
    vessel_.load(state);
  }

  Moving run(double widths) {  // way of the mean flow
    std::vector<Drive> drives(2);
    const double unit = 2 * R / mean, area = vessel_.model().ducts[0].opening().area;
    double next = 0.4 * widths * unit;
    while (vessel_.time() < widths * unit) {
      drives[0].since = vessel_.time(), drives[0].flow_in = mean * area;
      vessel_.advance(1, drives, 0.002 * unit);
      if (vessel_.time() > next) add(), next += 0.02 * unit;
    }
    const double wall = samples_ * (upper - lower) * (D == 3 ? 2 * pi * R : 2);
    const double rate = 2 * top / R;
    return {force_ / (nu_ * rate * wall), first_ / first_exact_ - 1, linear_ / (nu_ * wall), near_ / count_};
  }

 private:
  static constexpr double R = 1e-3, mean = 0.05, top = (D == 3 ? 2 : 1.5) * mean, length = 8 * R;
  static constexpr double lower = 0.3 * length, upper = 0.8 * length;

  static Lumen<D> lumen() {
    if constexpr (D == 3) return tube(R, length, 96, 24);
    if constexpr (D == 2) return channel(length, 2 * R);
  }
  FluidOptions<D> options(double limit, double limiter) const {
    FluidOptions<D> o{
        .dp = dp_, .density = 1000, .viscosity = nu_, .sound_speed = 10 * top, .reference_speed = top};
    o.friction_limit = limit, o.limiter = limiter;
    o.gravity[0] = 2 * (D - 1) * nu_ * top / (R * R);
    return o;
  }
  static double distance(const Vec<D>& x) {
    return R - (D == 3 ? std::hypot(x[1], x[D - 1]) : std::abs(x[1] - R));
  }
  static double exact(const Vec<D>& x) {
    const double s = distance(x) / R;
    return top * s * (2 - s);
  }

  void add() {
    const auto& fluid = vessel_.state().fluid;
    ++samples_;
    for (std::size_t i = 0; i < fluid.places(); ++i) {
      if (!fluid.filled[i]) continue;
      const Cluster<D>& own = fluid.clusters[i / 8];
      // where friction was computed
      const Vec<D> x = vessel_.model().origin + vessel_.model().reach() * lane_vector<D>(own.x, i % 8);
      if (x[0] < lower || x[0] > upper) continue;
      const double s = distance(x), u = fluid.velocity(i)[0], friction = fluid.volume * own.friction[i % 8];
      force_ += friction * u, linear_ += friction * s;
      if (s < dp_) first_ += u, first_exact_ += exact(x), near_ += s < 0.25 * dp_, ++count_;
    }
  }

  double dp_, nu_;
  Vessel<D> vessel_;
  double samples_ = 0, force_ = 0, linear_ = 0, first_ = 0, first_exact_ = 0, near_ = 0, count_ = 0;
};

template <int D>
Moving moving(int across_half, double reynolds, double limit, double widths, double limiter = 3) {
  const Moving m = Developed<D>(across_half, reynolds, limit, limiter).run(widths);
  fmt::print(
      "{}D R = {:<2} dp  Re {:<2}  ratios to {}, dissipation {}: wall shear {:+.2f} %  u_0 {:+.2f} %  linear "
      "profile {:.3f}  "
      "{:.2f} % near\n",
      D, across_half, reynolds, limit, limiter, 100 * (m.shear - 1), 100 * m.first, m.linear, 100 * m.near);
  return m;
}

TEST(WallFriction, OfATubeWithMovingParticles) {
  const Moving m = moving<3>(5, 10, 4, 1.5);
  EXPECT_NEAR(m.shear, 1, 0.02);
  EXPECT_NEAR(m.linear, 1, 0.05);
}

template <int D>
void print_table() {
  for (const int across_half : {5, 7, 10})
    for (const double reynolds : {2, 10, 50}) {
      const Moving two = moving<D>(across_half, reynolds, 2, 3),
                   four = moving<D>(across_half, reynolds, 4, 3);
      if (reynolds == 10)
        moving<D>(across_half, reynolds, 2, 3, 0), moving<D>(across_half, reynolds, 4, 3, 0);
      if (D == 2) continue;  // rows stand where the limit hardly acts: differences as small as the noise
      EXPECT_GT(four.shear, two.shear);
      EXPECT_LT(four.first, two.first);
      if (reynolds <= 10) {
        EXPECT_LT(std::abs(four.shear - 1), std::abs(two.shear - 1));
        EXPECT_NEAR(four.shear, 1, 0.015);
      }
    }
}
TEST(FullWallFriction, Channel) { print_table<2>(); }
TEST(FullWallFriction, Tube) { print_table<3>(); }

}  // namespace
}  // namespace ostium::sph3d
