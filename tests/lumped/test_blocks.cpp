#include <fstream>

#include "lumped/windkessel.hpp"
#include "tests/lumped/support.hpp"

namespace ostium::lumped {
namespace {

TEST(Resistor, Equation) {
  const auto b = block("{type: resistor, from: A, to: B, R: 2 Pa.s/m3}");
  EXPECT_EQ(answer(*b, {10, 4, 2, 0}), (std::vector<double>{10 - 4 - 2 * 2, 2, -2}));
  expect_exact_jacobian(*b, {10, 4, 2, 0.5});
  EXPECT_EQ(b->branches()[0].nature, Nature::resistive);
}

TEST(Resistor, EndsAtAGroundPressure) {
  const auto b = block("{type: resistor, from: A, R: 2 Pa.s/m3, ground: 10 mmHg}");
  EXPECT_TRUE(b->terminals()[1].grounded());
  EXPECT_NEAR(b->terminals()[1].ground, 1333.22387415, 1e-6);
}

TEST(Capacitor, Equation) {
  const auto b = block("{type: capacitor, from: A, C: 3 m3/Pa, initial_pressure: 7 Pa}");
  // p_from, p_to | q, u | dq, du
  EXPECT_EQ(answer(*b, {10, 4, 2, 5, 0, 0.5}), (std::vector<double>{10 - 4 - 5, 3 * 0.5 - 2, 2, -2}));
  expect_exact_jacobian(*b, {10, 4, 2, 5, 0.1, 0.5});
  double y[2];
  b->initial(y);
  EXPECT_EQ(y[1], 7);
  EXPECT_EQ(b->compliance(), 3);
}

TEST(Inductor, Equation) {
  const auto b = block("{type: inductor, from: A, to: B, L: 3 Pa.s2/m3, initial_flow: 2 mL/s}");
  EXPECT_EQ(answer(*b, {10, 4, 2, 0.5}), (std::vector<double>{3 * 0.5 - 6, 2, -2}));
  expect_exact_jacobian(*b, {10, 4, 2, 0.5});
  double y[1];
  b->initial(y);
  EXPECT_NEAR(y[0], 2e-6, 1e-20);
}

TEST(Windkessel, Equations) {
  const auto b = block("{type: windkessel, from: A, to: V, Rp: 2 Pa.s/m3, C: 3 m3/Pa, Rd: 4 Pa.s/m3}");
  // p_from, p_to | q, Pc | dq, dPc
  EXPECT_EQ(answer(*b, {20, 4, 2, 12, 0, 0.5}),
            (std::vector<double>{20 - 12 - 2 * 2, 3 * 0.5 - (2 - 2), 2, -2}));
  expect_exact_jacobian(*b, {20, 4, 2, 12, 0.1, 0.5});
}

TEST(Windkessel, StartsAtItsDistalPressureUnlessTold) {
  double y[2];
  block("{type: windkessel, from: A, Rp: 2 Pa.s/m3, C: 3 m3/Pa, Rd: 4 Pa.s/m3, Pd: 9 Pa}")->initial(y);
  EXPECT_EQ(y[1], 9);
  block(
      "{type: windkessel, from: A, Rp: 2 Pa.s/m3, C: 3 m3/Pa, Rd: 4 Pa.s/m3, Pd: 9 Pa, initial_pressure: 11 "
      "Pa}")
      ->initial(y);
  EXPECT_EQ(y[1], 11);
}

TEST(Windkessel, WithoutProximalResistanceFixesThePressure) {
  const auto b = block("{type: windkessel, from: A, Rp: 0 Pa.s/m3, C: 3 m3/Pa, Rd: 4 Pa.s/m3}");
  EXPECT_EQ(b->branches()[0].nature, Nature::capacitive);
}

TEST(FlowSource, SendsItsWaveform) {
  const auto b = block(
      "{type: flow_source, to: A, flow: {times: [0, 1, 2], time_unit: s, values: [0, 4, 0], unit: m3/s, "
      "period: 2 s}}");
  EXPECT_EQ(answer(*b, {0, 7, 3, 0}, 0.25), (std::vector<double>{3 - 1, 3, -3}));
  EXPECT_EQ(b->prescribed_flow(1.5), 2);
  EXPECT_EQ(b->kinks(0.5, 2.5), (std::vector<double>{1, 2}));
  expect_exact_jacobian(*b, {1, 7, 3, 0.1});
}

TEST(FlowSource, VelocityTimesTheAreaOfItsOpening) {
  const auto b = block("{type: flow_source, to: A, velocity: 0.5 m/s}");
  EXPECT_TRUE(b->needs_opening());
  const auto placed = b->at_opening(4e-4);
  EXPECT_FALSE(placed->needs_opening());
  EXPECT_DOUBLE_EQ(placed->prescribed_flow(0), 2e-4);
}

TEST(PressureSource, AtEitherEndAndBetween) {
  EXPECT_EQ(answer(*block("{type: pressure_source, to: A, pressure: 3 Pa}"), {0, 10, 2, 0})[0], 7);
  EXPECT_EQ(answer(*block("{type: pressure_source, from: A, pressure: 3 Pa}"), {10, 0, 2, 0})[0], 7);
  const auto pump = block("{type: pressure_source, from: A, to: B, pressure: 3 Pa}");
  EXPECT_EQ(answer(*pump, {10, 14, 2, 0}), (std::vector<double>{1, 2, -2}));
  expect_exact_jacobian(*pump, {10, 14, 2, 0.1});
}

/// The snippet each header shows its reader must be one the program reads; it may run over several lines.
std::string example_of(const std::string& type) {
  std::ifstream header(std::string(OSTIUM_SOURCE_DIR) + "/lumped/" + type + ".hpp");
  std::string text;
  for (std::string line; std::getline(header, line);) {
    if (line == "///" && !text.empty()) return text.substr(text.find(": ") + 2);
    if (!text.empty() || line == "/// Example:")
      text += line.substr(line == "/// Example:" ? line.size() : 3) + " ";
  }
  return "";
}

TEST(Registry, EveryHeaderShowsAnExampleThatReads) {
  for (const auto& type : block_types()) {
    const std::string yaml = example_of(type.name);
    ASSERT_NE(yaml, "") << type.name;
    EXPECT_EQ(block(yaml)->type(), type.name);
  }
}

TEST(Registry, WhatIsWrittenReadsBack) {
  for (const auto& type : block_types()) {
    const auto first = block(example_of(type.name));
    const auto text = config::to_yaml(write_block(*first));
    const auto second = read_block(config::Node::parse(text));
    EXPECT_EQ(config::to_yaml(write_block(*second)), text) << type.name;
  }
}

TEST(Registry, EveryFieldIsDocumented) {
  for (const auto& type : block_types())
    for (const auto& field : type.describe()) EXPECT_NE(field.doc, "") << type.name << "." << field.name;
}

}  // namespace
}  // namespace ostium::lumped
