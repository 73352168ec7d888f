// Twelve kinds of bad input: each is refused with exit code 2 and its sentence, and leaves no results behind.
#include <fmt/format.h>

#include "program.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;
using testing::MatchesRegex;

const std::string network = R"(network:
  blocks:
    heart: {type: flow_source, flow: 5 mL/s, to: in}
    body: {type: windkessel, from: in, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}
time: {end: 0.1 s}
)";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), with);
}

/// Round tube of 24 sides in mm: length 40 along z, radius 5.
std::string tube_stl(bool with_ends) {
  constexpr int n = 24;
  std::string stl = "solid tube\n";
  const auto rim = [](int i, double z) {
    const double a = 2 * 3.14159265358979 * (i % n) / n;
    return fmt::format("vertex {} {} {}\n", 5 * std::cos(a), 5 * std::sin(a), z);
  };
  const auto facet = [&](const std::string& corners) {
    stl += "facet normal 0 0 0\nouter loop\n" + corners + "endloop\nendfacet\n";
  };
  for (int i = 0; i < n; ++i) {
    facet(rim(i, 0) + rim(i + 1, 0) + rim(i + 1, 40));
    facet(rim(i, 0) + rim(i + 1, 40) + rim(i, 40));
    if (!with_ends) continue;
    facet("vertex 0 0 0\n" + rim(i + 1, 0) + rim(i, 0));
    facet("vertex 0 0 40\n" + rim(i, 40) + rim(i + 1, 40));
  }
  return stl + "endsolid tube\n";
}

const std::string vessel = R"(vessel:
  surface: tube.stl
  length_unit: mm
  spacing: 1 mm
  openings:
    in: {nearest: [0 mm, 0 mm, 0 mm]}
    out: {nearest: [0 mm, 0 mm, 40 mm]}
network:
  blocks:
    heart: {type: flow_source, flow: 5 mL/s, to: in}
    body: {type: windkessel, from: out, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}
time: {end: 0.1 s}
)";

using BadInput = ProgramTest;

TEST_F(BadInput, TheGoodCasesPass) {
  write("case.yaml", network);
  EXPECT_EQ(ostium("run case.yaml -o results").code, 0);
  write("tube.stl", tube_stl(true));
  write("vessel.yaml", vessel);
  const Outcome outcome = ostium("check vessel.yaml");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("in order"));
}

TEST_F(BadInput, UnknownKey) {
  EXPECT_THAT(refused(replaced(network, "C: ", "Cc: ")),
              HasSubstr("case.yaml:4:59: network.blocks.body.Cc: unknown key \"Cc\"; did you mean \"C\"?"));
}

TEST_F(BadInput, MissingUnit) {
  EXPECT_THAT(
      refused(replaced(network, "9.8e6 Pa.s/m3", "9.8e6")),
      HasSubstr(
          "case.yaml:4:40: network.blocks.body.Rp: expected a value with a unit of dimension Pa.s/m3, found "
          "the bare number 9.8e6; write for example \"9.8e6 Pa.s/m3\""));
}

TEST_F(BadInput, WrongDimension) {
  EXPECT_THAT(
      refused(replaced(network, "9.8e6 Pa.s/m3", "9.8e6 mmHg")),
      HasSubstr(
          "case.yaml:4:40: network.blocks.body.Rp: the unit \"mmHg\" has the wrong dimension; expected a "
          "unit that converts to Pa.s/m3"));
}

TEST_F(BadInput, NegativeResistance) {
  EXPECT_THAT(
      refused(replaced(network, "9.8e6", "-9.8e6")),
      HasSubstr(
          "case.yaml:4:40: network.blocks.body.Rp: -9.8e6 Pa.s/m3 is not allowed; it must be >= 0 Pa.s/m3"));
}

TEST_F(BadInput, OpeningThatDoesNotExist) {
  write("tube.stl", tube_stl(true));
  const std::string text =
      refused(replaced(vessel, "out: {nearest: [0 mm, 0 mm, 40 mm]}", "out: {largest: 3}"));
  EXPECT_THAT(text, HasSubstr("case.yaml:7:5: vessel.openings.out: "));
  EXPECT_THAT(text, HasSubstr("2 openings"));
}

TEST_F(BadInput, BlockAtAnOpeningThatDoesNotExist) {
  write("tube.stl", tube_stl(true));
  const std::string text = refused(replaced(vessel, "from: out,", "from: outt,"));
  EXPECT_THAT(text, HasSubstr("\"out\""));
  EXPECT_THAT(text, HasSubstr("case.yaml:"));
}

TEST_F(BadInput, WaveformTimesNotIncreasing) {
  write("inflow.csv", "t [s], Q [mL/s]\n0, 1\n0.2, 2\n0.1, 3\n");
  EXPECT_THAT(
      refused(replaced(network, "5 mL/s", "{file: inflow.csv, period: 1 s}")),
      HasSubstr(
          "network.blocks.heart.flow.file: inflow.csv:4: the time 0.1 s does not come after 0.2 s of the row "
          "before; times must increase"));
}

