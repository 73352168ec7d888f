/// Which parts of a surface are openings, and how a case names them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "shapes.hpp"
#include "sph3d/geometry/choose.hpp"
#include "sph3d/geometry/read.hpp"
#include "sph3d/geometry/write_stl.hpp"

namespace ostium::sph3d {
namespace {

using testing::AllOf;
using testing::HasSubstr;

Lumen<3> read_back(const Surface<3>& surface, std::vector<OpeningChoice> choices = {}) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file =
      std::filesystem::temp_directory_path() / (std::string("ostium_openings_") + test->name() + ".stl");
  write_stl(surface, file);
  return read_lumen({.file = file, .length_unit = 1e-3, .openings = std::move(choices)});
}

/// A straight channel of any convex cross-section, its ends at z = 0 and z = length.
Surface<3> prism(const std::vector<Vec2>& section, double length, int along) {
  Surface<3> s;
  const int n = int(section.size());
  for (int k = 0; k <= along; ++k)
    for (const auto& x : section) s.points.emplace_back(x.x(), x.y(), length * k / along);
  for (int k = 0; k < along; ++k)
    for (int i = 0; i < n; ++i) {
      const int a = k * n + i, b = k * n + (i + 1) % n;
      s.facets.push_back({a, b, b + n}), s.facets.push_back({a, b + n, a + n});
    }
  for (int i = 1; i + 1 < n; ++i) {
    s.facets.push_back({0, i + 1, i});
    s.facets.push_back({along * n, along * n + i, along * n + i + 1});
  }
  s.label.assign(s.facets.size(), -1);
  return s;
}

std::vector<Vec2> regular(int n, double radius) {
  std::vector<Vec2> p;
  for (int i = 0; i < n; ++i)
    p.emplace_back(radius * std::cos(2 * pi * i / n), radius * std::sin(2 * pi * i / n));
  return p;
}

void expect_only_the_ends(const Lumen<3>& lumen) {
  ASSERT_EQ(lumen.openings.size(), 2u) << describe(lumen);
  for (const auto& o : lumen.openings) EXPECT_NEAR(std::abs(o.normal.z()), 1, 1e-6);
}

TEST(FindOpenings, CoarseTubesShowTheirEndsOnly) {
  for (int n : {5, 6, 8, 12, 18, 100}) expect_only_the_ends(read_back(prism(regular(n, 0.01), 0.1, 1)));
  expect_only_the_ends(read_back(prism(regular(18, 0.01), 0.1, 7)));
}

TEST(FindOpenings, BoxChannelsShowTheirEndsOnly) {
  const auto box = [](double w, double h) { return std::vector<Vec2>{{0, 0}, {w, 0}, {w, h}, {0, h}}; };
  expect_only_the_ends(read_back(prism(box(0.01, 0.01), 0.05, 1)));
  expect_only_the_ends(read_back(prism(box(0.04, 0.01), 0.05, 3)));
  expect_only_the_ends(read_back(prism(box(0.02, 0.01), 0.2, 9)));
}

TEST(FindOpenings, CubeIsRefusedAsItCannotBeTold) {
  const std::vector<Vec2> square{{0, 0}, {0.01, 0}, {0.01, 0.01}, {0, 0.01}};
  try {
    read_back(prism(square, 0.01, 1));
    FAIL();
  } catch (const UserError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("equally deep"), HasSubstr("ModelFaceID")));
  }
}

/// A vessel flattened on one side (by a neighbouring bone, say): smooth rim, no opening.
TEST(FindOpenings, FlatPatchOfAWallIsNoOpening) {
  auto tube = shapes::tube(0.01, 0.1, 64, 40);
  for (auto& x : tube.points) x.x() = std::min(x.x(), 0.0085);
  expect_only_the_ends(read_back(tube));
}

TEST(FindOpenings, ObliqueCutsAreOpenings) {
  auto tube = shapes::tube(0.01, 0.1, 48, 20);
  for (auto& x : tube.points) x.z() += 0.7 * x.x() * (x.z() / 0.1);  // 35 degrees at the far end
  const auto lumen = read_back(tube);
  ASSERT_EQ(lumen.openings.size(), 2u);
  EXPECT_NEAR(lumen.openings[0].area / lumen.openings[1].area, std::sqrt(1.49), 1e-3);
}

