// Ends that are not plane: capped, labelled and unlabelled, with a rigid wall and with walls that move. Each is refused
// in one sentence: where, by how much, what is allowed, how to mend it.
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "program.hpp"

namespace ostium::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Round tube in mm, length 40 along z, radius 5, of 48 sides; its far rim is a saddle of this height.
struct SaddleTube {
  static constexpr int around = 48, along = 60;
  double height;
  bool with_ends = true;

  struct Facet {
    std::array<int, 3> corner;
    int label;  // 1 wall, 2 near end, 3 far end
  };
  std::vector<std::string> points;
  std::vector<Facet> facets;

  explicit SaddleTube(double saddle, bool ends = true) : height(saddle), with_ends(ends) {
    for (int k = 0; k <= along; ++k)
      for (int i = 0; i < around; ++i) {
        const double a = 2 * std::numbers::pi * i / around, up = static_cast<double>(k) / along;
        points.push_back(fmt::format("{:.9g} {:.9g} {:.9g}", 5 * std::cos(a), 5 * std::sin(a),
                                     (40 + height * std::cos(2 * a)) * up));
      }
    for (int k = 0; k < along; ++k)
      for (int i = 0; i < around; ++i) {
        const int a = k * around + i, b = k * around + (i + 1) % around;
        facets.push_back({{a, b, b + around}, 1}), facets.push_back({{a, b + around, a + around}, 1});
      }
    if (!with_ends) return;
    const int centre = static_cast<int>(points.size()), far = along * around;
    points.insert(points.end(), {"0 0 0", "0 0 40"});
    for (int i = 0; i < around; ++i) {
      const int j = (i + 1) % around;
      facets.push_back({{centre, j, i}, 2}), facets.push_back({{centre + 1, far + i, far + j}, 3});
    }
  }

  std::string stl() const {
    std::string text = "solid tube\n";
    for (const auto& f : facets) {
      text += "facet normal 0 0 0\nouter loop\n";
      for (int v : f.corner) text += "vertex " + points[v] + "\n";
      text += "endloop\nendfacet\n";
    }
    return text + "endsolid tube\n";
  }
  /// With the labels as ModelFaceID.
  std::string vtp() const {
    std::string corners, offsets, labels, places;
    for (const auto& p : points) places += p + "\n";
    for (const auto& f : facets) {
      corners += fmt::format("{} {} {}\n", f.corner[0], f.corner[1], f.corner[2]);
      labels += std::to_string(f.label) + " ";
      offsets += std::to_string(3 * (&f - facets.data() + 1)) + " ";
    }
    const auto array = [](const char* type, const char* name, const std::string& values) {
      return fmt::format(
          "<DataArray type=\"{}\" Name=\"{}\" format=\"ascii\" NumberOfComponents=\"{}\">{}</DataArray>",
          type, name, name == std::string("Points") ? 3 : 1, values);
    };
    return fmt::format(
        "<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>\n<Piece "
        "NumberOfPoints=\"{}\" "
        "NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
        "NumberOfPolys=\"{}\"><CellData>{}</CellData>"
        "<Points>{}</Points><Polys>{}{}</Polys></Piece></PolyData></VTKFile>\n",
        points.size(), facets.size(), array("Int32", "ModelFaceID", labels),
        array("Float64", "Points", places), array("Int64", "connectivity", corners),
        array("Int64", "offsets", offsets));
  }
};

constexpr const char
    *rigid_wall = "{model: rigid}",
    *shell_wall = "{model: shell, thickness: 1 mm, material: {E: 0.75 MPa, nu: 0.49}}",
    *solid_wall = "{model: solid, thickness: 2 mm, spacing: 0.5 mm, material: {E: 0.75 MPa, nu: 0.49}}";
constexpr const char *nearest = "{nearest: [0 mm, 0 mm, 40 mm]}", *second = "{largest: 2}",
                     *label = "{label: 3}";