TEST_F(BadInput, NanInAWaveform) {
  write("inflow.csv", "t [s], Q [mL/s]\n0, 1\n0.2, nan\n0.3, 3\n");
  EXPECT_THAT(
      refused(replaced(network, "5 mL/s", "{file: inflow.csv, period: 1 s}")),
      HasSubstr("network.blocks.heart.flow.file: inflow.csv:3: the value nan is not a finite number"));
}

TEST_F(BadInput, SpacingTooCoarse) {
  write("tube.stl", tube_stl(true));
  EXPECT_THAT(
      refused(replaced(vessel, "spacing: 1 mm", "spacing: 4 mm")),
      HasSubstr(
          "case.yaml:4:3: vessel.spacing: the spacing of 4 mm is too coarse for the narrowest opening"));
  EXPECT_THAT(refused(replaced(vessel, "spacing: 1 mm", "spacing: 4 mm")),
              HasSubstr("2.5 particles fit across, at least 4 are needed; choose 2.4 mm or less"));
}

TEST_F(BadInput, SurfaceFileMissing) {
  const std::string text = refused(vessel);
  EXPECT_THAT(text, HasSubstr("case.yaml:2:3: vessel.surface: "));
  EXPECT_THAT(text, HasSubstr("tube.stl"));
  EXPECT_THAT(text, HasSubstr("no such file"));
}

TEST_F(BadInput, SurfaceOpen) {
  write("tube.stl", tube_stl(false));
  const std::string text = refused(vessel);
  EXPECT_THAT(text, HasSubstr("case.yaml:2:3: vessel.surface: "));
  EXPECT_THAT(text, HasSubstr("2 open ends"));
  EXPECT_THAT(text, HasSubstr("cap_open_ends"));
}

TEST_F(BadInput, SoundSlowerThanTheBlood) {
  EXPECT_THAT(
      refused("vessel:\n  dimension: 2\n  outline: [[0 mm, 0 mm], [4 mm, 0 mm], [4 mm, 1 mm], [0 mm, 1 mm]]\n"
              "  spacing: 0.1 mm\n  openings: {in: {edge: 3, profile: plug}, out: {edge: 1}}\n"
              "fluid: {sound_speed: 1 m/s}\n"
              "network:\n  blocks:\n    pump: {type: flow_source, to: in, flow: 1e-3 m3/s}\n"
              "    sink: {type: pressure_source, to: out, pressure: 0 Pa}\ntime: {end: 0.1 s}\n"),
      HasSubstr("case.yaml:6:9: fluid.sound_speed: the sound speed of 1 m/s is too low for blood that may "
                "reach 1.2 "
                "m/s here; choose 12 m/s or more, or leave it out"));
}

TEST_F(BadInput, EmptyYaml) {
  EXPECT_THAT(
      refused(""),
      HasSubstr("case.yaml:1:1: this file is empty; expected a mapping with the keys title, vessel,"));
}

TEST_F(BadInput, TwoBlocksOfOneName) {
  EXPECT_THAT(
      refused(replaced(network, "body:", "heart:")),
      HasSubstr(
          "case.yaml:4:5: network.blocks.heart: the name \"heart\" is given twice, first at case.yaml:3:5; "
          "rename or delete one of them"));
}

TEST_F(BadInput, CaseFileMissing) {
  EXPECT_THAT(ostium("run nothing.yaml").text,
              HasSubstr("nothing.yaml: there is no such file; look at its name and its folder"));
  EXPECT_EQ(ostium("run nothing.yaml").code, 2);
}

TEST_F(BadInput, TimesThatDoNotFit) {
  EXPECT_THAT(refused(replaced(network, "{end: 0.1 s}", "{}")),
              HasSubstr("case.yaml:5:1: time: the length of the run is missing"));
  EXPECT_THAT(refused(replaced(network, "time: {end: 0.1 s}", "")),
              HasSubstr("case.yaml:1:1: the key \"time\" is missing: how long to run"));
  EXPECT_THAT(refused(replaced(network, "{end: 0.1 s}", "{end: 1 s, cycles: 2}")),
              HasSubstr("either \"end\" or \"cycles\""));
  EXPECT_THAT(refused(replaced(network, "network:\n", "network:\n  initial: periodic\n")),
              HasSubstr("a start from the periodic state needs \"time.period\""));
}

TEST_F(BadInput, RowsWithoutEnd) {
  EXPECT_THAT(
      refused(network + "output: {every: 1e-12 s}\n"),
      HasSubstr(
          "case.yaml:6:10: output.every: a row every 1e-12 s until 0.1 s makes 1e+11 rows, at most 1e+08 are "
          "allowed; choose 1e-09 s or more"));
}

TEST_F(BadInput, CommandLine) {
  EXPECT_EQ(ostium("").code, 2);
  EXPECT_EQ(ostium("rnu case.yaml").code, 2);
  EXPECT_EQ(ostium("run").code, 2);
  write("case.yaml", network);
  EXPECT_THAT(ostium("run case.yaml --set time.end").text, HasSubstr("expected KEY=VALUE"));
  EXPECT_EQ(ostium("run case.yaml --set time.end").code, 2);
}

}  // namespace
}  // namespace ostium::test
