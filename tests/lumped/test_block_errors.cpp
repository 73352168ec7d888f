#include <gmock/gmock.h>

#include "tests/lumped/support.hpp"

namespace ostium::lumped {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(BlockErrors, UnknownType) {
  const auto text = error_of("{type: windkesel, from: A}");
  EXPECT_THAT(text, StartsWith("case.yaml:1:"));
  EXPECT_THAT(text, HasSubstr("there is no block type \"windkesel\"; did you mean \"windkessel\"?"));
  EXPECT_THAT(text, HasSubstr("pressure_source"));
}

TEST(BlockErrors, NoType) { EXPECT_THAT(error_of("{from: A, R: 1 Pa.s/m3}"), HasSubstr("type")); }

TEST(BlockErrors, NegativeResistance) {
  const auto text = error_of("{type: resistor, from: A, to: B, R: -5 Pa.s/m3}");
  EXPECT_THAT(text, HasSubstr("R"));
  EXPECT_THAT(text, HasSubstr("-5"));
  EXPECT_THAT(text, HasSubstr("> 0"));
}

TEST(BlockErrors, MisspeltParameter) {
  EXPECT_THAT(error_of("{type: windkessel, from: A, Rpp: 1 Pa.s/m3, C: 1 m3/Pa, Rd: 1 Pa.s/m3}"),
              HasSubstr("did you mean \"Rp\"?"));
}

TEST(BlockErrors, MissingUnit) {
  EXPECT_THAT(error_of("{type: resistor, from: A, to: B, R: 5}"), HasSubstr("unit"));
}

TEST(BlockErrors, OneEndOnly) {
  const auto text = error_of("{type: resistor, from: A, R: 5 Pa.s/m3}");
  EXPECT_THAT(text,
              HasSubstr("the resistor ends at one node only (`from: A`); name the other one with `to`"));
  EXPECT_THAT(text, HasSubstr("`ground: 0 mmHg`"));
}

TEST(BlockErrors, NoEnd) {
  EXPECT_THAT(error_of("{type: capacitor, C: 1 m3/Pa}"),
              HasSubstr("the capacitor names no node; give `from: NODE`"));
}

TEST(BlockErrors, SameNodeTwice) {
  EXPECT_THAT(error_of("{type: inductor, from: A, to: A, L: 1 Pa.s2/m3}"),
              HasSubstr("begins and ends at the same node \"A\""));
}

TEST(BlockErrors, ThreeEnds) {
  EXPECT_THAT(
      error_of("{type: windkessel, from: A, to: B, Pd: 1 Pa, Rp: 1 Pa.s/m3, C: 1 m3/Pa, Rd: 1 Pa.s/m3}"),
      HasSubstr("has `from`, `to` and `Pd`; a block has two ends"));
}

TEST(BlockErrors, WindkesselWithoutFrom) {
  EXPECT_THAT(error_of("{type: windkessel, to: B, Rp: 1 Pa.s/m3, C: 1 m3/Pa, Rd: 1 Pa.s/m3}"),
              HasSubstr("the windkessel has no `from`"));
}

TEST(BlockErrors, NamelessNode) {
  EXPECT_THAT(error_of("{type: flow_source, to: \"\", flow: 1 mL/s}"),
              HasSubstr("has a node without a name"));
}

TEST(BlockErrors, FlowAndVelocity) {
  EXPECT_THAT(error_of("{type: flow_source, to: A, flow: 1 mL/s, velocity: 1 m/s}"),
              HasSubstr("the flow_source needs one of `flow` and `velocity`, found both"));
  EXPECT_THAT(error_of("{type: flow_source, to: A}"), HasSubstr("found none"));
}

}  // namespace
}  // namespace ostium::lumped