TEST(FindOpenings, SortedByAreaWithOutline) {
  auto tube = shapes::tube(0.01, 0.1, 64, 10);
  for (auto& x : tube.points) x.head<2>() *= 1 - 3 * x.z();
  const auto lumen = read_back(tube);
  ASSERT_EQ(lumen.openings.size(), 2u);
  EXPECT_NEAR(lumen.openings[0].centre.z(), 0, 1e-9);
  EXPECT_EQ(lumen.openings[0].name, "opening1");
  EXPECT_NEAR(lumen.openings[1].area / lumen.openings[0].area, 0.49, 1e-6);
  EXPECT_NEAR(width(lumen.openings[1]), 0.014 * std::cos(pi / 64), 3e-5);
  // Counter-clockwise seen from outside.
  Vec3 turning = Vec3::Zero();
  const auto& rim = lumen.openings[1].outline;
  for (std::size_t i = 0; i < rim.size(); ++i) turning += 0.5 * rim[i].cross(rim[(i + 1) % rim.size()]);
  EXPECT_NEAR(turning.dot(lumen.openings[1].normal), lumen.openings[1].area, 1e-9);
}

std::vector<Opening<3>> three() {
  std::vector<Opening<3>> o(3);
  for (int k = 0; k < 3; ++k) {
    o[k].name = "opening" + std::to_string(k + 1);
    o[k].centre = Vec3(0.01 * k, 0, 0);
    o[k].area = 1e-4 / (k + 1);
    o[k].face_id = 2 + k;
  }
  o[0].face_name = "inflow", o[1].face_name = "rt_iliac", o[2].face_name = "lt_iliac";
  return o;
}

TEST(NameOpenings, ByRankPlaceAndLabel) {
  auto o = three();
  name_openings(o, {{.name = "in", .largest = 1}, {.name = "right", .label = "rt_iliac"}});
  EXPECT_EQ(o[0].name, "in");
  EXPECT_EQ(o[1].name, "right");
  EXPECT_EQ(o[2].name, "opening3");
  o = three();
  name_openings(o, {{.name = "a", .nearest = Vec3(0.03, 0, 0)}, {.name = "b", .label = "2"}});
  EXPECT_EQ(o[2].name, "a");
  EXPECT_EQ(o[0].name, "b");
}

std::string refusal(const std::vector<OpeningChoice>& choices) {
  auto o = three();
  try {
    name_openings(o, choices);
  } catch (const UserError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(NameOpenings, Refusals) {
  EXPECT_THAT(refusal({{.name = "x", .label = "lt_illiac", .where = "case.yaml:7:5: "}}),
              AllOf(testing::StartsWith("case.yaml:7:5: opening 'x': no opening has the label lt_illiac"),
                    HasSubstr("did you mean \"lt_iliac\"?"), HasSubstr("opening3")));
  EXPECT_THAT(refusal({{.name = "x", .largest = 4}}), HasSubstr("`largest` lies between 1 and 3; found 4"));
  EXPECT_THAT(refusal({{.name = "x", .largest = 0}}), HasSubstr("found 0"));
  EXPECT_THAT(refusal({{.name = "x"}}), HasSubstr("exactly one of `largest`, `nearest`, `label`"));
  EXPECT_THAT(refusal({{.name = "a", .largest = 1}, {.name = "b", .label = "inflow"}}),
              HasSubstr("'a' and 'b' fall on the same opening"));
}

TEST(NameOpenings, LabelsAbsent) {
  auto o = three();
  for (auto& opening : o) opening.face_id = -1, opening.face_name.clear();
  EXPECT_THROW(
      {
        try {
          name_openings(o, {{.name = "x", .label = "3"}});
        } catch (const UserError& error) {
          EXPECT_THAT(error.what(), HasSubstr("carries no labels"));
          throw;
        }
      },
      UserError);
}

}  // namespace
}  // namespace ostium::sph3d
