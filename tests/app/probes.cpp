// Probes and the force on the wall, as a case asks for them and as its results show them.
#include <fmt/format.h>

#include <algorithm>

#include "program.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;

std::string channel_with(const std::string& probes, const std::string& wall = "{model: rigid}") {
  return fmt::format(R"(vessel:
  dimension: 2
  outline: [[0 mm, 0 mm], [30 mm, 0 mm], [30 mm, 6 mm], [0 mm, 6 mm]]
  spacing: 0.6 mm
  openings:
    inlet: {{edge: 3, profile: plug}}
    outlet: {{edge: 1}}
  wall: {}
fluid: {{density: 1000 kg/m3, viscosity: 4 mPa.s}}
network:
  blocks:
    pump: {{type: flow_source, to: inlet, velocity: 0.3 m/s}}
    bed: {{type: pressure_source, from: outlet, pressure: 9000 Pa}}
time: {{end: 60 ms}}
output: {{every: 2 ms, fields_every: 0 s, probes: {}}}
)",
                     wall, probes);
}

/// A table whose cells may be names or nothing.
class Rows {
 public:
  explicit Rows(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::vector<std::string> cells(1);
      for (const char c : line)
        if (c == ',')
          cells.emplace_back();
        else
          cells.back() += c;
      header_.empty() ? header_ = cells : rows_.emplace_back(cells);
    }
  }
  const std::vector<std::string>& header() const { return header_; }
  std::size_t count() const { return rows_.size(); }
  const std::string& at(std::size_t row, const std::string& name) const {
    const auto column = std::find(header_.begin(), header_.end(), name) - header_.begin();
    return rows_.at(row).at(static_cast<std::size_t>(column));
  }
  double number(std::size_t row, const std::string& name) const { return std::stod(at(row, name)); }

 private:
  std::vector<std::string> header_;
  std::vector<std::vector<std::string>> rows_;
};

class Probes : public ProgramTest {
 protected:
  void run(const std::string& yaml) const {
    write("case.yaml", yaml);
    const Outcome outcome = ostium("run case.yaml -q -o results --threads 1");
    ASSERT_EQ(outcome.code, 0) << outcome.text;
  }
  Rows rows(const std::string& file) const { return Rows(content("results/" + file)); }
};

TEST_F(Probes, InTheBloodAndOnAWallThatMoves) {
  run(channel_with(
      "{axis: {at: [15 mm, 3 mm]}, top: {at: [15 mm, 6.2 mm], on: wall}}",
      "{model: shell, thickness: 0.6 mm, material: {E: 5 MPa, nu: 0.45}, outside_pressure: 8 kPa, "
      "support: {spring: 2e7 Pa/m, dashpot: 1e4 Pa.s/m}}"));
  const Rows probes = rows("probes.csv"), ports = rows("ports.csv"), wall = rows("wall.csv");
  EXPECT_EQ(probes.header(),
            (std::vector<std::string>{"time_s", "probe", "x_m", "y_m", "velocity_x_m_s", "velocity_y_m_s",
                                      "pressure_Pa", "displacement_x_m", "displacement_y_m",
                                      "wall_shear_stress_x_Pa", "wall_shear_stress_y_Pa"}));
  ASSERT_EQ(probes.count(), ports.count());
  ASSERT_EQ(2 * wall.count(), ports.count());
  for (std::size_t row = 0; row < ports.count(); ++row)
    EXPECT_EQ(probes.at(row, "time_s"), ports.at(row, "time_s"));

  const std::size_t axis = probes.count() - 2, top = probes.count() - 1, last = wall.count() - 1;
  EXPECT_EQ(probes.at(axis, "probe"), "axis");
  EXPECT_NEAR(probes.number(axis, "x_m"), 0.015, 1e-12);
  EXPECT_NEAR(probes.number(axis, "pressure_Pa"), 9000, 500);
  EXPECT_EQ(probes.at(axis, "displacement_x_m"), "");
  EXPECT_EQ(probes.at(top, "probe"), "top");
  EXPECT_EQ(probes.at(top, "velocity_y_m_s").empty(), false);
  EXPECT_NEAR(probes.number(top, "pressure_Pa"), probes.number(axis, "pressure_Pa"), 500);
  EXPECT_GT(probes.number(top, "wall_shear_stress_x_Pa"), 0);
  const double lift = probes.number(top, "displacement_y_m");
  EXPECT_GT(lift, 1e-6);
  EXPECT_NEAR(probes.number(top, "y_m"), 0.006 + lift, 1e-12);
  EXPECT_LE(lift, 1.01 * wall.number(last, "largest_displacement_m"));
  EXPECT_LT(wall.number(last, "largest_displacement_m"), 10 * lift);
  EXPECT_GT(wall.number(last, "strain_energy_J"), 0);
  EXPECT_GT(wall.number(last, "friction_force_x_N"), 0);
}

