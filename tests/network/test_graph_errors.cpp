#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string out = "out: {type: resistor, from: A, ground: 0 Pa, R: 1 Pa.s/m3}\n";
const std::string heart = "heart: {type: flow_source, to: A, flow: 5 mL/s}\n";
const std::vector<Port> at_A{{"A", 1e-4}};

TEST(GraphErrors, NoBlocks) {
  EXPECT_THAT(error_of("{}"), HasSubstr("a network needs at least one block"));
  EXPECT_THAT(error_of("blocks:"), StartsWith("case.yaml:1"));
}

TEST(GraphErrors, BlocksThatAreAList) {
  EXPECT_THAT(error_of("- {type: resistor}"), StartsWith("case.yaml:1"));
}

TEST(GraphErrors, UnknownTypeAtItsPosition) {
  EXPECT_THAT(error_of("a: {type: resistr, from: A}"),
              AllOf(StartsWith("case.yaml:1:"), HasSubstr("did you mean \"resistor\"?")));
}

TEST(GraphErrors, TwoBlocksOfOneName) {
  EXPECT_THAT(error_of(out + out), AllOf(StartsWith("case.yaml:2:1"), HasSubstr("out")));
  Model twice = model(heart + out);
  twice.entries.push_back(twice.entries[1]);
  EXPECT_THROW(Network{twice}, UserError);
}

TEST(GraphErrors, FloatingNode) {
  const auto text = error_of(heart + out + "b: {type: resistor, from: A, to: Lost, R: 1 Pa.s/m3}\n");
  EXPECT_THAT(text,
              AllOf(StartsWith("case.yaml:3:"), HasSubstr("the node \"Lost\" has no other block than \"b\""),
                    HasSubstr("join a second block")));
}

TEST(GraphErrors, MisspeltNode) {
  EXPECT_THAT(error_of("heart: {type: flow_source, to: Aroot, flow: 5 mL/s}\nout: {type: resistor, from: "
                       "Aroto, ground: 0 Pa, "
                       "R: 1 Pa.s/m3}\n"),
              HasSubstr("did you mean \"Aroto\"?"));
}

TEST(GraphErrors, OpeningWithoutBlock) {
  const auto text = error_of(heart + out, {{"A", 1e-4}, {"DAo", 1e-4}});
  EXPECT_THAT(text, HasSubstr("the opening \"DAo\" has no block"));
  EXPECT_THAT(text, HasSubstr("from: DAo, pressure: 80 mmHg"));
  EXPECT_THAT(error_of("dao: {type: resistor, from: DA0, ground: 0 Pa, R: 1 Pa.s/m3}\n" + out,
                       {{"A", 1e-4}, {"DAo", 1e-4}}),
              HasSubstr("did you mean it by the node \"DA0\"?"));
}

TEST(GraphErrors, VelocityAwayFromAnOpening) {
  EXPECT_THAT(error_of("heart: {type: flow_source, to: A, velocity: 1 m/s}\n" + out),
              HasSubstr("`velocity` is the mean velocity over an opening of the vessel, and \"heart\" is at "
                        "none; give its `flow`"));
}

TEST(GraphErrors, TwoFlowSourcesAtANode) {
  EXPECT_THAT(
      error_of(heart + "pump: {type: flow_source, from: A, flow: 5 mL/s}\n"),
      HasSubstr(
          "the flow sources \"heart\" and \"pump\" meet at \"A\" and nothing there can take the difference"));
}

TEST(GraphErrors, TwoFlowSourcesAtAnOpening) {
  EXPECT_THAT(error_of(heart + "pump: {type: flow_source, to: A, flow: 5 mL/s}\n", at_A),
              HasSubstr("two flow sources, \"heart\" and \"pump\", prescribe the flow of the opening \"A\""));
}

TEST(GraphErrors, EveryOpeningPrescribed) {
  EXPECT_THAT(error_of(heart, at_A), HasSubstr("every opening of the vessel has a prescribed flow"));
}

TEST(GraphErrors, NoPressureReference) {
  EXPECT_THAT(error_of(heart + "r: {type: resistor, from: A, to: B, R: 1 Pa.s/m3}\nsink: {type: flow_source, "
                               "from: B, flow: 5 mL/s}\n"),
              AllOf(HasSubstr("nothing says the level of pressure at \"A\" and \"B\""),
                    HasSubstr("`ground: 0 mmHg`")));
  EXPECT_THAT(error_of("r: {type: resistor, from: A, to: B, R: 1 Pa.s/m3}\n", {{"A", 1e-4}, {"B", 1e-4}}),
              HasSubstr("nothing says the level of pressure"));
}

TEST(GraphErrors, VesselFlowIntoAnInductor) {
  const auto text = error_of(
      "l: {type: inductor, from: A, to: B, L: 1 Pa.s2/m3}\nr: {type: resistor, from: B, ground: 0 Pa, R: 1 "
      "Pa.s/m3}\n",
      at_A);
  EXPECT_THAT(text,
              AllOf(HasSubstr("only inductors, prescribed flows or the vessel's flow meet at \"A\""),
                    HasSubstr("index 2"), HasSubstr("`A_c: {type: capacitor, from: A, C: 1e-11 m3/Pa}`")));
}

