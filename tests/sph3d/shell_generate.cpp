// Shells made on the walls of vessels: evenness, areas, normals, thickness, ends, refusals.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "vessels.hpp"
#include "wall_shells.hpp"

namespace ostium::sph3d {
namespace {

using testing::AllOf;
using testing::HasSubstr;

template <int D>
void expect_even(const WallShell<D>& shell, const Lumen<D>& lumen, double spacing) {
  const Evenness e = evenness(shell, spacing);
  SCOPED_TRACE(testing::Message() << shell.count() << " particles, nearest " << e.nearest << " +- "
                                  << e.spread << ", least " << e.least << ", areas " << e.areas);
  EXPECT_NEAR(sum_of(shell.contact_area), lumen.wall_area, 1e-12 * lumen.wall_area);
  EXPECT_LT(e.areas, 1.5);
  EXPECT_GT(e.nearest, 0.85);
  EXPECT_LT(e.spread, 0.08);
  EXPECT_GT(e.least, 0.6);
}

template <int D>
std::string refusal(const Lumen<D>& lumen, const ShellWallOptions& options) {
  try {
    shell_of(lumen, options);
  } catch (const UserError& e) {
    return e.what();
  }
  return "nothing";
}

/// Largest angle between contact normals and the radius, degrees.
double worst_normal(const WallShell<3>& shell) {
  double cosine = 1;
  for (std::size_t a = 0; a < shell.count(); ++a) {
    const Vec3 x = shell.contact[a];
    cosine = std::min(cosine, shell.contact_normal[a].dot(Vec3(x[0], x[1], 0).normalized()));
  }
  return std::acos(cosine) * 180 / pi;
}

TEST(ShellGenerate, CylinderIsEvenAndTwoSurfacesAreApart) {
  const Carotid carotid;
  const auto lumen = carotid.lumen();
  const auto shell = shell_of(lumen, carotid.options(WallEnds::clamped));
  expect_even(shell, lumen, carotid.spacing);
  for (std::size_t a = 0; a < shell.count(); ++a) {
    const Vec3 x = shell.contact[a], middle = shell.cloud.position[a];
    EXPECT_NEAR(std::hypot(x[0], x[1]), carotid.radius, 1e-3 * carotid.radius);
    EXPECT_NEAR(std::hypot(middle[0], middle[1]), carotid.middle(), 1e-3 * carotid.radius);
    EXPECT_GT(x[2], 0.2 * carotid.spacing);
    EXPECT_LT(x[2], carotid.length - 0.2 * carotid.spacing);
  }
  EXPECT_NEAR(sum_of(shell.cloud.area), 2 * pi * carotid.middle() * carotid.length, 0.003 * lumen.wall_area);
}

// What smoothing leaves of the kinks between the facets of a polygon, and of a cylinder without visible facets.
TEST(ShellGenerate, NormalsOfACylinder) {
  Carotid carotid{.length = 6e-3, .around = 96};
  // the normal of a facet itself is off by up to half the angle between two of them
  EXPECT_LT(worst_normal(shell_of(carotid.lumen(), carotid.options(WallEnds::free))), 0.5 * 360 / 96);
  carotid.around = 384;
  EXPECT_LT(worst_normal(shell_of(carotid.lumen(), carotid.options(WallEnds::free))), 0.5);
}

TEST(ShellGenerate, EndsAreHeldByThreeRowsOrMore) {
  const Carotid carotid;
  const auto lumen = carotid.lumen();
  const double length = 2 * 1.3 * carotid.spacing + carotid.spacing;
  for (const auto ends : {WallEnds::clamped, WallEnds::released, WallEnds::free}) {
    const auto shell = shell_of(lumen, carotid.options(ends));
    const Support held = ends == WallEnds::clamped    ? Support::clamped
                         : ends == WallEnds::released ? Support::released
                                                      : Support::free;
    const double band = ends == WallEnds::free ? carotid.spacing : length;
    for (std::size_t a = 0; a < shell.count(); ++a) {
      const double z = shell.contact[a][2];
      int end = -1;
      for (int k = 0; k < 2; ++k)
        if (std::abs(z - lumen.openings[k].centre[2]) <= band) end = k;
      ASSERT_EQ(shell.opening[a], end) << z;
      EXPECT_EQ(shell.cloud.support[a], end < 0 ? Support::free : held);
      EXPECT_TRUE(end < 0 || std::abs(shell.cloud.axis[a][2]) > 1 - 1e-9);
    }
  }
}

TEST(ShellGenerate, GoesOnBeyondTheOpenings) {
  const Carotid carotid;
  auto options = carotid.options(WallEnds::clamped);
  options.beyond = 2e-3;
  const auto lumen = carotid.lumen();
  const auto shell = shell_of(lumen, options);
  const double around = lumen.wall_area / carotid.length;
  EXPECT_NEAR(sum_of(shell.contact_area), around * (carotid.length + 4e-3), 1e-9 * lumen.wall_area);
  for (std::size_t a = 0; a < shell.count(); ++a)
    EXPECT_TRUE((shell.contact[a][2] >= 0 && shell.contact[a][2] <= carotid.length) ||
                shell.cloud.support[a] == Support::clamped);
}

// The area of a tube around any centreline is its circumference times the length (Pappus), whatever the bend.
TEST(ShellGenerate, BendKeepsTheAreaOfItsMiddle) {
  const BendShape bend{.radius = 3e-3, .bend_radius = 9e-3, .inlet_length = 6e-3, .outlet_length = 6e-3};
  const auto lumen = lumen_of(generate(bend));
  const double t = 0.6e-3, dp = 0.45e-3;
  const auto shell = shell_of(lumen, {.spacing = dp, .fluid_spacing = dp, .thickness = t});
  expect_even(shell, lumen, dp);
  const double centreline = 12e-3 + 9e-3 * pi / 2;
  EXPECT_NEAR(sum_of(shell.cloud.area) / (2 * pi * 3.3e-3 * centreline), 1.0, 0.005);
}

TEST(ShellGenerate, ArchWithBranches) {
  const auto lumen = lumen_of(generate(ArchShape{}));
  const double dp = 1.5e-3;
  const auto shell = shell_of(lumen, {.spacing = dp, .fluid_spacing = dp, .thickness = 1e-3});
  expect_even(shell, lumen, dp);
  ASSERT_EQ(lumen.openings.size(), 7u);
  for (int k = 0; k < 7; ++k) EXPECT_GT(std::count(shell.opening.begin(), shell.opening.end(), k), 30) << k;
}

TEST(ShellGenerate, SameShellForAnyNumberOfThreads) {
  const Carotid carotid;
  std::vector<WallShell<3>> shells;
  for (int n : {1, 3}) {
    const Threads threads(n);
    shells.push_back(shell_of(carotid.lumen(), carotid.options(WallEnds::clamped)));
  }
  EXPECT_EQ(shells[0].contact, shells[1].contact);
  EXPECT_EQ(shells[0].contact_area, shells[1].contact_area);
  EXPECT_EQ(shells[0].cloud.position, shells[1].cloud.position);
  EXPECT_EQ(shells[0].cloud.area, shells[1].cloud.area);
}

TEST(ShellGenerate, PlaneChannel) {
  const auto lumen = plane_channel(0.05, 0.01);
  const double dp = 0.5e-3, t = 1e-3;
  const auto shell = shell_of(lumen, {.spacing = dp, .fluid_spacing = dp, .thickness = t});
  expect_even(shell, lumen, dp);
  EXPECT_EQ(shell.count(), 200u);
  int clamped = 0;
  for (std::size_t a = 0; a < shell.count(); ++a) {
    const bool top = shell.contact[a][1] > 0.005;
    EXPECT_NEAR(shell.cloud.position[a][1], top ? 0.01 + t / 2 : -t / 2, 1e-12);
    EXPECT_NEAR(shell.cloud.area[a], dp, 1e-12);
    clamped += shell.cloud.support[a] == Support::clamped;
  }
  EXPECT_EQ(clamped, 4 * 4);  // rows at 0.25, 0.75, 1.25, 1.75 mm, of 1.8 mm
}

TEST(ShellGenerate, PlaneBendKeepsTheLengthOfItsMiddle) {
  const double bend = 0.02, width = 0.01, dp = 0.25e-3, t = 2e-3;
  const auto lumen = plane_channel(0.02, width, bend);
  const auto shell = shell_of(lumen, {.spacing = dp, .fluid_spacing = dp, .thickness = t});
  expect_even(shell, lumen, dp);
  const double middle = 0.04 + pi / 2 * (bend + t / 2 + bend - width - t / 2);
  EXPECT_NEAR(sum_of(shell.cloud.area) / middle, 1.0, 0.002);
}

TEST(ShellGenerate, ThicknessByPointAndByDistance) {
  const Carotid carotid;
  const auto lumen = carotid.lumen();
  auto options = carotid.options(WallEnds::clamped);
  std::vector<double> of_point;
  for (const auto& x : lumen.surface.points) of_point.push_back(0.4e-3 + 0.01 * x[2]);
  options.thickness = of_point;
  const auto& first = lumen.openings[0];
  options.stiffness = FromOpening{.opening = first.name, .at_opening = 4, .away = 1, .length = 8e-3};
  const auto shell = shell_of(lumen, options);
  for (std::size_t a = 0; a < shell.count(); ++a) {
    const double z = shell.contact[a][2], away = std::abs(z - first.centre[2]);
    EXPECT_NEAR(shell.cloud.thickness[a], 0.4e-3 + 0.01 * z, 1e-9);
    EXPECT_NEAR(shell.cloud.stiffness[a], 4 - 3 * std::min(away / 8e-3, 1.0), 0.001);
    EXPECT_NEAR((shell.cloud.position[a] - shell.contact[a]).norm(), 0.5 * shell.cloud.thickness[a], 1e-12);
  }
}

TEST(ShellGenerate, RefusesSpacingsAndThicknesses) {
  const Carotid carotid;
  const auto lumen = carotid.lumen();
  auto coarse = carotid.options(WallEnds::clamped);
  coarse.fluid_spacing = 0.4e-3;
  EXPECT_THAT(refusal(lumen, coarse),
              HasSubstr("the shell spacing of 0.00045 m is coarser than the fluid's, 0.0004 m"));
  auto thin = carotid.options(WallEnds::clamped);
  thin.thickness = 0.0;
  EXPECT_THAT(refusal(lumen, thin), HasSubstr("the thickness of the wall is 0; it has to be positive"));
  thin.thickness = std::vector<double>(7, 1e-3);
  EXPECT_THAT(refusal(lumen, thin),
              HasSubstr("the thickness of the wall is given by 7 values, but the surface has"));
  std::vector<double> hole(lumen.surface.points.size(), 1e-3);
  hole[5] = -1e-3;
  thin.thickness = hole;
  EXPECT_THAT(refusal(lumen, thin),
              HasSubstr("the thickness of the wall is -0.001 at point 5 of the surface, at ("));
  thin.thickness = FromOpening{.opening = "opening3", .at_opening = 1e-3, .away = 1e-3, .length = 1e-2};
  EXPECT_THAT(refusal(lumen, thin),
              HasSubstr("varies from the opening 'opening3', which the vessel has not; did you mean"));
}

TEST(ShellGenerate, RefusesEndsThatAreNotPlane) {
  const Carotid carotid;
  auto lumen = carotid.lumen();
  lumen.openings[1].outline[3] += 0.2e-3 * lumen.openings[1].normal;
  EXPECT_THAT(
      refusal(lumen, carotid.options(WallEnds::clamped)),
      AllOf(
          HasSubstr("the end of the wall at the opening 'opening2' is not plane: at ("),
          HasSubstr(
              "lies 0.2 mm beside the plane, 3.3 % of the opening's width; a quarter of the wall's spacing, "
              "0.113 mm, is allowed")));
}

TEST(ShellGenerate, RefusesClampsWithNothingBetween) {
  Carotid carotid{.length = 4.2e-3};
  EXPECT_THAT(
      refusal(carotid.lumen(), carotid.options(WallEnds::clamped)),
      AllOf(HasSubstr("between the clamped ends of the wall at the openings 'opening1' and 'opening2'"),
            HasSubstr("it takes 3 or more")));
  carotid.length = 3e-3;
  EXPECT_THAT(refusal(carotid.lumen(), carotid.options(WallEnds::clamped)), HasSubstr("hold all of it"));
  carotid.length = 6e-3;
  EXPECT_EQ(refusal(carotid.lumen(), carotid.options(WallEnds::clamped)), "nothing");
  auto narrow = carotid.options(WallEnds::clamped);
  narrow.clamp_length = 1e-3;
  EXPECT_THAT(refusal(carotid.lumen(), narrow), HasSubstr("less than three rows of particles"));
}

}  // namespace
}  // namespace ostium::sph3d
