#include "network/subnetwork.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

using config::Node;
using testing::HasSubstr;

/// The blocks of a case, expanded.
Node blocks(const std::string& yaml) {
  const Node root = Node::parse(yaml, "case.yaml");
  return expand(root.at("blocks"), root.find("subnetworks"));
}

std::string error(const std::string& yaml) {
  try {
    Network network(read_model(blocks(yaml)));
  } catch (const UserError& e) {
    return e.what();
  }
  return "no error";
}

const std::string bed =
    "subnetworks:\n"
    "  bed:\n"
    "    ports: [artery, vein]\n"
    "    parameters:\n"
    "      R: {unit: Pa.s/m3, default: 1e8 Pa.s/m3, doc: resistance}\n"
    "      tau: {unit: s, doc: time constant}\n"
    "    blocks:\n"
    "      c: {type: capacitor, from: artery, C: $tau / $R, initial_pressure: 0 Pa}\n"
    "      a: {type: resistor, from: artery, to: mid, R: 0.25 * $R}\n"
    "      b: {type: resistor, from: mid, to: vein, R: (1 - 0.25) * $R}\n"
    "blocks:\n"
    "  heart: {type: flow_source, to: Ao, flow: 100 mL/s}\n"
    "  veins: {type: pressure_source, to: V, pressure: 5 mmHg}\n";

TEST(Subnetworks, AreTheirBlocks) {
  const Node all = blocks(bed + "  body: {type: bed, artery: Ao, vein: V, R: 2e8 Pa.s/m3, tau: 1 s}\n");
  EXPECT_EQ(all.keys(), (std::vector<std::string>{"heart", "veins", "body.c", "body.a", "body.b"}));
  Network n(read_model(all));
  run_to(n, 2);
  const double R = 2e8, q = 1e-4, p = 5 * 133.322387415;
  EXPECT_NEAR(series(n, "p:Ao_Pa"), p * (1 - std::exp(-2.0)) + R * q * (1 - std::exp(-2.0)), 1e-8 * R * q);
  EXPECT_NEAR(series(n, "p:body.mid_Pa") - p, 0.75 * (series(n, "p:Ao_Pa") - p), 1e-8 * R * q);
}

TEST(Subnetworks, DefaultsOverridesAndNodesInside) {
  const Node all = blocks(bed +
                          "  body: {type: bed, artery: Ao, vein: V, tau: 1 s, b.R: 3e8 Pa.s/m3}\n"
                          "  leak: {type: resistor, from: body.mid, to: V, R: 3e8 Pa.s/m3}\n");
  EXPECT_EQ(all.at("body.a").at("R").text(), "25000000 Pa.s/m3");
  EXPECT_EQ(all.at("body.b").at("R").text(), "3e8 Pa.s/m3");
  Network n(read_model(all));
  run_to(n, 60);
  EXPECT_NEAR(series(n, "p:Ao_Pa"), 5 * 133.322387415 + 1e-4 * (25e6 + 1.5e8), 1e-3);
}

TEST(Subnetworks, WithinSubnetworks) {
  const std::string pair =
      "  two:\n"
      "    ports: {in: the artery, out: the vein}\n"
      "    parameters: {R: {unit: Pa.s/m3}}\n"
      "    blocks:\n"
      "      one: {type: bed, artery: in, vein: m, R: $R, tau: 1 s}\n"
      "      r: {type: resistor, from: m, to: out, R: $R}\n";
  std::string yaml = bed;
  yaml.insert(yaml.find("blocks:\n  heart"), pair);
  const Node all =
      blocks(yaml + "  body: {type: two, in: Ao, out: V, R: 1e8 Pa.s/m3, one.b.R: 2e8 Pa.s/m3}\n");
  EXPECT_EQ(all.keys().back(), "body.r");
  EXPECT_EQ(all.at("body.one.b").at("to").text(), "body.m");
  Network n(read_model(all));
  run_to(n, 60);
  EXPECT_NEAR(series(n, "p:Ao_Pa"), 5 * 133.322387415 + 1e-4 * (25e6 + 2e8 + 1e8), 1e-3);
}