TEST(GraphErrors, TheProposedRemedyWorks) {
  EXPECT_EQ(error_of("l: {type: inductor, from: A, to: B, L: 1e5 Pa.s2/m3}\nr: {type: resistor, from: B, "
                     "ground: 0 Pa, R: 1e7 Pa.s/m3}\n"
                     "A_c: {type: capacitor, from: A, C: 1e-11 m3/Pa}\n",
                     at_A),
            "no error");
}

TEST(GraphErrors, FlowSourceIntoAnInductor) {
  EXPECT_THAT(error_of(heart + "l: {type: inductor, from: A, ground: 0 Pa, L: 1 Pa.s2/m3}\n"),
              HasSubstr("only inductors or prescribed flows meet at \"A\" (blocks \"heart\" and \"l\")"));
}

TEST(GraphErrors, InductorsAloneBehindAResistor) {
  EXPECT_THAT(error_of("l: {type: inductor, from: A, ground: 0 Pa, L: 1 Pa.s2/m3}\nr: {type: resistor, from: "
                       "A, to: B, R: 1 Pa.s/m3}\n"
                       "m: {type: inductor, from: B, ground: 1 Pa, L: 1 Pa.s2/m3}\n"),
              HasSubstr("meet at \"A\" and \"B\""));
}

TEST(GraphErrors, LoopOfCapacitors) {
  EXPECT_THAT(
      error_of(heart +
               "c: {type: capacitor, from: A, C: 1 m3/Pa}\nd: {type: capacitor, from: A, C: 1 m3/Pa}\n"),
      AllOf(HasSubstr("the blocks \"c\" and \"d\" form a loop"), HasSubstr("small resistor in series")));
  EXPECT_THAT(error_of("p: {type: pressure_source, to: A, pressure: 1 Pa}\nc: {type: capacitor, from: A, to: "
                       "B, C: 1 m3/Pa}\n"
                       "d: {type: capacitor, from: B, C: 1 m3/Pa}\n"),
              HasSubstr("the blocks \"p\", \"c\" and \"d\" form a loop"));
}

TEST(GraphErrors, TwoPressureSources) {
  EXPECT_THAT(error_of("p: {type: pressure_source, to: A, pressure: 1 Pa}\nq: {type: pressure_source, from: "
                       "A, pressure: 2 Pa}\n"),
              HasSubstr("the pressure sources \"p\" and \"q\" prescribe the same pressure twice"));
}

/// Odd but legal: none may crash, hang or give anything but numbers.
TEST(WeirdGraphs, AreSolved) {
  const std::vector<std::string> odd{
      // parallel pair, opposite arrows
      heart + out + "back: {type: resistor, to: A, ground: 0 Pa, R: 2 Pa.s/m3}\n",
      // two separate circuits in one case
      heart + out +
          "h2: {type: flow_source, to: X, flow: 5 mL/s}\no2: {type: capacitor, from: X, C: 1e-9 m3/Pa}\n",
      // closed ring of resistors around a grounded compliance
      "a: {type: resistor, from: A, to: B, R: 1e6 Pa.s/m3}\nb: {type: resistor, from: B, to: D, R: 1e6 "
      "Pa.s/m3}\n"
      "c: {type: resistor, from: D, to: A, R: 1e6 Pa.s/m3}\nd: {type: capacitor, from: A, C: 1e-9 m3/Pa}\n",
      // nothing drives it
      out + "c: {type: capacitor, from: A, C: 1e-9 m3/Pa}\n",
      // extreme values side by side
      heart +
          "a: {type: windkessel, from: A, Rp: 1 Pa.s/m3, C: 1e-15 m3/Pa, Rd: 1e14 Pa.s/m3}\n"
          "b: {type: windkessel, from: A, Rp: 1e14 Pa.s/m3, C: 1 m3/Pa, Rd: 1 Pa.s/m3}\n",
      // names with blanks and other scripts
      "\"left heart\": {type: flow_source, to: \"große Ader\", flow: 5 mL/s}\n"
      "ende: {type: resistor, from: \"große Ader\", ground: 0 Pa, R: 1e8 Pa.s/m3}\n"};
  for (const auto& yaml : odd)
    for (auto method : {Method::exact, Method::runge_kutta, Method::ida}) {
      Network n(model(yaml), {}, with(method));
      n.advance(0.01, {}, {});
      std::vector<double> values(n.series_names().size());
      n.series(values);
      for (double v : values) EXPECT_TRUE(std::isfinite(v)) << yaml;
    }
}

/// A chain too long for the exponential.
TEST(WeirdGraphs, LongLadder) {
  std::string yaml = "in: {type: pressure_source, to: n0, pressure: 100 mmHg}\n";
  for (int i = 0; i < 200; ++i)
    yaml += fmt::format(
        "r{0}: {{type: resistor, from: n{0}, to: n{1}, R: 1e5 Pa.s/m3}}\nc{0}: {{type: capacitor, from: "
        "n{1}, C: 1e-11 m3/Pa}}\n",
        i, i + 1);
  yaml += "end: {type: resistor, from: n200, ground: 0 Pa, R: 2e7 Pa.s/m3}\n";
  Network n(model(yaml));
  n.advance(5.0, {}, {});
  EXPECT_NEAR(series(n, "p:n200_Pa"), 0.5 * 13332.2387415, 1e-3);
}

}  // namespace
}  // namespace ostium::network
