#include <gtest/gtest.h>

#include <random>

#include "shapes.hpp"
#include "sph3d/geometry/closest_point.hpp"
#include "sph3d/geometry/edges.hpp"
#include "sph3d/geometry/polygon.hpp"
#include "sph3d/geometry/signed_distance.hpp"

namespace ostium::sph3d {
namespace {

template <int D>
std::vector<Vec<D>> random_points(int n, double half_width) {
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> uniform(-half_width, half_width);
  std::vector<Vec<D>> points(n);
  for (auto& x : points)
    for (int d = 0; d < D; ++d) x[d] = uniform(engine);
  return points;
}

template <int D>
double distance_by_looking_at_every_facet(const Surface<D>& s, const Vec<D>& x) {
  double least = 1e300;
  for (const auto& f : s.facets) {
    std::array<Vec<D>, D> corners;
    for (int k = 0; k < D; ++k) corners[k] = s.points[f[k]];
    least = std::min(least, (closest_on_facet(corners, x).point - x).norm());
  }
  return least;
}

TEST(SignedDistance, SphereIsExactUpToItsFaceting) {
  const double radius = 0.01;
  const auto surface = shapes::sphere(radius, 5);
  const SignedDistance<3> distance(surface);
  for (const auto& x : random_points<3>(5000, 2 * radius)) {
    const auto hit = distance(x);
    EXPECT_NEAR(hit.phi, x.norm() - radius, 1e-3 * radius);
    if (x.norm() > 0.3 * radius) {
      EXPECT_GT(hit.normal.dot(x.normalized()), 0.995) << x.transpose();
    }
  }
}

TEST(SignedDistance, AgreesWithEveryFacetLookedAt) {
  const auto surface = shapes::tube(0.01, 0.05, 18, 3);  // long facets, sharp rims
  const SignedDistance<3> distance(surface);
  for (const auto& x : random_points<3>(3000, 0.06)) {
    const auto hit = distance(x);
    EXPECT_NEAR(std::abs(hit.phi), distance_by_looking_at_every_facet<3>(surface, x), 1e-15);
    EXPECT_NEAR((x - hit.closest).norm(), std::abs(hit.phi), 1e-15);
    EXPECT_LT((hit.closest + hit.phi * hit.normal - x).norm(), 1e-14);
  }
}

/// A prism over an 18-gon is convex in its cross-section: inside or outside is known exactly.
TEST(SignedDistance, SignIsRightNextToRimsAndCorners) {
  const int around = 18;
  const auto surface = shapes::tube(1, 2, around, 1);
  const SignedDistance<3> distance(surface);
  std::mt19937 engine(3);
  std::normal_distribution<double> near(0, 1e-4);
  for (const auto& corner : surface.points)
    for (int k = 0; k < 200; ++k) {
      const Vec3 x = corner + Vec3(near(engine), near(engine), near(engine));
      const double sector = 2 * pi / around,
                   angle = std::remainder(std::atan2(x.y(), x.x()) - sector / 2, sector);
      const double apothem = std::hypot(x.x(), x.y()) * std::cos(angle) - std::cos(sector / 2);
      const double outside = std::max({apothem, -x.z(), x.z() - 2});
      if (std::abs(outside) < 1e-9) continue;
      EXPECT_EQ(distance(x).phi < 0, outside < 0) << x.transpose();
      if (outside < 0) {
        EXPECT_NEAR(distance(x).phi, outside, 1e-12);
      }
    }
}

TEST(SignedDistance, BoundSkipsFarFacetsAndKeepsNearOnes) {
  const auto surface = shapes::sphere(1, 3);
  const SignedDistance<3> distance(surface);
  EXPECT_EQ(distance(Vec3(0, 0, 0), 0.5).facet, -1);
  EXPECT_TRUE(std::isinf(distance(Vec3(0, 0, 0), 0.5).phi));
  const Vec3 x(0.3, 0.9, 0.1);
  EXPECT_EQ(distance(x, 0.2).phi, distance(x).phi);
}

TEST(SignedDistance, NormalOnTheSurfaceIsThePseudoNormal) {
  const auto surface = shapes::tube(1, 2, 64, 4);
  const SignedDistance<3> distance(surface);
  EXPECT_NEAR(distance(Vec3(0.2, 0.3, 2)).normal.z(), 1, 1e-12);
  const auto rim = distance(surface.points[4 * 64]);
  EXPECT_NEAR(rim.phi, 0, 1e-15);
  EXPECT_NEAR(rim.normal.z(), std::sqrt(0.5), 0.05);
}

TEST(SignedDistance, FarFromTheOriginNothingChanges) {
  auto surface = shapes::sphere(0.01, 3);
  const SignedDistance<3> here(surface);
  const Vec3 shift(0.3, -5, 12);
  for (auto& x : surface.points) x += shift;
  const SignedDistance<3> there(surface);
  for (const auto& x : random_points<3>(500, 0.02)) EXPECT_NEAR(here(x).phi, there(x + shift).phi, 1e-14);
}

/// Zero-area facets (collinear corners) come with CAD surfaces; the distance must not notice them.
TEST(SignedDistance, FacetsWithoutAreaAreHarmless) {
  auto surface = shapes::tube(1, 2, 16, 2);
  const Vec3 x0 = surface.points[surface.facets[0][0]], x1 = surface.points[surface.facets[0][1]];
  const int other = neighbours(surface.facets)[0][0], middle = int(surface.points.size());
  surface.points.push_back(0.5 * (x0 + x1));
  const auto [a, b, c] = surface.facets[0];
  surface.facets[0] = {a, middle, c};
  surface.facets.push_back({middle, b, c}), surface.label.push_back(-1);
  surface.facets.push_back({a, b, middle}), surface.label.push_back(-1);
  ASSERT_GE(other, 0);
  ASSERT_NEAR(area_vector(surface, int(surface.facets.size()) - 1).norm(), 0, 1e-17);
  const SignedDistance<3> sliver(surface), plain(shapes::tube(1, 2, 16, 2));
  for (const auto& x : random_points<3>(3000, 2.5)) EXPECT_NEAR(sliver(x).phi, plain(x).phi, 1e-12);
  for (const auto& e : random_points<3>(300, 1e-6)) {
    const Vec3 x = 0.5 * (x0 + x1) + e;
    EXPECT_NEAR(sliver(x).phi, plain(x).phi, 1e-12);
  }
}

TEST(SignedDistance, PlaneOutline) {
  const std::vector<Vec2> corners{{0, 0}, {4, 0}, {4, 1}, {2, 1}, {2, 2}, {0, 2}};  // an L
  const std::vector<OutlineOpening> ends{{.name = "in", .edge = 5}};
  const auto lumen = polygon_lumen(corners, ends);
  const SignedDistance<2> distance(lumen.surface);
  EXPECT_NEAR(distance(Vec2(1, 0.25)).phi, -0.25, 1e-15);
  EXPECT_NEAR(distance(Vec2(2.3, 1.4)).phi, 0.3, 1e-15);  // beside the re-entrant corner
  EXPECT_NEAR(distance(Vec2(5, -1)).phi, std::sqrt(2), 1e-15);
  EXPECT_NEAR(distance(Vec2(5, -1)).normal.x(), std::sqrt(0.5), 1e-15);
  for (const auto& x : random_points<2>(2000, 5)) {
    const bool inside = x.x() > 0 && x.y() > 0 && ((x.x() < 4 && x.y() < 1) || (x.x() < 2 && x.y() < 2));
    EXPECT_EQ(distance(x).phi < 0, inside) << x.transpose();
    EXPECT_NEAR(std::abs(distance(x).phi), distance_by_looking_at_every_facet<2>(lumen.surface, x), 1e-14);
  }
}

}  // namespace
}  // namespace ostium::sph3d
