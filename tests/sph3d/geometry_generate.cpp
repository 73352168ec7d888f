/// Generated vessels: closed, smooth, with the areas and volumes their parameters say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "sph3d/geometry/edges.hpp"
#include "sph3d/geometry/generate.hpp"
#include "sph3d/geometry/pseudo_normals.hpp"
#include "sph3d/geometry/read.hpp"
#include "sph3d/geometry/write_stl.hpp"

namespace ostium::sph3d {
namespace {

using testing::HasSubstr;

Lumen<3> through_file(const Surface<3>& surface) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const auto file =
      std::filesystem::temp_directory_path() / (std::string("ostium_generate_") + test->name() + ".stl");
  write_stl(surface, file);
  const auto lumen = read_lumen({.file = file, .length_unit = 1e-3});
  EXPECT_THAT(lumen.repairs, testing::IsEmpty());
  return lumen;
}

double circle(double radius) { return pi * radius * radius; }

/// The opening that lies nearest to x.
const Opening<3>& at(const Lumen<3>& lumen, const Vec3& x) {
  return *std::min_element(lumen.openings.begin(), lumen.openings.end(), [&](const auto& a, const auto& b) {
    return (a.centre - x).norm() < (b.centre - x).norm();
  });
}

/// Largest angle between neighbouring wall facets, degrees.
double roughness(const Surface<3>& s) {
  const auto normal = facet_normals(s);
  const auto beyond = neighbours(s.facets);
  double least = 1;
  for (std::size_t f = 0; f < s.facets.size(); ++f)
    for (int g : beyond[f])
      if (s.label[f] == -1 && s.label[g] == -1) least = std::min(least, normal[f].dot(normal[g]));
  return std::acos(least) * 180 / pi;
}

TEST(Generate, TubeIsExact) {
  const auto lumen = through_file(generate(TubeShape{.radius = 0.008, .length = 0.07}));
  ASSERT_EQ(lumen.openings.size(), 2u);
  EXPECT_NEAR(lumen.volume, circle(0.008) * 0.07, 1e-5 * lumen.volume);
  EXPECT_NEAR(lumen.openings[0].area, circle(0.008), 1e-5 * circle(0.008));
  EXPECT_NEAR(lumen.wall_area, 2 * pi * 0.008 * 0.07, 1e-3 * lumen.wall_area);
}

TEST(Generate, TaperedTube) {
  const double a = 0.01, b = 0.006, length = 0.05;
  const auto lumen = through_file(generate(TubeShape{.radius = a, .length = length, .outlet_radius = b}));
  EXPECT_NEAR(lumen.volume, pi * length / 3 * (a * a + a * b + b * b), 1e-4 * lumen.volume);
  EXPECT_NEAR(lumen.openings[1].area, circle(b), 1e-4 * circle(b));
}

TEST(Generate, BendByPappus) {
  const BendShape shape{
      .radius = 0.007, .bend_radius = 0.02, .angle = 2.5, .inlet_length = 0.01, .outlet_length = 0};
  const auto lumen = through_file(generate(shape));
  ASSERT_EQ(lumen.openings.size(), 2u);
  EXPECT_NEAR(lumen.volume, circle(0.007) * (0.01 + 0.02 * 2.5), 1e-3 * lumen.volume);
  const auto& out = at(lumen, Vec3(0.02 * (1 - std::cos(2.5)), 0, 0.02 * std::sin(2.5)));
  EXPECT_NEAR(out.area, circle(0.007), 1e-4 * out.area);
  EXPECT_LT((out.normal - Vec3(std::sin(2.5), 0, std::cos(2.5))).norm(), 1e-4);
}

TEST(Generate, Bifurcation) {
  const BifurcationShape shape{.second_daughter_radius = 0.0035};
  const auto surface = generate(shape);
  const auto lumen = through_file(surface);
  ASSERT_EQ(lumen.openings.size(), 3u) << describe(lumen);
  EXPECT_NEAR(lumen.openings[0].area, circle(0.006), 0.01 * lumen.openings[0].area);
  EXPECT_NEAR(lumen.openings[1].area, circle(0.0045), 0.01 * lumen.openings[1].area);
  EXPECT_NEAR(lumen.openings[2].area, circle(0.0035), 0.01 * lumen.openings[2].area);
  EXPECT_NEAR(lumen.openings[2].normal.x(), 0.5, 1e-3);
  for (const auto& o : lumen.openings) EXPECT_LT(o.planarity, 1e-8);
  EXPECT_LT(roughness(surface), 30);
}

TEST(Generate, ArchHasFiveBranchesAndTwoEnds) {
  const ArchShape shape;
  const auto surface = generate(shape);
  const auto lumen = through_file(surface);
  ASSERT_EQ(lumen.openings.size(), 7u) << describe(lumen);
  EXPECT_NEAR(at(lumen, Vec3(-0.03, 0, -0.03)).area, circle(0.0125), 0.01 * circle(0.0125));
  EXPECT_NEAR(at(lumen, Vec3(0.03, 0, -0.06)).area, circle(0.0095), 0.01 * circle(0.0095));
  auto radii = shape.branch_radii;
  std::sort(radii.rbegin(), radii.rend());
  for (int k = 0; k < 5; ++k)
    EXPECT_NEAR(lumen.openings[k + 2].area, circle(radii[k]), 0.01 * circle(radii[k]));
  for (const auto& o : lumen.openings) {
    EXPECT_LT(o.planarity, 1e-8);
    EXPECT_GT(width(o), 0.95 * std::sqrt(4 * o.area / pi));
  }
  // The trunk alone, by Pappus: the branches add theirs, less what lies inside the trunk.
  const double mean2 = (0.0125 * 0.0125 + 0.0125 * 0.0095 + 0.0095 * 0.0095) / 3;
  const double trunk = pi * mean2 * (0.09 + pi * 0.03);
  double branches = 0;
  for (double r : shape.branch_radii) branches += circle(r) * shape.branch_length;
  EXPECT_NEAR(lumen.volume, trunk + branches, 0.03 * lumen.volume);
  EXPECT_LT(roughness(surface), 40);
}

TEST(Generate, LabelsFollowTheOrderOfTheParameters) {
  const ArchShape shape{.branch_radii = {0.006, 0.0035, 0.005}};
  const auto s = generate(shape);
  EXPECT_NEAR(area(s, 0), circle(shape.ascending_radius), 0.01 * area(s, 0));
  EXPECT_NEAR(area(s, 1), circle(shape.descending_radius), 0.01 * area(s, 1));
  for (int b = 0; b < 3; ++b)
    EXPECT_NEAR(area(s, b + 2), circle(shape.branch_radii[b]), 0.01 * area(s, b + 2));
}

/// Tubes at many angles to the grid they were polygonised on: always closed.
TEST(Generate, ManyBifurcationsAreClosed) {
  for (int k = 0; k < 40; k += 5) {
    const BifurcationShape shape{.second_daughter_radius = 0.0025 + 0.00005 * k, .angle = 0.6 + 0.05 * k};
    EXPECT_EQ(through_file(generate(shape)).openings.size(), 3u) << k;
  }
}

template <class Shape>
std::string refusal(const Shape& shape) {
  try {
    generate(shape);
  } catch (const UserError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(Generate, Refusals) {
  EXPECT_THAT(refusal(TubeShape{.radius = -1}), HasSubstr("radius: a positive size, found -1"));
  EXPECT_THAT(refusal(TubeShape{.around = 3}), HasSubstr("between 8 and 100000 sides, found 3"));
  EXPECT_THAT(refusal(BendShape{.radius = 0.03, .bend_radius = 0.02}), HasSubstr("inner wall folds"));
  EXPECT_THAT(refusal(BifurcationShape{.daughter_length = 0.005}), HasSubstr("daughter_length: at least"));
  EXPECT_THAT(refusal(BifurcationShape{.angle = 0.1}), HasSubstr("between 20 and 180 degrees"));
  EXPECT_THAT(refusal(BifurcationShape{.edge = 0.01}), HasSubstr("at most half the smallest radius"));
  EXPECT_THAT(refusal(BifurcationShape{.edge = 1e-6}), HasSubstr("grid cells"));
  EXPECT_THAT(refusal(ArchShape{.arch_radius = 0.01}), HasSubstr("arch_radius: at least 1.3 times"));
  EXPECT_THAT(refusal(ArchShape{.branch_radii = {0.008, 0.008, 0.008, 0.008}}), HasSubstr("do not fit"));
}

}  // namespace
}  // namespace ostium::sph3d