class UnevenEnds : public ProgramTest {
 protected:
  void write_case(const std::string& surface, const char* wall, const char* out) const {
    write("case.yaml", fmt::format(R"(vessel:
  surface: {}
  length_unit: mm
  spacing: 1 mm
  openings:
    in: {{nearest: [0 mm, 0 mm, 0 mm]}}
    out: {}
  wall: {}
  cap_open_ends: true
network:
  blocks:
    heart: {{type: flow_source, flow: 5 mL/s, to: in}}
    body: {{type: windkessel, from: out, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}}
time: {{end: 1 ms}}
)",
                                   surface, out, wall));
  }
  bool in_order(const std::string& surface, const char* wall, const char* out) const {
    write_case(surface, wall, out);
    return ostium("check case.yaml").code == 0;
  }
  /// The one line with which `run` and `check` refuse the case.
  std::string refused(const std::string& surface, const char* wall, const char* out) const {
    write_case(surface, wall, out);
    const Outcome outcome = ostium("run case.yaml -q -o results");
    EXPECT_EQ(outcome.code, 2) << outcome.text;
    EXPECT_FALSE(exists("results"));
    EXPECT_EQ(ostium("check case.yaml").code, 2);
    return outcome.text.substr(outcome.text.find("error: "));
  }
};

TEST_F(UnevenEnds, OfAMovingWall) {
  write("tube.stl", SaddleTube(0.5, false).stl());
  EXPECT_TRUE(in_order("tube.stl", rigid_wall, nearest));
  EXPECT_EQ(refused("tube.stl", shell_wall, nearest).substr(0, 69),
            "error: case.yaml:8:3: vessel.wall: the end of the wall at the opening");
  for (const auto& [wall, allowed] : {std::pair(shell_wall, "0.25 mm"), {solid_wall, "0.125 mm"}})
    EXPECT_THAT(refused("tube.stl", wall, nearest),
                AllOf(HasSubstr("at the opening 'out' is not plane: at ("),
                      HasSubstr("its rim lies 0.5 mm beside the plane, 5 % of the opening's width"),
                      HasSubstr(fmt::format("a quarter of the wall's spacing, {}, is allowed", allowed)),
                      HasSubstr("Cut the vessel there by a plane")));
}

TEST_F(UnevenEnds, Capped) {
  write("tube.stl", SaddleTube(3, false).stl());
  for (const char* wall : {rigid_wall, shell_wall, solid_wall})
    EXPECT_EQ(refused("tube.stl", wall, nearest),
              "error: case.yaml:2:3: vessel.surface: tube.stl: the open end at (0, 0, 40) mm, 9.99 mm "
              "across, is not "
              "plane: its rim leaves its mean plane by 3 mm, 30 % of its width; a flat cap allows 2.5 mm; "
              "cut the vessel "
              "by a plane there\n");
}

TEST_F(UnevenEnds, Labelled) {
  write("plane.vtp", SaddleTube(0.1).vtp());
  for (const char* wall : {rigid_wall, shell_wall}) EXPECT_TRUE(in_order("plane.vtp", wall, label));
  for (const auto& [height, percent] : {std::pair(1.0, 10), {3.0, 30}}) {
    write("tube.vtp", SaddleTube(height).vtp());
    for (const char* wall : {rigid_wall, shell_wall})
      for (const char* choice : {nearest, label, second})
        EXPECT_EQ(
            refused("tube.vtp", wall, choice),
            fmt::format(
                "error: case.yaml:7:5: vessel.openings.out: opening 'out': the face 3 of tube.vtp at (0, 0, "
                "40) mm, 9.99 mm across, is not plane: it leaves its mean plane by {} mm, {} % of its width; "
                "0.442 mm is allowed; cut the vessel by a plane there and close it with a flat face\n",
                height, percent));
  }
}

TEST_F(UnevenEnds, InAPreview) {
  write("tube.vtp", SaddleTube(1).vtp());
  write_case("tube.vtp", rigid_wall, label);
  const Outcome outcome = ostium("preview case.yaml -o picture.png");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.text,
              HasSubstr("the face 3 of tube.vtp at (0, 0, 40) mm, 9.99 mm across, is not plane"));
  EXPECT_FALSE(exists("picture.png"));
}

TEST_F(UnevenEnds, ClosedWithoutLabels) {
  write("tube.stl", SaddleTube(0.3).stl());
  for (const char* wall : {rigid_wall, shell_wall})
    for (const char* choice : {nearest, second})
      EXPECT_EQ(refused("tube.stl", wall, choice),
                "error: case.yaml:7:5: vessel.openings.out: opening 'out': the end of tube.stl at (0, 0, 40) "
                "mm, 9.99 mm "
                "across, is not plane: it leaves its mean plane by 0.3 mm, 3 % of its width; 0.00885 mm is "
                "allowed for a "
                "face without label; cut the vessel by a plane there and close it with a flat face\n");
}

}  // namespace
}  // namespace ostium::test
