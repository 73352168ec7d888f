#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "shapes.hpp"
#include "sph3d/geometry/edges.hpp"
#include "sph3d/geometry/outline.hpp"
#include "sph3d/geometry/polygon.hpp"

namespace ostium::sph3d {
namespace {

/// Every edge is shared by two facets that run along it in opposite senses.
bool closed_and_oriented(const Surface<3>& s) {
  bool good = true;
  for_each_edge(edge_uses(s.facets), [&](std::span<const EdgeUse> uses) {
    good = good && uses.size() == 2 && forward(s.facets, uses[0]) != forward(s.facets, uses[1]);
  });
  return good;
}

TEST(Lumen, VolumeAndAreaOfATube) {
  const int around = 64;
  const auto lumen = shapes::tube_lumen(0.01, 0.1, around);
  const double polygon = 0.5 * around * std::sin(2 * pi / around) * 1e-4;
  EXPECT_NEAR(lumen.volume, polygon * 0.1, 1e-15);
  EXPECT_NEAR(lumen.openings[0].area, polygon, 1e-15);
  EXPECT_NEAR(lumen.wall_area, around * 2 * 0.01 * std::sin(pi / around) * 0.1, 1e-15);
}

TEST(Lumen, ExtendedIsWatertightLongerAndStraight) {
  const auto lumen = shapes::tube_lumen(0.01, 0.1);
  const auto longer = extended(lumen, 0.02);
  EXPECT_TRUE(closed_and_oriented(longer.surface));
  EXPECT_NEAR(longer.volume, lumen.volume * 1.4, 1e-12);
  EXPECT_NEAR(longer.wall_area, lumen.wall_area * 1.4, 1e-12);
  for (int k = 0; k < 2; ++k) {
    EXPECT_NEAR(area(longer.surface, k), lumen.openings[k].area, 1e-15);
    EXPECT_EQ(longer.openings[k].centre, lumen.openings[k].centre);
  }
  EXPECT_NEAR(bounds(longer.surface.points).lower.z(), -0.02, 1e-15);
}

TEST(Lumen, ExtendedFlattensAnUnevenOpening) {
  auto lumen = shapes::tube_lumen(0.01, 0.1);
  lumen.surface.points.back().z() += 5e-4;
  const auto longer = extended(lumen, 0.02);
  for (std::size_t f = 0; f < longer.surface.facets.size(); ++f) {
    if (longer.surface.label[f] != 1) continue;
    for (int v : longer.surface.facets[f]) EXPECT_NEAR(longer.surface.points[v].z(), 0.12, 1e-15);
  }
}

TEST(Lumen, InsideOutline) {
  const auto lumen = shapes::tube_lumen(0.01, 0.1);
  const auto& inlet = lumen.openings[0];
  EXPECT_TRUE(inside_outline(inlet, Vec3(0.009, 0, 0.05)));
  EXPECT_TRUE(inside_outline(inlet, Vec3(0.001, -0.007, -1)));
  EXPECT_FALSE(inside_outline(inlet, Vec3(0.0101, 0, 0)));
  EXPECT_FALSE(inside_outline(inlet, Vec3(0.008, 0.008, 0)));
}

TEST(Lumen, WidthIsTheLargestCircle) {
  const auto lumen = shapes::tube_lumen(0.01, 0.1, 64);
  EXPECT_NEAR(width(lumen.openings[0]), 0.02 * std::cos(pi / 64), 2e-5);
  Opening<3> slot{.centre = Vec3(1, 2, 3), .normal = Vec3::UnitX()};
  for (auto [y, z] : {std::pair{0.0, 0.0}, {8, 0}, {8, 1}, {0, 1}})
    slot.outline.emplace_back(1, 2 + y, 3 + z);
  EXPECT_NEAR(width(slot), 1, 2e-3);
}

TEST(Lumen, TangentsAreRightHanded) {
  for (Vec3 n : {Vec3(1, 0, 0), Vec3(0, -1, 0), Vec3(0.6, 0, -0.8), Vec3(1, 2, 3).normalized()}) {
    const auto t = plane_frame(n);
    EXPECT_LT((Vec3(t.col(0)).cross(Vec3(t.col(1))) - n).norm(), 1e-15);
  }
}

TEST(Outline, EarsFillANonConvexPolygon) {
  const Polygon star = [] {
    Polygon p;
    for (int i = 0; i < 20; ++i) {
      const double r = i % 2 ? 1 : 0.3, a = 2 * pi * i / 20;
      p.emplace_back(r * std::cos(a), r * std::sin(a));
    }
    return p;
  }();
  double sum = 0;
  for (auto [a, b, c] : triangulate(star)) {
    const double part = signed_area(Polygon{star[a], star[b], star[c]});
    EXPECT_GT(part, 0);
    sum += part;
  }
  EXPECT_NEAR(sum, signed_area(star), 1e-14);
}

const std::vector<Vec2> channel{{0, 0}, {0, 0.01}, {0.05, 0.01}, {0.05, 0}};  // clockwise

TEST(PolygonLumen, ChannelTurnedAndNamed) {
  const std::vector<OutlineOpening> ends{{.name = "in", .edge = 0},
                                         {.name = "out", .nearest = Vec2(0.06, 0.005)}};
  const auto lumen = polygon_lumen(channel, ends);
  EXPECT_NEAR(lumen.volume, 5e-4, 1e-18);
  EXPECT_NEAR(lumen.wall_area, 0.1, 1e-16);
  EXPECT_EQ(lumen.openings[0].normal, Vec2(-1, 0));
  EXPECT_EQ(lumen.openings[1].normal, Vec2(1, 0));
  EXPECT_EQ(lumen.openings[1].face_id, 2);
  EXPECT_NEAR(width(lumen.openings[1]), 0.01, 1e-17);
  EXPECT_THAT(lumen.repairs, testing::ElementsAre(testing::HasSubstr("clockwise")));
  EXPECT_TRUE(inside_outline(lumen.openings[0], Vec2(0.3, 0.004)));
  EXPECT_FALSE(inside_outline(lumen.openings[0], Vec2(0.0, 0.011)));
  const auto longer = extended(lumen, 0.02);
  EXPECT_NEAR(longer.volume, 9e-4, 1e-17);
  EXPECT_NEAR(longer.wall_area, 0.18, 1e-15);
}

void expect_refused(const std::vector<Vec2>& p, const std::vector<OutlineOpening>& o,
                    const std::string& text) {
  try {
    polygon_lumen(p, o);
    FAIL() << "accepted";
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(text));
  }
}

TEST(PolygonLumen, Refusals) {
  expect_refused({{0, 0}, {1, 0}}, {{.name = "in", .edge = 0}}, "at least three corners, found 2");
  expect_refused(channel, {}, "no opening");
  expect_refused(channel, {{.name = "in", .edge = 4}}, "no edge 4; its edges are numbered 0 to 3");
  expect_refused(channel, {{.name = "in"}}, "by `edge` or by `nearest`");
  expect_refused(channel, {{.name = "a", .edge = 1}, {.name = "b", .edge = 1}},
                 "'a' and 'b' name the same edge 1");
  expect_refused({{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {{.name = "in", .edge = 1}}, "the edges 0 and 2 cross");
  expect_refused({{0, 0}, {1, 0}, {1, 0}, {0, 1}}, {{.name = "in", .edge = 0}}, "corners 1 and 2 coincide");
}

}  // namespace
}  // namespace ostium::sph3d
