// How tightly a wall is bent, measured against exact shapes; what is refused and what is warned of; directions around a vessel.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"
#include "sph3d/shell/lateral.hpp"
#include "sph3d/shell/surface_bending.hpp"
#include "sph3d/shell/weights.hpp"
#include "wall_shells.hpp"

namespace ostium::sph3d {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

double degrees(double cosine) { return std::acos(std::min(std::abs(cosine), 1.0)) * 180 / pi; }

SurfacePoints<3> points_of(const Lumen<3>& lumen, double spacing) {
  std::vector<Rim<3>> rims;
  for (const auto& o : lumen.openings) rims.emplace_back(o, 0.0);
  return surface_points(lateral(lumen.surface), rims, spacing, 200);
}

struct Bent {
  std::vector<Vec3> normal;
  std::vector<Curvatures<3>> k;

  Bent(const SurfacePoints<3>& points, double spacing, double thickness) {
    const SurfaceAverage<3> average(points, spacing);
    const std::vector<double> t(points.position.size(), thickness);
    normal = wall_normals(points, average, contact_normals(points, average), t, spacing);
    for (const auto& S : bending(points, average.pairs(), normal, spacing)) k.push_back(principal<3>(S));
  }
};

/// Root mean square of both curvatures' errors times a length, and the largest, over the points that `inside` names.
struct Errors {
  double mean = 0, worst = 0;