TEST_F(Probes, AtTheStartTheBloodRests) {
  run(channel_with("{axis: {at: [15 mm, 3 mm]}, top: {at: [15 mm, 6 mm], on: wall}}"));
  const Rows probes = rows("probes.csv"), wall = rows("wall.csv");
  EXPECT_EQ(wall.header(), (std::vector<std::string>{"time_s", "pressure_force_x_N", "pressure_force_y_N",
                                                     "friction_force_x_N", "friction_force_y_N"}));
  for (const std::size_t row : {0, 1}) {
    EXPECT_EQ(probes.number(row, "velocity_x_m_s"), 0);
    EXPECT_NEAR(probes.number(row, "pressure_Pa"), 9000, 1);
  }
  EXPECT_EQ(wall.number(0, "friction_force_x_N"), 0);
  const std::size_t last = probes.count() - 1;
  EXPECT_NEAR(probes.number(last - 1, "velocity_x_m_s"), 0.33, 0.05);
  EXPECT_EQ(probes.number(last, "displacement_y_m"), 0);
  EXPECT_NEAR(probes.number(last, "y_m"), 0.006, 1e-12);
  // the walls face each other: their pressures cancel but for the noise, a share of 9 kPa times 30 mm
  EXPECT_LT(std::abs(wall.number(wall.count() - 1, "pressure_force_x_N")), 1e-3 * 270);
}

TEST_F(Probes, AreListedByCheck) {
  write("case.yaml", channel_with("{axis: {at: [15 mm, 3 mm]}, top: {at: [15 mm, 6.2 mm], on: wall}}"));
  const Outcome outcome = ostium("check case.yaml");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("axis         probe in the blood at [0.015 m, 0.003 m]"));
  EXPECT_THAT(outcome.text, HasSubstr("top          probe on the wall at [0.015 m, 0.006 m]"));
}

TEST_F(Probes, OutsideTheVessel) {
  EXPECT_THAT(
      refused(channel_with("{axis: {at: [15 mm, 9 mm]}}")),
      HasSubstr("output.probes.axis.at: the probe lies outside the vessel, 3 mm from the wall; the nearest "
                "point of the wall is [0.015 m, 0.006 m]; move the probe inside, or write \"on: wall\""));
  EXPECT_THAT(
      refused(channel_with("{axis: {at: [34 mm, 3 mm]}}")),
      HasSubstr("the probe lies outside the vessel, beyond the opening \"outlet\", 5 mm from the wall; the "
                "nearest point of the wall is [0.03 m, "));
}

TEST_F(Probes, FarFromTheWall) {
  EXPECT_THAT(
      refused(channel_with("{top: {at: [15 mm, 3.5 mm], on: wall}}")),
      HasSubstr("output.probes.top.at: the probe is 2.5 mm from the wall, at most 1.2 mm are allowed, two "
                "spacings; the nearest point of the wall is [0.015 m, 0.006 m]"));
}

TEST_F(Probes, BadInput) {
  EXPECT_THAT(refused(channel_with("{axis: {at: [15 mm, 3 mm, 0 mm]}}")),
              HasSubstr("output.probes.axis.at: expected 2 coordinates, found 3"));
  EXPECT_THAT(refused(channel_with("{axis: {at: [15 mm, 3 mm]}, axis: {at: [16 mm, 3 mm]}}")),
              HasSubstr("the name \"axis\" is given twice"));
  EXPECT_THAT(refused(channel_with("{axis: {at: [15 mm, 3 mm], on: walls}}")),
              HasSubstr("output.probes.axis.on"));
  EXPECT_THAT(refused(channel_with("{axis: {on: wall}}")), HasSubstr("\"at\""));
}

TEST_F(Probes, NeedAVessel) {
  EXPECT_THAT(refused("network: {blocks: {heart: {type: flow_source, flow: 5 mL/s, to: in}, "
                      "body: {type: resistor, from: in, R: 1e8 Pa.s/m3, ground: 0 Pa}}}\n"
                      "time: {end: 0.1 s}\noutput: {probes: {axis: {at: [15 mm, 3 mm]}}}\n"),
              HasSubstr("output.probes.axis: probes are points of a vessel, and this case has none"));
}

}  // namespace
}  // namespace ostium::test
