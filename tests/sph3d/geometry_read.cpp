// Files good, written here, read back: formats, poses, what is mended.
#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "sph3d/geometry/surface_array.hpp"
#include "sph3d/geometry/write_stl.hpp"
#include "surface_files.hpp"

namespace ostium::sph3d {
namespace {

using testing::Contains;
using testing::HasSubstr;

TEST(ReadLumen, AsciiStlInAnyUnit) {
  const auto tube = shapes::tube(0.01, 0.1);
  expect_tube(read_lumen({.file = write("m.stl", ascii(tube)), .length_unit = 1}), 0.01, 0.1);
  expect_tube(read_lumen({.file = write("mm.stl", ascii(tube, "x", 1e3)), .length_unit = 1e-3}), 0.01, 0.1);
}

TEST(ReadLumen, BinaryStlAlsoWhenItBeginsWithSolid) {
  const auto file = temporary("tube.stl");
  write_stl(shapes::tube(0.01, 0.1), file);
  expect_tube(read_lumen({.file = file, .length_unit = 1e-3}), 0.01, 0.1);
  std::fstream(file, std::ios::in | std::ios::out | std::ios::binary)
      << "solid binary with facet in its header";
  expect_tube(read_lumen({.file = file, .length_unit = 1e-3}), 0.01, 0.1);
}

TEST(ReadLumen, VtpWithAndWithoutLabels) {
  const auto tube = shapes::tube(0.01, 0.1);
  const auto plain = read_lumen({.file = write("plain.vtp", vtp(tube))});
  expect_tube(plain, 0.01, 0.1, 1e-12);
  EXPECT_EQ(plain.openings[0].face_id, -1);
  std::vector<int> ids;
  for (int l : tube.label) ids.push_back(l + 5);
  const auto labelled = read_lumen({.file = write("ids.vtp", vtp(tube, ids))});
  expect_tube(labelled, 0.01, 0.1, 1e-12);
  EXPECT_EQ(labelled.openings[0].face_id + labelled.openings[1].face_id, 11);
}

/// Corners as a program writes them that computes them anew for every triangle, in an order given by the seed.
std::string with_rounding(const Surface<3>& s, double noise, unsigned order) {
  std::mt19937 engine(1), shuffle(order);
  std::uniform_real_distribution<double> uniform(-noise, noise);
  std::vector<std::string> facets;
  for (const auto& f : s.facets) {
    std::string facet = "facet normal 0 0 0\n outer loop\n";
    for (int v : f) {
      const Vec3 x = s.points[v] + Vec3(uniform(engine), uniform(engine), uniform(engine));
      facet += fmt::format("  vertex {} {} {}\n", x.x(), x.y(), x.z());
    }
    facets.push_back(facet + " endloop\nendfacet\n");
  }
  if (order > 0) std::shuffle(facets.begin(), facets.end(), shuffle);
  std::string text = "solid vessel\n";
  for (const auto& facet : facets) text += facet;
  return text + "endsolid vessel\n";
}

std::vector<std::array<double, 3>> sorted_points(const Lumen<3>& lumen) {
  std::vector<std::array<double, 3>> points;
  for (const auto& x : lumen.surface.points) points.push_back({x.x(), x.y(), x.z()});
  std::sort(points.begin(), points.end());
  return points;
}

TEST(ReadLumen, CornersThatDifferByRoundingAreJoinedWhenEndsAreCapped) {
  const auto tube = shapes::tube(0.01, 0.1);
  for (const double relative : {1e-15, 1e-12, 1e-9}) {
    const auto file = write("t.stl", with_rounding(tube, 0.1 * relative, 0));
    EXPECT_THAT(refusal({.file = file}), HasSubstr("cap_open_ends"));
    const auto lumen = read_lumen({.file = file, .cap_open_ends = true});
    expect_tube(lumen, 0.01, 0.1);
    EXPECT_EQ(lumen.surface.points.size(), tube.points.size());
    EXPECT_THAT(lumen.repairs, Contains(HasSubstr("joined to a neighbour")));
    const auto other = write("s.stl", with_rounding(tube, 0.1 * relative, 7));
    const auto shuffled = read_lumen({.file = other, .cap_open_ends = true});
    EXPECT_EQ(sorted_points(shuffled), sorted_points(lumen));  // whatever the order of the triangles
    EXPECT_EQ(shuffled.surface.facets.size(), lumen.surface.facets.size());
  }
}

/// Rotated, scaled, moved, normals inward, a third of the triangles turned: the same vessel.
TEST(ReadLumen, PoseAndOrientationDoNotMatter) {
  auto tube = shapes::tube(0.01, 0.1);
  const Eigen::AngleAxisd turn(1.1, Vec3(1, 2, 3).normalized());
  for (auto& x : tube.points) x = 100 * (turn * x) + Vec3(300, -200, 50);
  std::mt19937 engine(5);
  for (auto& f : tube.facets) {
    std::swap(f[0], f[1]);
    if (engine() % 3 == 0) std::swap(f[0], f[1]);
  }
  const auto lumen = read_lumen({.file = write("t.stl", ascii(tube)), .length_unit = 0.01});
  const auto exact = shapes::tube_lumen(0.01, 0.1);
  ASSERT_EQ(lumen.openings.size(), 2u);
  EXPECT_NEAR(lumen.volume, exact.volume, 1e-6 * exact.volume);
  EXPECT_NEAR(std::abs(lumen.openings[0].normal.dot(turn * Vec3::UnitZ())), 1, 1e-6);
  EXPECT_GT((lumen.openings[0].centre - lumen.openings[1].centre).dot(lumen.openings[0].normal), 0);
  EXPECT_THAT(lumen.repairs, Contains(HasSubstr("ran against their neighbours")));
}

TEST(ReadLumen, DegenerateDoubledAndLeftoverTrianglesAreDropped) {
  auto tube = shapes::tube(0.01, 0.1);
  tube.facets.push_back({5, 5, 9});
  tube.facets.push_back(tube.facets[3]);
  const int n = int(tube.points.size());
  for (auto x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    tube.points.push_back(1e-4 * x + Vec3(0.05, 0, 0));
  for (auto f : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}})
    tube.facets.push_back({n + f[0], n + f[1], n + f[2]});
  const auto lumen = read_lumen({.file = write("t.stl", ascii(tube))});
  expect_tube(lumen, 0.01, 0.1);
  EXPECT_THAT(lumen.repairs, Contains(HasSubstr("1 degenerate triangles dropped")));
  EXPECT_THAT(lumen.repairs, Contains(HasSubstr("1 doubled triangles dropped")));
  EXPECT_THAT(lumen.repairs, Contains(HasSubstr("1 leftover shells")));
}

/// One corner of the wall pulled through the opposite wall.
TEST(ReadLumen, WallsThatCutOneAnotherAreTold) {
  auto tube = shapes::tube(0.01, 0.1);
  EXPECT_THAT(read_lumen({.file = write("t.stl", ascii(tube))}).repairs, testing::IsEmpty());
  tube.points[10 * 64] = Vec3(-0.015, 0, 0.05);
  EXPECT_THAT(read_lumen({.file = write("t.stl", ascii(tube))}).repairs,
              Contains(AllOf(HasSubstr("pairs of triangles cut one another"), HasSubstr("mm; look at"))));
}

/// A file in mm whose points carry ten times their x; the surface has them in m, in another order, and one more.
TEST(SurfaceArray, ValuesAreFoundByPlace) {
  Surface<3> in_file;
  in_file.points = {{1, 0, 0}, {2, 0, 0}, {3, 1, 0}, {4, 0, 2}};
  in_file.facets = {{0, 1, 2}, {1, 2, 3}};
  std::string text = vtp(in_file);
  const std::string values =
      "<PointData><DataArray type=\"Float64\" Name=\"thickness\" format=\"ascii\">10 20 30 40</DataArray>"
      "<DataArray type=\"Float64\" Name=\"pull\" NumberOfComponents=\"2\" format=\"ascii\">1 2 3 4 5 6 7 "
      "8</DataArray>"
      "</PointData>";
  text.insert(text.find("<Points>"), values);
  const auto file = write("arrays.vtp", text);
  Surface<3> surface;
  surface.points = {{0.004, 0, 0.002}, {0.001, 0, 0}, {0.003, 0.001, 0}, {0.002, 0, 0}, {0.0021, 0, 0}};
  EXPECT_EQ(surface_array(file, "thickness", 1e-3, surface), (std::vector<double>{40, 10, 30, 20, 20}));
  const auto refusal = [&](const std::filesystem::path& from, const char* name) {
    try {
      surface_array(from, name, 1e-3, surface);
    } catch (const UserError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_THAT(refusal(file, "thicknes"),
              HasSubstr("has no point array \"thicknes\"; did you mean \"thickness\"?"));
  EXPECT_THAT(refusal(file, "pull"), HasSubstr("has 2 components, one is wanted"));
  EXPECT_THAT(refusal("wall.stl", "thickness"), HasSubstr("only VTP files have point arrays"));
}

}  // namespace
}  // namespace ostium::sph3d