/// Errors inside name the line of the definition and of the use.
TEST(Subnetworks, ErrorsNameDefinitionAndUse) {
  std::string yaml = bed;
  yaml.replace(yaml.find("0.25 * $R"), 9, "-1 Pa.s/m3");
  const std::string use = "  body: {type: bed, artery: Ao, vein: V, tau: 1 s}\n";
  EXPECT_THAT(error(yaml + use),
              HasSubstr("case.yaml:9:50 (used at case.yaml:14:3): blocks.body.a.R: -1 Pa.s/m3"));
  EXPECT_THAT(error(bed + "  body: {type: bed, artery: Ao, vein: V, tau: 0 s}\n"),
              HasSubstr("blocks.body.c.C: 0 "));
  EXPECT_THAT(error(bed + "  body: {type: bed, artery: Ao, vein: V, tau: 1 s, a.R: -2 Pa.s/m3}\n"),
              HasSubstr("case.yaml:14:52: blocks.body.a.R: -2 Pa.s/m3 is not allowed"));
  EXPECT_THAT(error("blocks:\n  c: {type: closed_loop, heart.lv.Emax: -2 mmHg/mL}\n"),
              HasSubstr("case.yaml:2:26: blocks.c.heart.lv.Emax: -2 mmHg/mL"));
  EXPECT_THAT(
      error(
          "blocks:\n  h: {type: heart, veins: V, pulmonary_artery: P, pulmonary_veins: L, aorta: A, period: "
          "0 s}\n"),
      testing::AllOf(HasSubstr("case.yaml:2:89 (for ostium/heart.yaml:"), HasSubstr("0 s is not allowed")));
}

TEST(Subnetworks, BadUses) {
  const auto use = [](const std::string& rest) { return error(bed + "  body: {type: bed" + rest + "}\n"); };
  EXPECT_THAT(use(", artery: Ao, vein: V"),
              HasSubstr("case.yaml:14:3: blocks.body: the key \"tau\" is missing: time "
                        "constant [s]"));
  EXPECT_THAT(use(", artery: Ao, tau: 1 s"), HasSubstr("the key \"vein\" is missing: name the node"));
  EXPECT_THAT(use(", artery: Ao, vein: V, tua: 1 s"),
              HasSubstr("unknown key \"tua\"; did you mean \"tau\"?"));
  EXPECT_THAT(use(", artery: Ao, vein: V, tau: 1 m"), HasSubstr("wrong dimension"));
  EXPECT_THAT(use(", artery: Ao, vein: V, tau: 1 s, d.R: 1 Pa"),
              HasSubstr("the subnetwork \"bed\" has no block \"d\""));
  EXPECT_THAT(use(", artery: Ao, vein: V, tau: 1 s, a.S: 1 Pa"), HasSubstr("unknown key \"S\""));
  EXPECT_THAT(use(", artery: Ao, vein: Ao, tau: 1 s"), HasSubstr("node \"V\""));
  EXPECT_THAT(error("blocks: {h: {type: heartt}}"),
              HasSubstr("there is no block type \"heartt\"; did you mean \"heart\""));
}

TEST(Subnetworks, BadDefinitions) {
  const auto with = [](std::string from, const std::string& to) {
    std::string yaml = bed + "  body: {type: bed, artery: Ao, vein: V, tau: 1 s}\n";
    yaml.replace(yaml.find(from), from.size(), to);
    return error(yaml);
  };
  EXPECT_THAT(with("0.25 * $R", "0.25 * $S"), HasSubstr("the subnetwork has no parameter \"S\""));
  EXPECT_THAT(with("0.25 * $R", "0.25 * $R + $tau"), HasSubstr("which are different things"));
  EXPECT_THAT(with("0.25 * $R", "0.25 Ohm * $R"), HasSubstr("cannot be read from its character 6 on"));
  EXPECT_THAT(with("0.25 * $R", "(0.25 * $R"), HasSubstr("cannot be read"));
  EXPECT_THAT(with("  bed:\n", "  resistor:\n"), HasSubstr("is the name of a block that the program has"));
  EXPECT_THAT(with("ports: [artery, vein]", "ports: [artery, vein, side]"),
              HasSubstr("the key \"side\" is missing"));
  EXPECT_THAT(with("to: vein, R", "to: veiin, R"), HasSubstr("no block is at the port \"vein\""));
  EXPECT_THAT(with("      tau: {", "      vein: {unit: s}\n      tau: {"),
              HasSubstr("is both a parameter and a port"));
  EXPECT_THAT(with("      c: {", "      c.d: {"), HasSubstr("letters, digits and _ are allowed"));
  EXPECT_THAT(with("type: capacitor, from: artery", "type: bed, vein: artery, artery: vein"),
              HasSubstr("contains itself"));
  EXPECT_THAT(with("    ports:", "    port:"), HasSubstr("unknown key \"port\"; did you mean \"ports\"?"));
}

}  // namespace
}  // namespace ostium::network
