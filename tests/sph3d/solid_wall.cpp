// Walls made by offset: layers, mass, areas; thick cylinders under pressure against Lame.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "core/error.hpp"
#include "shapes.hpp"
#include "solid_bodies.hpp"
#include "sph3d/geometry/generate.hpp"
#include "sph3d/geometry/offset.hpp"
#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/solid/wall_cloud.hpp"

namespace ostium::sph3d {
namespace {

using bodies::settled;

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// A circle without openings.
Lumen<2> circle(double radius, int sides = 400) {
  Lumen<2> lumen;
  // Corners a little outside: the polygon has the area of the circle.
  const double r = radius / std::sqrt(std::sin(2 * pi / sides) / (2 * pi / sides));
  for (int k = 0; k < sides; ++k) {
    lumen.surface.points.push_back(r * Vec2(std::cos(2 * pi * k / sides), std::sin(2 * pi * k / sides)));
    lumen.surface.facets.push_back({k, (k + 1) % sides});
    lumen.surface.label.push_back(-1);
  }
  lumen.wall_area = area(lumen.surface, -1), lumen.volume = volume(lumen.surface);
  return lumen;
}

TEST(SolidWall, RingHasItsLayersAndMass) {
  const auto wall = wall_cloud(circle(1.0), 0.3, 0.05);
  EXPECT_EQ(*std::max_element(wall.layer.begin(), wall.layer.end()), 5);
  EXPECT_NEAR(sum(wall.solid.volume), pi * (1.69 - 1.0), 2e-4 * pi);
  for (std::size_t a = 0; a < wall.depth.size(); ++a)
    EXPECT_NEAR(wall.solid.position[a].norm() - 1.0, wall.depth[a], 1e-3);
  Vec2 area = Vec2::Zero();
  double length = 0;
  for (const auto& A : wall.inner.area) area += A, length += A.norm();
  EXPECT_LT(area.norm(), 1e-12);
  EXPECT_NEAR(length, 2 * pi, 1e-3);
}

TEST(SolidWall, TubeHasItsLayersAndMassAndEndsInItsPlanes) {
  const auto wall = wall_cloud(shapes::tube_lumen(1.0, 2.0, 128, 20), 0.4, 0.1);
  EXPECT_NEAR(sum(wall.solid.volume), pi * (1.96 - 1.0) * 2.0, 2e-3 * pi * 0.96 * 2.0);
  double lowest = 9, highest = -9;
  for (const auto& x : wall.solid.position)
    lowest = std::min(lowest, x[2]), highest = std::max(highest, x[2]);
  EXPECT_GT(lowest, 0.0);
  EXPECT_LT(highest, 2.0);
  EXPECT_LT(lowest, 0.06);
  EXPECT_GT(highest, 1.94);
  double area = 0;
  for (std::size_t k = 0; k < wall.inner.area.size(); ++k) {
    area += wall.inner.area[k].norm();
    EXPECT_LE(wall.inner.area[k].dot(wall.normal[wall.inner.particle[k]]), 0.0);
  }
  EXPECT_NEAR(area, 4 * pi, 0.02 * 4 * pi);
}

TEST(FullSolidWall, CrotchOfABifurcationIsTrimmed) {
  Lumen<3> lumen;
  lumen.surface = generate(BifurcationShape{.parent_length = 0.02, .daughter_length = 0.03});
  for (int k = 0; k < 3; ++k) {
    Opening<3> o;
    Vec3 sum = Vec3::Zero();
    for (std::size_t f = 0; f < lumen.surface.facets.size(); ++f)
      if (lumen.surface.label[f] == k) sum += area_vector(lumen.surface, static_cast<int>(f));
    o.normal = sum.normalized(), o.area = sum.norm();
    lumen.openings.push_back(o);
  }
  lumen.wall_area = area(lumen.surface, -1);
  const double t = 2.4e-3, dp = 0.6e-3;
  const auto wall = wall_cloud(lumen, t, dp);
  const SignedDistance<3> phi(lumen.surface);
  for (std::size_t a = 0; a < wall.depth.size(); ++a)
    EXPECT_NEAR(phi(wall.solid.position[a]).phi, wall.depth[a], 0.35 * dp);
  EXPECT_NO_THROW(make_solid(
      wall.solid, {.material = SaintVenantKirchhoff(elastic(1e6, 0.45)), .density = 1000, .spacing = dp}));
}

TEST(SolidWall, RefusesWallsTooThinForTheirParticles) {
  try {
    wall_cloud(circle(1.0), 0.1, 0.05);
    FAIL();
  } catch (const UserError& e) {
    EXPECT_THAT(e.what(),
                testing::HasSubstr("four layers of particles or more; a thickness of 0.1 m with a spacing of "
                                   "0.05 m makes 2. Take a spacing of 0.025 m or less, or a shell"));
  }
  EXPECT_THROW(wall_cloud(circle(1.0), -0.1, 0.05), UserError);
}

struct Ring {
  double displacement = 0, hoop = 0;  // over Lame, at the middle of the wall
};

/// Radius 1, thickness t, under a pressure so small that all is linear; plane strain.
Ring pressed_ring(double nu, int layers, double t) {
  const double dp = t / layers, p = 1.0, outer = 1.0 + t;
  const Moduli tissue = elastic(1e6, nu);
  auto wall = wall_cloud(circle(1.0), t, dp);
  wall.inner.pressure = p;
  const auto m =
      make_solid(wall.solid, {.material = SaintVenantKirchhoff(tissue), .density = 1000, .spacing = dp});
  const auto state =
      settled<2>(m, {.patches = {wall.inner}}, std::sqrt(tissue.plate() / 1000) / (1 + 0.5 * t), 3.0);
  const double A = p / (outer * outer - 1.0);
  Ring ring;
  double area = 0;
  for (std::size_t a = 0; a < m.count(); ++a) {
    const double r = m.cloud.position[a].norm(), V = m.cloud.volume[a];
    const Vec2 n = m.cloud.position[a] / r;
    if (std::abs(wall.depth[a] - 0.5 * t) > 0.6 * dp) continue;
    const auto s = cauchy_stress(m, state, a);
    const double hoop = s.xx * n[1] * n[1] + s.yy * n[0] * n[0] - 2 * s.xy * n[0] * n[1];
    const double u = A * (1 + nu) / tissue.E * ((1 - 2 * nu) * r + outer * outer / r);
    area += V, ring.displacement += V * state.displacement[a].dot(n) / u;
    ring.hoop += V * hoop / (A * (1 + outer * outer / (r * r)));
  }
  return {ring.displacement / area, ring.hoop / area};
}

TEST(SolidWall, ThickCylinderUnderPressureIsLames) {
  for (const double nu : {0.3, 0.45, 0.49}) {
    const auto ring = pressed_ring(nu, 6, 0.5);
    EXPECT_NEAR(ring.displacement, 1.0, 0.02) << nu;
    EXPECT_NEAR(ring.hoop, 1.0, 0.05) << nu;
  }
  const double coarse = pressed_ring(0.3, 6, 0.5).displacement - 1,
               fine = pressed_ring(0.3, 12, 0.5).displacement - 1;
  EXPECT_GT(std::log2(coarse / fine), 1.3);
}

/// Plane strain in three dimensions: nothing moves along the axis. The layers of the cloud are irregular.
double pressed_tube(double nu, int layers, double t) {
  const double dp = t / layers, p = 1.0, outer = 1.0 + t, L = 0.8;
  const Moduli tissue = elastic(1e6, nu);
  auto wall = wall_cloud(shapes::tube_lumen(1.0, L, 160, 12), t, dp);
  wall.inner.pressure = p;
  wall.solid.held.assign(wall.solid.count(), 4);
  const auto m = make_solid(wall.solid, {.material = NeoHookean(tissue), .density = 1000, .spacing = dp});
  const auto state =
      settled<3>(m, {.patches = {wall.inner}}, std::sqrt(tissue.plate() / 1000) / (1 + 0.5 * t), 3.0);
  const double A = p / (outer * outer - 1.0) * (1 + nu) / tissue.E;
  double sum = 0, volume = 0;
  for (std::size_t a = 0; a < m.count(); ++a) {
    const Vec2 x = m.cloud.position[a].head<2>();
    const double r = x.norm(), V = m.cloud.volume[a];
    if (std::abs(m.cloud.position[a][2] - 0.5 * L) > 0.25 * L) continue;
    sum += V * state.displacement[a].head<2>().dot(x) / r / (A * ((1 - 2 * nu) * r + outer * outer / r));
    volume += V;
  }
  return sum / volume;
}

TEST(FullSolidWall, ThickTubeOfIrregularLayersUnderPressure) {
  for (const double nu : {0.3, 0.49}) {
    const double found = pressed_tube(nu, 6, 0.5);
    RecordProperty(fmt::format("nu_{}", nu), fmt::format("{:.4f}", found));
    EXPECT_NEAR(found, 1.0, 0.04) << nu;  // softer by the cloud's disorder: docs/theory/solid.md
  }
}

/// Not a test: prints the table of docs/theory/solid.md (--gtest_also_run_disabled_tests).
TEST(SolidWall, DISABLED_Table) {
  for (const double t : {0.2, 0.5})
    for (const double nu : {0.0, 0.3, 0.45, 0.49, 0.499})
      for (const int layers : {4, 6, 8, 12}) {
        const auto ring = pressed_ring(nu, layers, t);
        fmt::print("t {} nu {} layers {}: u {:+.2f} % hoop {:+.2f} %\n", t, nu, layers,
                   100 * (ring.displacement - 1), 100 * (ring.hoop - 1));
      }
}

}  // namespace
}  // namespace ostium::sph3d
