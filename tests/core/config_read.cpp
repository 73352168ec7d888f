#include <gmock/gmock.h>

#include "config_struct.hpp"
#include "errors.hpp"

namespace ostium::test {
namespace {

TEST(ConfigRead, DefaultsFillWhatIsAbsent) {
  const Study s = read_study("title: x");
  EXPECT_EQ(s.title, "x");
  EXPECT_EQ(s.porosity, 0.5);
  EXPECT_EQ(s.cycles, 2);
  EXPECT_EQ(s.output.every, 0.01);
  EXPECT_FALSE(s.output.fields_every);
  EXPECT_FALSE(s.point);
}

TEST(ConfigRead, EveryKindOfField) {
  const Study s = read_study(R"(
title: "Aorta, five outlets"
porosity: 40 %
cycles: 3
force: yes
scheme: held
file: sub/../a.csv
stations: 1 2.5 mm
point: [1 cm, -2 mm, 0 m]
tags: [a, b]
output: {every: 5 ms, fields_every: 0.1 s}
outputs: [{every: 1 s}, {}]
blocks:
  second: {Rp: 1000 dyn.s/cm5, C: 1e-9 m3/Pa}
  first: {Rp: 1 Pa.s/m3, C: 1 mL/mmHg, Pd: 5 mmHg}
flow: 6 L/min
)");
  EXPECT_EQ(s.title, "Aorta, five outlets");
  EXPECT_DOUBLE_EQ(s.porosity, 0.4);
  EXPECT_EQ(s.cycles, 3);
  EXPECT_TRUE(s.force);
  EXPECT_EQ(s.scheme, Scheme::held);
  EXPECT_EQ(s.file, "a.csv");
  EXPECT_THAT(s.stations, testing::ElementsAre(1e-3, 2.5e-3));
  EXPECT_THAT(*s.point, testing::ElementsAre(1e-2, -2e-3, 0));
  EXPECT_THAT(s.tags, testing::ElementsAre("a", "b"));
  EXPECT_EQ(s.output.fields_every, 0.1);
  ASSERT_EQ(s.outputs.size(), 2u);
  EXPECT_EQ(s.outputs[1].every, 0.01);
  ASSERT_EQ(s.blocks.size(), 2u);
  EXPECT_EQ(s.blocks[0].first, "second");  // file order
  EXPECT_DOUBLE_EQ(s.blocks[0].second.Rp, 1e8);
  EXPECT_NEAR(s.blocks[1].second.Pd, 666.61, 0.01);
  EXPECT_DOUBLE_EQ(s.flow(3.0), 1e-4);
}

TEST(ConfigRead, RelativePathsReferToTheFolderOfTheFile) {
  const auto node = config::Node::parse("file: in/x.csv", "/cases/aorta/case.yaml");
  EXPECT_EQ(config::read<Study>(node).file, "/cases/aorta/in/x.csv");
}

TEST(ConfigRead, UnitsByName) {
  EXPECT_EQ(read_study("title: a").length_unit, 1);
  EXPECT_EQ(read_study("length_unit: cm").length_unit, 0.01);
  EXPECT_EQ(read_study("length_unit: 0.001 m").length_unit, 0.001);
}

TEST(ConfigRead, ValuesReplacedOnTheWay) {
  const auto node = config::Node::parse("title: a\noutput: {every: 1 s}\n", "case.yaml");
  const auto other = node.with_value("output.every", "2 s")
                         .with_value("output.fields_every", "3 s")
                         .with_value("cycles", "7");
  const Study s = config::read<Study>(other);
  EXPECT_EQ(s.output.every, 2);
  EXPECT_EQ(s.output.fields_every, 3);
  EXPECT_EQ(s.cycles, 7);
  EXPECT_EQ(config::read<Study>(node).output.every, 1);
  EXPECT_THAT(error_of([&] { config::read<Study>(node.with_value("output.every", "2 m")); }),
              testing::StartsWith("case.yaml:2:10: output.every: the unit \"m\" has the wrong dimension"));
}

TEST(ConfigRead, AnchorsAndMergeKeys) {
  const Study s = read_study(R"(
blocks:
  a: &rcr {Rp: 1 Pa.s/m3, C: 2 m3/Pa}
  b: {<<: *rcr, C: 3 m3/Pa}
  c: *rcr
)");
  EXPECT_EQ(s.blocks[1].second.C, 3);
  EXPECT_EQ(s.blocks[1].second.Rp, 1);
  EXPECT_EQ(s.blocks[2].second, s.blocks[0].second);
}

TEST(ConfigRead, AlsoAllowedKeysAreLeftToOthers) {
  const auto node = config::Node::parse("{type: windkessel, Rp: 1 Pa.s/m3, C: 1 m3/Pa}");
  EXPECT_EQ(config::read<Windkessel>(node, {"type", "from"}).Rp, 1);
  EXPECT_NE(error_of([&] { config::read<Windkessel>(node); }), "no error");
}

TEST(ConfigRead, SectionWithoutContentTakesItsDefaults) {
  EXPECT_EQ(read_study("output:\n").output.every, 0.01);
}

TEST(ConfigRead, RawNodeKeepsItsPosition) {
  const Study s = read_study("title: a\nextra:\n  deep: {x: 1}\n");
  EXPECT_EQ(s.extra.at("deep").at("x").where(), "case.yaml:3:10");
  EXPECT_EQ(s.extra.at("deep").at("x").path(), "extra.deep.x");
}

TEST(ConfigRead, EffectiveCaseReadsBackToTheSame) {
  const std::string yaml = R"(
title: "tricky: \"text\" # no comment"
porosity: 0.1
stations: [0.1 mm, 1 m]
point: 1 2 3 inch
output: {every: 0.3333333333333333 s}
outputs: [{every: 7 ms}]
blocks: {a: {Rp: 3.14 mmHg.s/mL, C: 1e-9 m3/Pa}}
flow: {times: [0, 0.1, 0.3], time_unit: s, values: [1, 5, 2], unit: L/min, period: 0.7 s, interpolation: monotone_cubic}
extra: {x: [1, 2, {y: 3}]}
)";
  const Study first = read_study(yaml);
  const std::string effective = config::emit(first);
  const Study second = read_study(effective);
  EXPECT_EQ(config::emit(second), effective);
  EXPECT_EQ(second.title, first.title);
  EXPECT_EQ(second.output, first.output);
  EXPECT_EQ(second.outputs, first.outputs);
  EXPECT_EQ(second.blocks, first.blocks);
  EXPECT_EQ(second.flow, first.flow);
  EXPECT_EQ(second.point, first.point);
  EXPECT_EQ(second.stations, first.stations);
  EXPECT_THAT(effective, testing::HasSubstr("porosity: 0.1"));
  EXPECT_THAT(effective, testing::HasSubstr("scheme: linearised"));
}

}  // namespace
}  // namespace ostium::test