  template <class Exact, class Inside>
  Errors(const SurfacePoints<3>& p, const Bent& bent, double length, Exact exact, Inside inside) {
    int n = 0;
    for (std::size_t a = 0; a < p.position.size(); ++a) {
      if (!inside(p.position[a])) continue;
      Curvatures<3> k = exact(p.position[a]);
      if (k[0] > k[1]) std::swap(k[0], k[1]);
      const double error = length * (bent.k[a] - k).cwiseAbs().maxCoeff();
      mean += error * error, worst = std::max(worst, error), ++n;
    }
    mean = std::sqrt(mean / n);
  }
};

std::ostream& operator<<(std::ostream& out, const Errors& e) {
  return out << e.mean << ", worst " << e.worst;
}

// An artery's wall, a fifth of the radius thick, on a polygon of 96 sides.
TEST(ShellBending, CurvatureOfATube) {
  const Carotid tube;
  const auto points = points_of(tube.lumen(), tube.spacing);
  const Errors e(
      points, Bent(points, tube.spacing, tube.thickness), tube.radius,
      [&](const Vec3&) { return Curvatures<3>(0, 1 / tube.radius); }, [](const Vec3&) { return true; });
  SCOPED_TRACE(testing::Message() << e);
  EXPECT_LT(e.mean, 0.03);
  EXPECT_LT(e.worst, 0.1);
}

TEST(ShellBending, CurvatureOfABend) {
  const BendShape bend{.radius = 3e-3, .bend_radius = 9e-3, .inlet_length = 6e-3, .outlet_length = 6e-3};
  const auto points = points_of(lumen_of(generate(bend)), 0.45e-3);
  const double R = bend.bend_radius, r = bend.radius;
  const Errors e(
      points, Bent(points, 0.45e-3, 0.6e-3), r,
      [&](const Vec3& x) {
        const double from_centre = std::hypot(R - x[0], x[2]);
        return Curvatures<3>((from_centre - R) / r / from_centre, 1 / r);
      },
      [&](const Vec3& x) { return x[2] > 2e-3 && x[0] < R - 2e-3; });
  SCOPED_TRACE(testing::Message() << e);
  EXPECT_LT(e.mean, 0.03);
  EXPECT_LT(e.worst, 0.1);
}

/// Evenly on a sphere (Fibonacci), normals off by `noise` radians in both directions.
SurfacePoints<3> sphere(double radius, double spacing, double noise) {
  SurfacePoints<3> p;
  std::mt19937 random(7);
  std::normal_distribution<double> off(0, noise);
  const int n = int(4 * pi * radius * radius / (spacing * spacing));
  for (int k = 0; k < n; ++k) {
    const double z = 1 - (2 * k + 1.0) / n, phi = 2.399963229728653 * k;
    const Vec3 u(std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z);
    p.position.push_back(radius * u);
    p.normal.push_back((u + Vec3(off(random), off(random), off(random))).normalized());
    p.area.push_back(4 * pi * radius * radius / n);
  }
  return p;
}

// Facets that lean by 15 degrees at random, as on a segmented vessel: over two spacings the curvature is off by three quarters of 1/R,
// over the length of a wall of five spacings by an eighth.
TEST(ShellBending, CurvatureOfASphereOfRoughFacets) {
  const double R = 10e-3, dp = 1e-3;
  const auto exact = [&](const Vec3&) { return Curvatures<3>(1 / R, 1 / R); };
  const auto all = [](const Vec3&) { return true; };
  const auto smooth = sphere(R, dp, 0), rough = sphere(R, dp, 0.26);
  const Errors bare(smooth, Bent(smooth, dp, 2.5e-3), R, exact, all);
  const Errors thin(rough, Bent(rough, dp, 0.1e-3), R, exact, all);
  const Errors thick(rough, Bent(rough, dp, 5e-3), R, exact, all);
  SCOPED_TRACE(testing::Message() << bare << "; rough " << thin << "; thick " << thick);
  EXPECT_LT(bare.mean, 0.01);
  EXPECT_LT(bare.worst, 0.05);
  EXPECT_LT(thick.mean, 0.3 * thin.mean);
}

std::string refusal(const Lumen<3>& lumen, const ShellWallOptions& options) {
  try {
    shell_of(lumen, options);
  } catch (const UserError& e) {
    return e.what();
  }
  return "nothing";
}

ShellWallOptions wall(double spacing, double thickness) {
  return {.spacing = spacing, .fluid_spacing = spacing, .thickness = thickness};
}

TEST(ShellBending, RefusesATubeOfTooSmallARadius) {
  const auto lumen = lumen_of(generate(TubeShape{.radius = 3e-3, .length = 20e-3}));
  EXPECT_THAT(refusal(lumen, wall(1e-3, 2.5e-3)),
              AllOf(HasSubstr("the wall is 0.0025 m thick at ("), HasSubstr("bent with a radius of 0.004"),
                    HasSubstr("100.0 % of the wall"), HasSubstr("a radius of 2 thicknesses"),
                    HasSubstr("Make the wall thinner")));
  const auto shell = shell_of(lumen, wall(1e-3, 1.6e-3));
  EXPECT_NEAR(shell.bends.ratio, 1.6 / 3.8, 0.02);
  EXPECT_THAT(shell.warnings, ElementsAre());
}

// 0.6 mm inside, half a circle long, with a wall of 2 mm.
TEST(ShellBending, RefusesASharpBend) {
  const auto lumen = lumen_of(generate(BendShape{
      .radius = 6e-3, .bend_radius = 6.6e-3, .angle = pi, .inlet_length = 9e-3, .outlet_length = 9e-3}));
  EXPECT_THAT(refusal(lumen, wall(0.6e-3, 2e-3)), AllOf(HasSubstr("the wall is 0.002 m thick at (7.2"),
                                                        HasSubstr("there it would cross itself")));
}

TEST(ShellBending, RefusesAnArchWhoseBranchesAreTooNarrow) {
  EXPECT_THAT(refusal(lumen_of(generate(ArchShape{})), wall(2.5e-3, 2.5e-3)),
              HasSubstr("of the wall are bent more tightly than a shell allows"));
}

// A bend of 3 mm inside, with a wall of 2 mm: its middle has 2 mm there, on a fiftieth of the wall.
TEST(ShellBending, WarnsWhereLittleIsBentTooTightly) {
  const auto lumen = lumen_of(
      generate(BendShape{.radius = 6e-3, .bend_radius = 9e-3, .inlet_length = 9e-3, .outlet_length = 9e-3}));
  const auto shell = shell_of(lumen, wall(0.6e-3, 2e-3));
  EXPECT_NEAR(shell.bends.radius, 2e-3, 0.2e-3);
  EXPECT_GT(shell.bends.share, 0.005);
  EXPECT_LT(shell.bends.share, 0.04);
  ASSERT_EQ(shell.warnings.size(), 1u);
  EXPECT_THAT(shell.warnings[0],
              AllOf(HasSubstr("the wall is 0.002 m thick at (6.8"), HasSubstr("estimates")));
  auto strict = wall(0.6e-3, 2e-3);
  strict.bent_share = 0.001;
  EXPECT_THAT(refusal(lumen, strict), HasSubstr("up to 0.1 % would do"));
}

// A branch that leaves a channel at right angles, with a wall a tenth of its width: two sharp valleys, and the same wall whatever
// the spacing.
TEST(ShellBending, SharpCornersOfAPlaneTee) {
  const std::vector<Vec2> outline{{0, .2}, {.5, .2}, {.5, 0}, {.6, 0}, {.6, .5}, {.5, .5}, {.5, .3}, {0, .3}};
  const std::vector<OutlineOpening> openings{
      {.name = "in", .edge = 7}, {.name = "low", .edge = 2}, {.name = "high", .edge = 4}};
  const auto lumen = polygon_lumen(outline, openings);
  const Vec2 corner(0.5, 0.2);
  for (const double dp : {5e-3, 2.5e-3, 1.25e-3}) {
    const auto shell = shell_of(lumen, {.spacing = dp, .fluid_spacing = dp, .thickness = 0.01});
    double nearest = 1e300, inset = 1e300;
    for (std::size_t a = 0; a < shell.count(); ++a) {
      inset = std::min(inset, (shell.cloud.position[a] - corner).norm() / 0.01);
      EXPECT_GT(shell.cloud.area[a], 0.55 * shell.contact_area[a]);
      for (std::size_t b = 0; b < a; ++b)
        nearest = std::min(nearest, (shell.cloud.position[a] - shell.cloud.position[b]).norm() / dp);
    }
    SCOPED_TRACE(testing::Message() << dp << ": nearest " << nearest << ", inset " << inset);
    EXPECT_GT(nearest, 0.45);
    EXPECT_GT(inset, 0.5);   // of a plane wall
    EXPECT_LT(inset, 0.71);  // of a wall with a sharp corner
    EXPECT_NEAR(shell.bends.ratio, 1.3, 0.1);
    EXPECT_NEAR(shell.bends.share, 0.022, 0.004);
    EXPECT_EQ(shell.warnings.size(), 1u);
  }
}

/// Largest angle to the tangent of the section, degrees, over the points that `inside` names.
template <class Axis, class Inside>
double worst_circumference(const WallShell<3>& shell, Axis axis, Inside inside) {
  double worst = 0;
  for (std::size_t a = 0; a < shell.count(); ++a) {
    const Vec3 x = shell.contact[a], c = shell.cloud.circumference[a];
    EXPECT_NEAR(c.norm(), 1, 1e-12);
    EXPECT_NEAR(c.dot(shell.cloud.normal[a]), 0, 1e-12);
    if (inside(x)) worst = std::max(worst, degrees(c.dot(axis(x).cross(shell.cloud.normal[a]).normalized())));
  }
  return worst;
}

TEST(ShellBending, CircumferenceOfStraightAndTaperedTubes) {
  const auto along = [](const Vec3&) { return Vec3(0, 0, 1); };
  for (const double outlet : {3e-3, 2e-3}) {
    const TubeShape tube{.radius = 3e-3, .length = 18e-3, .outlet_radius = outlet};
    const auto shell = shell_of(lumen_of(generate(tube)), wall(0.45e-3, 0.6e-3));
    EXPECT_LT(worst_circumference(shell, along, [](const Vec3& x) { return x[2] > 3e-3 && x[2] < 15e-3; }), 3)
        << outlet;
    EXPECT_LT(worst_circumference(shell, along, [](const Vec3&) { return true; }), 6) << outlet;
  }
}

TEST(ShellBending, CircumferenceOfABend) {
  const BendShape bend{.radius = 3e-3, .bend_radius = 7e-3, .inlet_length = 6e-3, .outlet_length = 6e-3};
  const auto shell = shell_of(lumen_of(generate(bend)), wall(0.45e-3, 0.6e-3));
  const double R = bend.bend_radius;
  const auto axis = [&](const Vec3& x) {
    if (x[2] < 0) return Vec3(0, 0, 1);
    return x[0] > R ? Vec3(1, 0, 0) : Vec3(x[2], 0, R - x[0]);
  };
  const auto inside = [&](const Vec3& x) { return x[2] > -4e-3 && x[0] < R + 4e-3; };
  EXPECT_LT(worst_circumference(shell, axis, inside), 5);
}

}  // namespace
}  // namespace ostium::sph3d
