/// Surface files written for a test, and what comes of reading them.
#pragma once
#include <gtest/gtest.h>

#include <fstream>

#include "core/error.hpp"
#include "shapes.hpp"
#include "sph3d/geometry/read.hpp"

namespace ostium::sph3d {

inline std::filesystem::path temporary(const std::string& name) {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  return std::filesystem::temp_directory_path() /
         (std::string("ostium_") + test->test_suite_name() + "_" + test->name() + "_" + name);
}

inline std::filesystem::path write(const std::string& name, const std::string& text) {
  const auto file = temporary(name);
  std::ofstream(file, std::ios::binary) << text;
  return file;
}

inline std::string ascii(const Surface<3>& s, const std::string& solid = "vessel", double scale = 1) {
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

inline std::string vtp(const Surface<3>& s, const std::vector<int>& ids = {}) {
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

inline std::string refusal(const SurfaceOptions& options) {
  try {
    read_lumen(options);
  } catch (const UserError& error) {
    return error.what();
  }
  return "accepted";
}

inline void expect_tube(const Lumen<3>& lumen, double radius, double length, double tolerance = 1e-6) {
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

}  // namespace ostium::sph3d
