// At least two malformed inputs per family of blocks.
#include "malformed.hpp"

namespace ostium::test {
namespace {

class MalformedBlock : public MalformedCase {};
TEST_P(MalformedBlock, IsRefused) { refuse(); }

const auto in_line_5 = [](const std::string& name, const std::string& block, const std::string& key,
                          const std::string& sentence) {
  return Malformed{name, beside("x: {" + block + "}"), {"case.yaml:5:", "network.blocks.x" + key, sentence}};
};

INSTANTIATE_TEST_SUITE_P(
    TwoTerminals, MalformedBlock,
    testing::Values(
        in_line_5("ResistorOfZero", "type: resistor, from: A, ground: 0 Pa, R: 0 Pa.s/m3",
                  ".R: ", "it must be > 0"),
        in_line_5("ResistorOfTwoNumbers", "type: resistor, from: A, ground: 0 Pa, R: 1 000 Pa.s/m3",
                  ".R: ", "\"1 000 Pa.s/m3\" holds two numbers; write one number, without blanks in it"),
        in_line_5("ResistorBeyondThisWorld", "type: resistor, from: A, ground: 0 Pa, R: 1e300 Pa.s/m3",
                  ".R: ", "look at its exponent"),
        in_line_5("CapacitorOfZero", "type: capacitor, from: A, C: 0 m3/Pa", ".C: ", "it must be > 0 m3/Pa"),
        in_line_5("CapacitorOfAResistance", "type: capacitor, from: A, C: 1e8 Pa.s/m3",
                  ".C: ", "has the wrong dimension; expected a unit that converts to m3/Pa"),
        in_line_5("InductorNegative", "type: inductor, from: A, ground: 0 Pa, L: -1 Pa.s2/m3", ".L: ", "> 0"),
        in_line_5("InductorOfAHugeFlow",
                  "type: inductor, from: A, ground: 0 Pa, L: 1e5 Pa.s2/m3, initial_flow: 1e200 m3/s",
                  ".initial_flow: ", "look at its exponent"),
        in_line_5("UnknownType", "type: resistr, from: A", ".type: ", "did you mean \"resistor\"?"),
        in_line_5("NoType", "from: A, R: 1e7 Pa.s/m3", ": ", "the key \"type\" is missing"),
        in_line_5("JunctionIsNoBlock", "type: junction, from: A, to: B",
                  ".type: ", "there is no block type \"junction\""),
        in_line_5("JunctionOfManyNodes", "type: resistor, from: [A, B], to: D, R: 1e7 Pa.s/m3",
                  ".from: ", "expected a text, found a list")),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Vessels, MalformedBlock,
    testing::Values(
        in_line_5("VesselOfUnknownOrder", "type: vessel, from: A, ground: 0 Pa, R: 1e7 Pa.s/m3, order: LRC",
                  ".order: ", "Allowed: RCL, CRL"),
        in_line_5("VesselOfNegativeCompliance",
                  "type: vessel, from: A, ground: 0 Pa, R: 1e7 Pa.s/m3, C: -1e-9 m3/Pa",
                  ".C: ", ">= 0 m3/Pa"),
        in_line_5("StenosisNegative", "type: vessel, from: A, ground: 0 Pa, R: 1e7 Pa.s/m3, K: -5 Pa.s2/m6",
                  ": ", "K is -5 Pa.s2/m6, and a loss must be >= 0"),
        in_line_5("StenosisInAnInertancesUnit",
                  "type: vessel, from: A, ground: 0 Pa, R: 1e7 Pa.s/m3, K: 5 Pa.s2/m3",
                  ".K: ", "converts to Pa.s2/m6"),
        Malformed{"VesselsThatCancel",
                  network_of({source, "r: {type: resistor, from: A, ground: 0 Pa, R: 1e7 Pa.s/m3}",
                              "x: {type: vessel, from: A, ground: 0 Pa, R: -1e7 Pa.s/m3, fitted: true}"}),
                  {"case.yaml:", "network.blocks.", "undetermined"}},
        in_line_5("RcThatMayStore",
                  "type: rc, from: A, ground: 0 Pa, R: 1e7 Pa.s/m3, C: 1e-9 m3/Pa, stores: maybe",
                  ".stores: ", "expected true or false, found \"maybe\""),
        in_line_5("RcWithoutCompliance", "type: rc, from: A, ground: 0 Pa, R: 1e7 Pa.s/m3", ": ",
                  "the key \"C\" is missing: compliance [m3/Pa]")),
    name_of);

const std::string coronary =
    "type: coronary, from: A, Ra: 1e9 Pa.s/m3, Ram: 2e9 Pa.s/m3, Rv: 1e9 Pa.s/m3, Ca: 1e-11 m3/Pa, Cim: "
    "1e-10 m3/Pa";

INSTANTIATE_TEST_SUITE_P(
    Beds, MalformedBlock,
    testing::Values(
        in_line_5(
            "WindkesselWithTwoDistalEnds",
            "type: windkessel, from: A, to: B, Pd: 5 mmHg, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1e8 Pa.s/m3",
            ": ", "has `from`, `to` and `Pd`"),
        in_line_5("WindkesselWithAVolumeAsDistalPressure",
                  "type: windkessel, from: A, Pd: 5 mL, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1e8 Pa.s/m3",
                  ".Pd: ", "the unit \"mL\" has the wrong dimension"),
        in_line_5("WindkesselIntoNothing",
                  "type: windkessel, from: A, to: B, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1e8 Pa.s/m3", ": ",
                  "the node \"B\" has no other block than \"x\""),
        in_line_5("CoronaryOfNoVentricle", coronary + ", ventricle: LVV", ": ",
                  "the node \"LVV\" has no other block"),
        in_line_5("CoronaryOfAHugeShare", coronary + ", share: 1e20",
                  ".share: ", "it must be >= 0 and <= 10"),
        in_line_5("CoronaryThrottledByNothing", coronary + ", Ram_max: 3e9 Pa.s/m3", ": ",
                  "needs an \"activation\""),
        in_line_5("ImpedanceOfUnequalLists",
                  "type: impedance, from: A, frequency: [0 Hz, 1 Hz], modulus: [1e8 Pa.s/m3], phase: [0 rad, "
                  "0 rad]",
                  ": ", "\"frequency\" has 2 values, \"modulus\" 1 and \"phase\" 2"),
        in_line_5("ImpedanceThatGivesEnergy",
                  "type: impedance, from: A, frequency: [0 Hz, 1 Hz], modulus: [1e8 Pa.s/m3, 1e8 Pa.s/m3], "
                  "phase: [0 rad, 3 rad]",
                  ": ", "phases lie between -pi/2 and pi/2"),
        in_line_5("TreeUpsideDown", "type: structured_tree, from: A, r_root: 1 mm, r_min: 2 mm", ": ",
                  "a tree needs r_min < r_root"),
        in_line_5("TreeOfAKilometre", "type: structured_tree, from: A, r_root: 1 km, r_min: 1 nm", ": ",
                  "look at the units of \"r_root\"")),
    name_of);

}  // namespace
}  // namespace ostium::test
