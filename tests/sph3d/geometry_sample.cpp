#include <gtest/gtest.h>

#include "core/error.hpp"
#include "shapes.hpp"
#include "sph3d/geometry/polygon.hpp"
#include "sph3d/geometry/sample.hpp"

namespace ostium::sph3d {
namespace {

TEST(SampleWall, TubeIsCoveredEvenly) {
  const double radius = 0.01, length = 0.04, spacing = 0.001;
  const auto lumen = shapes::tube_lumen(radius, length, 96, 24);
  const auto points = sample_wall(lumen, spacing);
  EXPECT_NEAR(double(points.size()), lumen.wall_area / (spacing * spacing), 0.02 * double(points.size()));
  double sum = 0, least = 1, most = 0, nearest = 1, force = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto& [x, n, area] = points[i];
    sum += area, least = std::min(least, area), most = std::max(most, area);
    EXPECT_NEAR(std::hypot(x.x(), x.y()), radius, 6e-4 * radius);
    EXPECT_GE(x.z(), 0);
    EXPECT_LE(x.z(), length);
    EXPECT_GT(n.dot(Vec3(x.x(), x.y(), 0).normalized()), 0.998);
    force += area * x.z() * x.z();
    for (std::size_t j = 0; j < i; ++j) nearest = std::min(nearest, (x - points[j].position).norm());
  }
  EXPECT_NEAR(sum, lumen.wall_area, 1e-12 * sum);
  EXPECT_LT(most / least, 1.5);
  EXPECT_GT(nearest, 0.6 * spacing);
  EXPECT_NEAR(force, lumen.wall_area * length * length / 3,
              0.005 * force);  // the integral of z^2 over the wall
}

TEST(SampleWall, NarrowTubeDoesNotPushAcross) {
  const auto lumen = shapes::tube_lumen(0.001, 0.02, 48, 60);  // as wide as the kernel
  const auto points = sample_wall(lumen, 0.001);
  Vec3 mean = Vec3::Zero();
  double sum = 0;
  for (const auto& p : points) mean += p.area * p.normal, sum += p.area;
  EXPECT_NEAR(sum, lumen.wall_area, 1e-12 * sum);
  EXPECT_LT(mean.norm(), 0.03 * sum);  // the normals of a closed ring cancel
}

TEST(SampleWall, SameLumenSamePoints) {
  const auto lumen = shapes::tube_lumen(0.005, 0.02, 48, 20);
  const auto a = sample_wall(lumen, 0.001), b = sample_wall(lumen, 0.001);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].position, b[i].position);
}

TEST(SampleWall, PlaneChannel) {
  const std::vector<Vec2> corners{{0, 0}, {0.05, 0}, {0.05, 0.01}, {0, 0.01}};
  const std::vector<OutlineOpening> ends{{.name = "in", .edge = 3}, {.name = "out", .edge = 1}};
  const auto lumen = polygon_lumen(corners, ends);
  const auto points = sample_wall(lumen, 0.001);
  EXPECT_EQ(points.size(), 100u);
  double sum = 0;
  for (const auto& p : points) {
    sum += p.area;
    EXPECT_NEAR(p.normal.y(), p.position.y() > 0.005 ? 1 : -1, 1e-15);
  }
  EXPECT_NEAR(sum, 0.1, 1e-15);
}

TEST(SampleWall, SpacingMustBePositive) {
  const auto lumen = shapes::tube_lumen(0.005, 0.02);
  EXPECT_THROW(sample_wall(lumen, 0), UserError);
}

}  // namespace
}  // namespace ostium::sph3d
