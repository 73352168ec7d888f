// Walls that move, as a case describes them: what is refused, with which sentence.
#include <fmt/format.h>

#include "program.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;

std::string tube_with(const std::string& wall, const std::string& spacing = "1 mm") {
  return fmt::format(R"(vessel:
  surface: tube.stl
  length_unit: mm
  spacing: {}
  openings:
    in: {{nearest: [0 mm, 0 mm, 0 mm]}}
    out: {{nearest: [0 mm, 0 mm, 40 mm]}}
  wall: {}
network:
  blocks:
    heart: {{type: flow_source, flow: 5 mL/s, to: in}}
    body: {{type: windkessel, from: out, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}}
time: {{end: 1 ms}}
)",
                     spacing, wall);
}

class MovingWall : public ProgramTest {
 protected:
  MovingWall() { EXPECT_EQ(ostium("geometry tube --radius '5 mm' --length '40 mm' -o tube.stl").code, 0); }
  /// What the terminal shows of a case that is refused, by `check` and by `run`, which leaves nothing behind.
  std::string refused(const std::string& wall, const std::string& spacing = "1 mm") const {
    write("case.yaml", tube_with(wall, spacing));
    const Outcome outcome = ostium("run case.yaml -o results");
    EXPECT_EQ(outcome.code, 2) << outcome.text;
    EXPECT_FALSE(exists("results"));
    EXPECT_EQ(ostium("check case.yaml").code, 2);
    return outcome.text;
  }
};

constexpr const char* material = "material: {E: 0.75 MPa, nu: 0.49}";

TEST_F(MovingWall, TheGoodCaseIsInOrder) {
  write("case.yaml", tube_with(fmt::format("{{model: shell, thickness: 1 mm, {}}}", material)));
  const Outcome outcome = ostium("check case.yaml");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("a shell of 1"));
}

TEST_F(MovingWall, TooThickForItsCurvature) {
  EXPECT_THAT(refused(fmt::format("{{model: shell, thickness: 4 mm, {}}}", material)),
              testing::AllOf(HasSubstr("case.yaml:8:3: vessel.wall: "), HasSubstr("thick"),
                             HasSubstr("radius"), HasSubstr("at (")));
}

TEST_F(MovingWall, PoissonsRatioOfOneHalf) {
  EXPECT_THAT(refused("{model: shell, thickness: 1 mm, material: {E: 1 MPa, nu: 0.5}}"),
              testing::AllOf(HasSubstr("case.yaml:8:62: vessel.wall.material.nu: "), HasSubstr("0.5")));
}

TEST_F(MovingWall, NegativeModulus) {
  EXPECT_THAT(refused("{model: shell, thickness: 1 mm, material: {E: -1 MPa, nu: 0.4}}"),
              testing::AllOf(HasSubstr("vessel.wall.material.E: "), HasSubstr("> 0 Pa")));
}

TEST_F(MovingWall, CoarserThanTheBlood) {
  EXPECT_THAT(refused(fmt::format("{{model: shell, thickness: 1 mm, spacing: 1.5 mm, {}}}", material)),
              testing::AllOf(HasSubstr("vessel.wall: "), HasSubstr("coarser than the fluid's")));
}

TEST_F(MovingWall, TooLightForTheExchange) {
  EXPECT_THAT(
      refused(fmt::format("{{model: shell, thickness: 0.2 mm, {}}}", material)),
      testing::AllOf(HasSubstr("vessel.wall: the wall, 0.2 mm thick, is too light for blood of this spacing"),
                     HasSubstr("numerics.acoustic_cfl to 0.")));
}

TEST_F(MovingWall, WhatAShellNeeds) {
  EXPECT_THAT(refused("{model: shell, thickness: 1 mm}"), HasSubstr("a shell needs its \"material\""));
  EXPECT_THAT(refused(fmt::format("{{model: shell, {}}}", material)),
              HasSubstr("a shell needs either \"thickness\" or \"varying_thickness\""));
  EXPECT_THAT(refused(fmt::format("{{model: shell, thickness: 1 mm, gauss_points: 4, {}}}", material)),
              HasSubstr("1, 2, 3 or 5 are possible"));
  EXPECT_THAT(refused("{model: shell, thickness: 1 mm, material: {law: holzapfel, E: 0.1 MPa, nu: 0.49}}"),
              HasSubstr("needs \"k1\" and \"k2\" of its fibres"));
  EXPECT_THAT(refused(fmt::format("{{model: shell, varying_thickness: {{opening: inn, at_opening: 1 mm, "
                                  "away: 2 mm, length: 1 cm}}, {}}}",
                                  material)),
              testing::AllOf(HasSubstr("vessel.wall"), HasSubstr("did you mean \"in\"")));
}

TEST_F(MovingWall, TheGoodSolidIsInOrder) {
  write("case.yaml",
        tube_with(fmt::format("{{model: solid, thickness: 2 mm, spacing: 0.5 mm, {}}}", material)));
  const Outcome outcome = ostium("check case.yaml");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("a solid of "));
}

TEST_F(MovingWall, WhatASolidNeeds) {
  EXPECT_THAT(refused("{model: solid, thickness: 2 mm}"), HasSubstr("a solid wall needs its \"material\""));
  EXPECT_THAT(refused(fmt::format("{{model: solid, {}}}", material)),
              HasSubstr("a solid wall needs its \"thickness\""));
  EXPECT_THAT(refused(fmt::format("{{model: solid, thickness: 2 mm, spacing: 1 mm, {}}}", material)),
              testing::AllOf(HasSubstr("vessel.wall: "), HasSubstr("four layers of particles or more")));
  EXPECT_THAT(refused(fmt::format("{{model: solid, thickness: 8 mm, spacing: 1.5 mm, {}}}", material)),
              HasSubstr("coarser than the fluid's"));
}

TEST_F(MovingWall, WhatASolidHasNot) {
  EXPECT_THAT(refused(fmt::format("{{model: solid, thickness: 2 mm, prestress: {{pressure: 80 mmHg}}, {}}}",
                                  material)),
              HasSubstr("a solid wall has no \"prestress\"; remove the key, or write \"model: shell\""));
  EXPECT_THAT(
      refused(fmt::format("{{model: solid, thickness: 2 mm, support: {{spring: 1e7 Pa/m}}, {}}}", material)),
      HasSubstr("a solid wall has no \"support\""));
  EXPECT_THAT(refused(fmt::format("{{model: solid, thickness: 2 mm, ends: released, {}}}", material)),
              HasSubstr("the ends of a solid wall are clamped"));
  EXPECT_THAT(
      refused("{model: solid, thickness: 2 mm, material: {law: holzapfel, E: 0.1 MPa, nu: 0.49, k1: 50 "
              "kPa, k2: 10}}"),
      HasSubstr("a solid wall has no fibres"));
}

TEST_F(MovingWall, ARigidWallHasNoThickness) {
  EXPECT_THAT(refused("{thickness: 1 mm}"),
              HasSubstr("a rigid wall has no \"thickness\"; write \"model: shell\""));
}

TEST_F(MovingWall, ArraysAreInVtpFilesOnly) {
  EXPECT_THAT(refused(fmt::format("{{model: shell, varying_thickness: {{array: thickness}}, {}}}", material)),
              testing::AllOf(HasSubstr("vessel.wall.varying_thickness"),
                             HasSubstr("only VTP files have point arrays")));
}

}  // namespace
}  // namespace ostium::test
