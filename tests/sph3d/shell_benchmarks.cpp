// The obstacle course of curved shells: roof, pinched hemisphere, pinched cylinder.
#include <gtest/gtest.h>

#include "shell_clouds.hpp"
#include "sph3d/shell/equilibrium.hpp"

namespace ostium::sph3d {
namespace {

void settle(const ShellModel<3>& model, ShellState<3>& state, const std::vector<ShellLoad<3>>& load) {
  find_equilibrium(model, state, load, {.tolerance = 1e-3, .most_steps = 1000000});
}

/// Scordelis-Lo: particles on all edges, n + 1 along the arc; end diaphragms; mid free edge.
double roof(int n) {
  const double R = 25, L = 50, angle = 80 * pi / 180, arc = R * angle,
               weight = 0.09;  // the reference is that of small deflections
  const int m = int(std::lround(L / arc * n / 2)) * 2;
  ShellCloud<3> cloud;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j <= n; ++j) {
      const double phi = angle * (double(j) / n - 0.5),
                   area = L / m * arc / n * (i % m ? 1 : 0.5) * (j % n ? 1 : 0.5);
      const Vec3 normal(0, std::sin(phi), std::cos(phi));
      add<3>(cloud, R * normal + Vec3(i * L / m, 0, 0), normal, area, 0.25,
             i % m ? Support::free : Support::diaphragm);
      cloud.axis.push_back(Vec3(1, 0, 0));
    }
  const ShellModel<3> model(cloud, static_options(arc / n, 4.32e8, 0.0));
  auto state = rest(model);
  auto load = no_load(model);
  for (std::size_t a = 0; a < model.count(); ++a)
    set_force<3>(load, a, Vec3(0, 0, -weight * model.cloud.area[a]));
  settle(model, state, load);
  return -1000 * state.displacement(std::size_t(m / 2 * (n + 1)))[2];
}

TEST(FullShellBenchmarks, ScordelisLoRoof) {
  const double coarse = roof(32) / 0.3024 - 1, fine = roof(64) / 0.3024 - 1;
  EXPECT_NEAR(fine, 0.0, 0.03);
  EXPECT_GT(coarse / fine, 2.5);
}

/// Hemisphere with a hole of 18 degrees, unit forces 2 outward along x, inward along y, at the equator: rings of n.
double hemisphere(int n) {
  const double R = 10, t = 0.04, top = 72 * pi / 180;
  const int rings = int(std::lround(top * R / (2 * pi * R / n)));
  const double dp = top * R / rings;
  ShellCloud<3> cloud;
  for (int k = 0; k <= rings; ++k) {
    const double latitude = k * dp / R;
    const int around = 4 * int(std::lround(n * std::cos(latitude) / 4));
    const double low = std::max(latitude - 0.5 * dp / R, 0.0), high = std::min(latitude + 0.5 * dp / R, top);
    for (int i = 0; i < around; ++i) {
      const double phi = 2 * pi * i / around;
      const Vec3 normal(std::cos(latitude) * std::cos(phi), std::cos(latitude) * std::sin(phi),
                        std::sin(latitude));
      add<3>(cloud, R * normal, normal, 2 * pi * R * R * (std::sin(high) - std::sin(low)) / around, t);
    }
  }
  const ShellModel<3> model(cloud, static_options(dp, 6.825e7, 0.3));
  auto state = rest(model);
  auto load = no_load(model);
  set_force<3>(load, 0, Vec3(0.02, 0, 0));
  set_force<3>(load, n / 4, Vec3(0, -0.02, 0));
  set_force<3>(load, n / 2, Vec3(-0.02, 0, 0));
  set_force<3>(load, 3 * n / 4, Vec3(0, 0.02, 0));
  settle(model, state, load);
  return 25 * (state.displacement(0)[0] - state.displacement(n / 2)[0] - state.displacement(n / 4)[1] +
               state.displacement(3 * n / 4)[1]);
}

TEST(FullShellBenchmarks, PinchedHemisphere) { EXPECT_NEAR(hemisphere(128) / 0.0940, 1.0, 0.05); }

/// Cylinder between diaphragms pinched in the middle.
double pinched(int n) {
  const double R = 300, L = 600, t = 3;
  const int m = int(std::lround(L / (2 * pi * R / n) / 2)) * 2;
  ShellCloud<3> cloud;
  for (int i = 0; i <= m; ++i)
    for (int j = 0; j < n; ++j) {
      const double phi = 2 * pi * j / n;
      const Vec3 normal(std::cos(phi), std::sin(phi), 0);
      add<3>(cloud, R * normal + Vec3(0, 0, i * L / m), normal, 2 * pi * R / n * L / m * (i % m ? 1 : 0.5), t,
             i % m ? Support::free : Support::diaphragm);
      cloud.axis.push_back(Vec3(0, 0, 1));
    }
  const ShellModel<3> model(cloud, static_options(2 * pi * R / n, 3e6, 0.3));
  auto state = rest(model);
  auto load = no_load(model);
  // The unit forces are spread over the support of the kernel, and the deflection is the mean with the same weights.
  std::vector<double> share(model.count());
  double whole[2] = {};
  for (std::size_t a = 0; a < model.count(); ++a) {
    const Vec3 x = model.cloud.position[a];
    share[a] = model.kernel.value((x - Vec3(std::copysign(R, x[0]), 0, L / 2)).norm()) * model.cloud.area[a];
    whole[x[0] > 0] += share[a];
  }
  for (std::size_t a = 0; a < model.count(); ++a) {
    const bool right = model.cloud.position[a][0] > 0;
    share[a] *= (right ? -1 : 1) / whole[right];
    set_force<3>(load, a, Vec3(share[a], 0, 0));
  }
  settle(model, state, load);
  double work = 0.0;
  for (std::size_t a = 0; a < model.count(); ++a) work += 0.5 * share[a] * state.displacement(a)[0];
  return work;
}

// The dimple is as wide as sqrt(R t): it wants a spacing near the thickness, and is 7 % too deep at 1.6 t.
TEST(FullShellBenchmarks, PinchedCylinder) {
  const double coarse = pinched(192) / 1.8248e-5 - 1, fine = pinched(384) / 1.8248e-5 - 1;
  EXPECT_LT(fine, 0.08);
  EXPECT_GT(coarse / fine, 2.5);
}

}  // namespace
}  // namespace ostium::sph3d
