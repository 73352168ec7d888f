/// Files good and bad, written here, read back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <random>

#include "core/error.hpp"
#include "shapes.hpp"
#include "sph3d/geometry/read.hpp"
#include "sph3d/geometry/surface_array.hpp"
#include "sph3d/geometry/write_stl.hpp"

namespace ostium::sph3d {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

std::filesystem::path temporary(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::temp_directory_path() /
         (std::string("ostium_") + test->test_suite_name() + "_" + test->name() + "_" + name);
}

std::filesystem::path write(const std::string& name, const std::string& text) {
  const auto file = temporary(name);
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

std::string ascii(const Surface<3>& s, const std::string& solid = "vessel", double scale = 1) {
  std::string text = "solid " + solid + "\n";
  for (const auto& f : s.facets) {
    text += "facet normal 0 0 0\n outer loop\n";
    for (int v : f) {
      const Vec3 x = scale * s.points[v];
      text += fmt::format("  vertex {:.9g} {:.9g} {:.9g}\n", x.x(), x.y(), x.z());
    }
    text += " endloop\nendfacet\n";
  }
  return text + "endsolid " + solid + "\n";
}

std::string vtp(const Surface<3>& s, const std::vector<int>& ids = {}) {
  std::string text = fmt::format(
      "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>\n<Piece "
      "NumberOfPoints=\"{}\" "
      "NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n",
      s.points.size(), s.facets.size());
  const auto array = [&](const char* type, const char* name, const std::string& values,
                         const char* more = "") {
    text += fmt::format("<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\" {}>{}</DataArray>\n", type, name,
                        more, values);
  };
  std::string points, corners, offsets, labels;
  for (const auto& x : s.points) points += fmt::format("{:.17g} {:.17g} {:.17g}\n", x.x(), x.y(), x.z());
  for (std::size_t f = 0; f < s.facets.size(); ++f) {
    corners += fmt::format("{} {} {}\n", s.facets[f][0], s.facets[f][1], s.facets[f][2]);
    offsets += std::to_string(3 * f + 3) + " ";
  }
  for (int id : ids) labels += std::to_string(id) + " ";
  text += "<Points>";
  array("Float64", "Points", points, "NumberOfComponents=\"3\"");
  text += "</Points><Polys>";
  array("Int64", "connectivity", corners), array("Int64", "offsets", offsets);
  text += "</Polys>";
  if (!ids.empty()) text += "<CellData>", array("Int32", "ModelFaceID", labels), text += "</CellData>";
  return text + "</Piece></PolyData></VTKFile>\n";
}

std::string refusal(const SurfaceOptions& options) {
  try {
    read_lumen(options);
  } catch (const UserError& error) {
    return error.what();
  }
  return "accepted";
}

void expect_tube(const Lumen<3>& lumen, double radius, double length, double tolerance = 1e-6) {
  ASSERT_EQ(lumen.openings.size(), 2u);
  const auto exact = shapes::tube_lumen(radius, length);
  EXPECT_NEAR(lumen.volume, exact.volume, tolerance * exact.volume);
  EXPECT_NEAR(lumen.wall_area, exact.wall_area, tolerance * exact.wall_area);
  for (const auto& o : lumen.openings) {
    EXPECT_NEAR(o.area, exact.openings[0].area, tolerance * o.area);
    EXPECT_NEAR(o.normal.z(), o.centre.z() > length / 2 ? 1 : -1, 1e-9);
    EXPECT_EQ(o.outline.size(), 64u);
  }
}

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

Surface<3> open_tube() {
  auto tube = shapes::tube(0.01, 0.1);
  std::vector<std::array<int, 3>> kept;
  for (std::size_t f = 0; f < tube.facets.size(); ++f)
    if (tube.label[f] != 1) kept.push_back(tube.facets[f]);
  tube.facets = kept;
  return tube;
}

TEST(ReadLumen, OpenEndsAreRefusedWithPlaceAndSize) {
  const auto text = refusal({.file = write("open.stl", ascii(open_tube()))});
  EXPECT_THAT(
      text, AllOf(HasSubstr("open.stl: the surface is open: 1 open end (at (0, 0, 100) mm, 20 mm across, 64 "
                            "edges)"),
                  HasSubstr("cap_open_ends: true")));
}

TEST(ReadLumen, OpenEndsAreCappedOnRequest) {
  const auto lumen = read_lumen({.file = write("open.stl", ascii(open_tube())), .cap_open_ends = true});
  expect_tube(lumen, 0.01, 0.1);
  EXPECT_THAT(lumen.repairs, Contains(HasSubstr("20 mm across, was capped")));
}

TEST(ReadLumen, SmallHolesBecomeWallWhenEndsAreCapped) {
  auto tube = open_tube();
  tube.facets.erase(tube.facets.begin() + 500);
  const auto lumen = read_lumen({.file = write("open.stl", ascii(tube)), .cap_open_ends = true});
  expect_tube(lumen, 0.01, 0.1);
  EXPECT_THAT(lumen.repairs, Contains(HasSubstr("1 small holes were closed with wall")));
}

TEST(ReadLumen, RoundedSeamsAreJoinedWhenEndsAreCapped) {
  const auto tube = shapes::tube(0.01, 0.1);
  auto lower = tube, upper = tube;
  lower.facets.clear(), upper.facets.clear();
  for (const auto& f : tube.facets) {
    const bool low = tube.points[f[0]].z() + tube.points[f[1]].z() + tube.points[f[2]].z() < 0.15 - 1e-9;
    (low ? lower : upper).facets.push_back(f);
  }
  for (auto& x : upper.points) x.x() += 1e-9;
  auto both = ascii(lower) + ascii(upper);
  const auto file = write("seam.stl", both);
  EXPECT_THAT(refusal({.file = file}), HasSubstr("2 open ends"));
  const auto lumen = read_lumen({.file = file, .cap_open_ends = true});
  expect_tube(lumen, 0.01, 0.1);
  EXPECT_THAT(lumen.repairs, Contains(HasSubstr("64 corners of open edges joined")));
}

/// One corner of the wall pulled through the opposite wall.
TEST(ReadLumen, WallsThatCutOneAnotherAreTold) {
  auto tube = shapes::tube(0.01, 0.1);
  EXPECT_THAT(read_lumen({.file = write("t.stl", ascii(tube))}).repairs, testing::IsEmpty());
  tube.points[10 * 64] = Vec3(-0.015, 0, 0.05);
  EXPECT_THAT(read_lumen({.file = write("t.stl", ascii(tube))}).repairs,
              Contains(AllOf(HasSubstr("pairs of triangles cut one another"), HasSubstr("mm; look at"))));
}

TEST(ReadLumen, ClosedWithoutOpeningIsRefused) {
  EXPECT_THAT(refusal({.file = write("sphere.stl", ascii(shapes::sphere(0.01, 4)))}),
              HasSubstr("has no opening"));
}

TEST(ReadLumen, InnerWallsAreRefusedWithTheirPlace) {
  auto tube = shapes::tube(0.01, 0.1);
  const int middle = int(tube.points.size());
  tube.points.emplace_back(0, 0, 0.05);
  for (int i = 0; i < 64; ++i) tube.facets.push_back({10 * 64 + i, 10 * 64 + (i + 1) % 64, middle});
  EXPECT_THAT(refusal({.file = write("wall.stl", ascii(tube))}),
              AllOf(HasSubstr("64 edges are shared by more than two triangles"), HasSubstr("50) mm")));
}

TEST(ReadLumen, TwoVesselsAreRefused) {
  auto two = shapes::tube(0.01, 0.1), other = two;
  const int n = int(two.points.size());
  for (const auto& x : other.points) two.points.push_back(x + Vec3(0.1, 0, 0));
  for (auto [a, b, c] : other.facets) two.facets.push_back({a + n, b + n, c + n});
  EXPECT_THAT(refusal({.file = write("two.stl", ascii(two))}), HasSubstr("2 separate shells"));
}

TEST(ReadLumen, UnreadableFiles) {
  const auto good = ascii(shapes::tube(0.01, 0.1));
  const auto binary = [](std::uint32_t count, std::size_t bytes) {
    std::string text(std::max<std::size_t>(84, bytes), '\0');
    std::memcpy(text.data() + 80, &count, 4);
    return text;
  };
  EXPECT_THAT(refusal({.file = "no/such.stl"}), HasSubstr("no/such.stl: no such file"));
  EXPECT_THAT(refusal({.file = write("a.obj", good)}),
              HasSubstr("read from .stl and .vtp files, not from \".obj\""));
  EXPECT_THAT(refusal({.file = write("empty.stl", "")}), HasSubstr("the file is empty"));
  EXPECT_THAT(refusal({.file = write("none.stl", "solid x\nendsolid x\n")}), HasSubstr("holds no triangle"));
  EXPECT_THAT(refusal({.file = write("cut.stl", good.substr(0, 10000))}), HasSubstr("truncated"));
  EXPECT_THAT(refusal({.file = write("end.stl", good.substr(0, good.size() - 20))}), HasSubstr("truncated"));
  EXPECT_THAT(refusal({.file = write("word.stl", "solid x\nfacet\nvertex 1 2 x3\nendfacet\nendsolid")}),
              HasSubstr("word.stl:3: expected a coordinate, found \"x3\""));
  EXPECT_THAT(refusal({.file = write("nan.stl", "solid x\nfacet\nvertex 1 2 nan\nendfacet\nendsolid")}),
              HasSubstr("not a finite point"));
  EXPECT_THAT(refusal({.file = write("two.stl", "solid x\nfacet\nvertex 1 2 3\nendfacet\nendsolid")}),
              HasSubstr("a facet has three vertices, this one has 1"));
  EXPECT_THAT(refusal({.file = write("short.stl", "garbage")}), HasSubstr("neither an ASCII STL"));
  EXPECT_THAT(
      refusal({.file = write("huge.stl", binary(4000000000u, 500))}),
      HasSubstr("announces 4000000000 triangles, which need 200000000084 bytes, but the file has 500"));
  EXPECT_THAT(refusal({.file = write("zero.stl", binary(0, 84))}), HasSubstr("holds no triangle"));
}

TEST(ReadLumen, UnreadableVtp) {
  const auto good = vtp(shapes::tube(0.01, 0.1));
  const auto edit = [&](const std::string& from, const std::string& to) {
    auto text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_THAT(refusal({.file = write("empty.vtp", "")}), HasSubstr("the file is empty"));
  EXPECT_THAT(refusal({.file = write("garbage.vtp", "no xml at all")}), HasSubstr("not a VTP file"));
  EXPECT_THAT(refusal({.file = write("cut.vtp", good.substr(0, good.size() / 2))}), HasSubstr("damaged"));
  EXPECT_THAT(
      refusal({.file = write("huge.vtp", edit("NumberOfPoints=\"1346\"", "NumberOfPoints=\"99999999999\""))}),
      HasSubstr("announces 99999999999 Points"));
  EXPECT_THAT(refusal({.file = write("index.vtp", edit(">0 1 65", ">0 1 9965"))}),
              HasSubstr("uses the point 9965"));
  EXPECT_THAT(refusal({.file = write("few.vtp", edit("NumberOfPolys=\"2688\"", "NumberOfPolys=\"0\""))}),
              HasSubstr("holds no polygon"));
}

/// Any byte may be wrong: a sentence, never a crash.
TEST(ReadLumen, DamagedBytesNeverCrash) {
  std::mt19937 engine(11);
  const auto tube = shapes::tube(0.01, 0.1, 8, 2);
  const auto stl = temporary("good.stl");
  write_stl(tube, stl);
  std::ifstream in(stl, std::ios::binary);
  const std::string binary((std::istreambuf_iterator<char>(in)), {});
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"d.stl", ascii(tube)}, {"b.stl", binary}, {"d.vtp", vtp(tube)}})
    for (int k = 0; k < 150; ++k) {
      auto damaged = text;
      for (int n = 0; n < 3; ++n) damaged[engine() % damaged.size()] = char(engine() % 256);
      if (k % 3 == 0) damaged.resize(engine() % damaged.size());
      EXPECT_NO_THROW(refusal({.file = write(name, damaged)}));
    }
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
