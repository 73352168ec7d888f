#include <cmath>
#include <numbers>

#include "program.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;

class Geometry : public ProgramTest {
 protected:
  /// The number behind `word` in a text.
  static double number_after(const std::string& text, const std::string& word) {
    const auto at = text.find(word);
    return at == std::string::npos ? -1 : std::stod(text.substr(at + word.size()));
  }
};

TEST_F(Geometry, TubeHasTheVolumeOfACylinder) {
  const Outcome outcome = ostium("geometry tube --radius '5 mm' --length '4 cm' -o t.stl");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_NEAR(number_after(outcome.text, "lumen "), std::numbers::pi * 0.25 * 4, 0.01);  // mL
  EXPECT_THAT(outcome.text, HasSubstr("written to t.stl, length_unit: mm"));
  EXPECT_TRUE(exists("t.stl"));
}

TEST_F(Geometry, EveryShapeIsAVessel) {
  for (const auto& [shape, openings] :
       {std::pair{"tube", 2}, {"bend", 2}, {"bifurcation", 3}, {"arch --edge '1.5 mm'", 7}}) {
    const Outcome outcome = ostium(std::string("geometry ") + shape + " -o x.stl --length-unit cm");
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr("opening" + std::to_string(openings)));
    EXPECT_THAT(outcome.text, testing::Not(HasSubstr("opening" + std::to_string(openings + 1))));
  }
}

TEST_F(Geometry, BadParameters) {
  EXPECT_EQ(ostium("geometry tube --radius '-3 mm'").text,
            "error: radius: -3 mm (-0.003 m) is not allowed; it must be > 0 m\n");
  EXPECT_THAT(ostium("geometry tube --radius 3").text,
              HasSubstr("radius: expected a value with a unit of dimension m"));
  EXPECT_THAT(ostium("geometry arch --branch-radii '4 s'").text, HasSubstr("branch_radii: "));
  EXPECT_THAT(ostium("geometry tube --length-unit kg").text,
              HasSubstr("the unit \"kg\" has the wrong dimension"));
  EXPECT_EQ(ostium("geometry tube --radius 3").code, 2);
  EXPECT_EQ(ostium("geometry ball").code, 2);
  EXPECT_EQ(ostium("geometry tube -o /dev/null/x.stl").code, 2);
  EXPECT_FALSE(exists("tube.stl"));
}

const char* tube_case = R"(title: Tube
vessel:
  surface: tube.stl
  length_unit: mm
  spacing: 1 mm
  openings: {in: {nearest: 0 0 0 mm}, out: {nearest: 0 0 40 mm}}
network:
  blocks:
    heart: {type: flow_source, flow: 5 mL/s, to: in}
    body: {type: windkessel, from: out, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}
time: {end: 0.1 s}
)";

TEST_F(Geometry, CheckListsTheOpenings) {
  ASSERT_EQ(ostium("geometry tube --radius '5 mm' --length '40 mm'").code, 0);
  write("case.yaml", tube_case);
  const Outcome outcome = ostium("check case.yaml --threads 2");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, testing::ContainsRegex("in +flow prescribed by the network, parabolic profile"));
  EXPECT_THAT(outcome.text, testing::ContainsRegex("out +pressure of the network"));
  EXPECT_NEAR(number_after(outcome.text, "particles about "), std::numbers::pi * 1000, 20);
  EXPECT_THAT(outcome.text, HasSubstr("on 2 cores"));
}

TEST_F(Geometry, SurfaceFromTheCommandLine) {
  ASSERT_EQ(ostium("geometry tube --radius '5 mm' --length '40 mm' -o other.stl").code, 0);
  write("case.yaml", tube_case);
  EXPECT_EQ(ostium("check case.yaml").code, 2);
  EXPECT_EQ(ostium("check case.yaml --surface other.stl").code, 0);
}

TEST_F(Geometry, Outline2D) {
  write("case.yaml", R"(
vessel:
  dimension: 2
  outline: [[0 mm, 0 mm], [40 mm, 0 mm], [40 mm, 10 mm], [0 mm, 10 mm]]
  spacing: 1 mm
  openings: {in: {edge: 3}, out: {nearest: 40 5 mm}}
network:
  blocks:
    heart: {type: flow_source, flow: 5 mL/s, to: in}
    body: {type: windkessel, from: out, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}
time: {end: 0.1 s}
)");
  const Outcome outcome = ostium("check case.yaml");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("particles about 400 at 1 mm"));
  write("corners.csv", "x,y\n0,0\n40,0\n40,10\n0,10\n");
  const Outcome file = ostium("check case.yaml --set vessel.outline=corners.csv --set vessel.length_unit=mm");
  EXPECT_EQ(file.text, outcome.text);
  EXPECT_THAT(ostium("check case.yaml --set vessel.outline=corners.csv").text,
              HasSubstr("a file of corners needs \"length_unit\""));
  EXPECT_THAT(ostium("check case.yaml --set vessel.openings.in='{largest: 1}'").text,
              HasSubstr("is chosen by \"edge\" or \"nearest\""));
}

TEST_F(Geometry, Preview) {
  ASSERT_EQ(ostium("geometry tube --radius '5 mm' --length '40 mm'").code, 0);
  write("case.yaml", tube_case);
  const Outcome outcome = ostium("preview case.yaml -o picture.png");
  if (outcome.code == 2 && outcome.text.find("Xvfb") != std::string::npos)
    GTEST_SKIP() << "no display: " << outcome.text;
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_EQ(content("picture.png").substr(1, 3), "PNG");
}

}  // namespace
}  // namespace ostium::test
