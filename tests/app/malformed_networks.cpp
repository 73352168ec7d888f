// What is joined wrongly, subnetworks, and the sections beside the network.
#include "malformed.hpp"

namespace ostium::test {
namespace {

class MalformedNetwork : public MalformedCase {};
TEST_P(MalformedNetwork, IsRefused) { refuse(); }

const std::string prescribed = "p: {type: pressure_source, to: A, pressure: 80 mmHg}";

INSTANTIATE_TEST_SUITE_P(
    Topology, MalformedNetwork,
    testing::Values(
        Malformed{"FloatingNode",
                  beside("x: {type: resistor, from: A, to: Z, R: 1e7 Pa.s/m3}"),
                  {"case.yaml:5:", "network.blocks.x: ", "the node \"Z\" has no other block than \"x\""}},
        Malformed{"SelfLoop",
                  beside("x: {type: resistor, from: A, to: A, R: 1e7 Pa.s/m3}"),
                  {"case.yaml:5:", "network.blocks.x: ", "begins and ends at the same node \"A\""}},
        Malformed{"MissingNode",
                  beside("x: {type: resistor, from: A, R: 1e7 Pa.s/m3}"),
                  {"case.yaml:5:", "network.blocks.x: ", "name the other one with `to`"}},
        Malformed{"DeadEnd",
                  network_of({source}),
                  {"case.yaml:3:", "network.blocks.q: ", "its flow has nowhere to go"}},
        Malformed{"TwoPressuresAtANode",
                  network_of({prescribed, "s: {type: pressure_source, to: A, pressure: 1 Pa}", bed}),
                  {"case.yaml:4:", "network.blocks.s: ", "prescribe the same pressure twice"}},
        Malformed{"RingOfPressures",
                  network_of({prescribed, "s: {type: pressure_source, from: A, to: B, pressure: 2 Pa}",
                              "t: {type: pressure_source, to: B, pressure: 3 Pa}"}),
                  {"case.yaml:5:", "network.blocks.t: ",
                   "\"p\", \"s\" and \"t\" prescribe the same pressure twice"}},
        Malformed{"CapacitorAtAPressure",
                  network_of({prescribed, "c: {type: capacitor, from: A, C: 1e-9 m3/Pa}"}),
                  {"case.yaml:4:", "network.blocks.c: ", "put a small resistor in series with one of them",
                   "`c_r: {type: resistor, from: c_r, to: .., R: 1e5 Pa.s/m3}`"}},
        Malformed{"CapacitorsInARing",
                  beside("c: {type: capacitor, from: A, C: 1e-9 m3/Pa}\n    d: {type: capacitor, from: A, C: "
                         "1e-9 m3/Pa}"),
                  {"case.yaml:6:", "network.blocks.d: ", "the blocks \"c\" and \"d\" form a loop"}},
        Malformed{"TwoSeriesOfOneName",
                  beside("x: {type: resistor, from: A, to: w.Pc, R: 1e7 Pa.s/m3}\n"
                         "    y: {type: resistor, from: w.Pc, ground: 0 Pa, R: 1e7 Pa.s/m3}"),
                  {"case.yaml:4:", "network.blocks.w: ", "two series p:w.Pc_Pa"}},
        Malformed{"BlocksAsAList",
                  "network:\n  blocks: [a, b]\ntime: {end: 1 s}\n",
                  {"case.yaml:2:3: network.blocks: ", "expected a mapping"}},
        Malformed{"NoBlocks",
                  "network:\n  blocks: {}\ntime: {end: 1 s}\n",
                  {"case.yaml:2:3: network.blocks: ", "at least one block"}}),
    name_of);

class MalformedRun : public Front {};

/// Only the search for the periodic state finds it.
TEST_F(MalformedRun, FilledForEver) {
  write("case.yaml", network_of({source, "c: {type: capacitor, from: A, C: 1e-9 m3/Pa}"}));
  expect_refusal({"run", path("case.yaml"), "-q", "-o", path("results")},
                 {"case.yaml:2:", "network.blocks: ", "no periodic state", "give it a way out"});
}

/// A use of the subnetwork `bed` in line 10, whose resistance stands in line 7.
Malformed subnetwork(const std::string& name, const std::string& R, const std::string& use,
                     const std::vector<std::string>& says) {
  return {name,
          "network:\n  subnetworks:\n    bed:\n      ports: [inlet]\n      parameters: {R: {unit: Pa.s/m3}}\n"
          "      blocks:\n        r: {type: resistor, from: inlet, ground: 0 Pa, R: " +
              R + "}\n  blocks:\n    " + source + "\n    b: {type: bed, " + use + "}\ntime: {end: 1 s}\n",
          says};
}

/// s16 holds s15 twice, which holds s27 twice ..
std::string doubling() {
  std::string text =
      "network:\n  subnetworks:\n    s0: {ports: [i], blocks: {r: {type: resistor, from: i, ground: 0 Pa, "
      "R: 1e8 Pa.s/m3}}}\n";
  for (int i = 1; i < 17; ++i)
    text += fmt::format(
        "    s{0}: {{ports: [i], blocks: {{a: {{type: s{1}, i: i}}, b: {{type: s{1}, i: i}}}}}}\n", i, i - 1);
  return text + "  blocks:\n    " + source + "\n    b: {type: s16, i: A}\ntime: {end: 1 s}\n";
}

const std::string in_use = "inlet: A, R: 1e8 Pa.s/m3";

INSTANTIATE_TEST_SUITE_P(
    Subnetworks, MalformedNetwork,
    testing::Values(
        subnetwork("UnknownParameter", "$Q", in_use,
                   {"case.yaml:7:", "bed.blocks.r.R: ", "no parameter \"Q\""}),
        subnetwork("SumOfDifferentThings", "$R + 1", in_use,
                   {"case.yaml:7:", "bed.blocks.r.R: ", "different things"}),
        subnetwork("DivisionByZero", "$R / 0", in_use,
                   {"case.yaml:7:", "network.blocks.b.r.R: ", "is not a finite number"}),
        subnetwork("BracketsWithoutEnd", std::string(100000, '(') + "$R", in_use,
                   {"case.yaml:7:", "bed.blocks.r.R: ", "cannot be read from its character"}),
        subnetwork("MinusesWithoutEnd", std::string(100000, '-') + "$R", in_use,
                   {"case.yaml:7:", "bed.blocks.r.R: ", "cannot be read from its character"}),
        subnetwork("MissingParameter", "$R", "inlet: A",
                   {"case.yaml:10:5: network.blocks.b: the key \"R\" is missing: a parameter without default "
                    "[Pa.s/m3]"}),
        subnetwork("MissingPort", "$R", "R: 1e8 Pa.s/m3",
                   {"case.yaml:10:5: network.blocks.b: the key \"inlet\" is missing"}),
        subnetwork("UnknownInnerBlock", "$R", in_use + ", x.R: 1 Pa.s/m3",
                   {"case.yaml:10:", "network.blocks.b.x.R: ", "has no block \"x\""}),
        Malformed{"DoublingWithoutEnd",
                  doubling(),
                  {"case.yaml:3:", "the subnetworks make more than 50000 blocks"}},
        Malformed{"HeartWithoutVeins",
                  beside("h: {type: heart_and_lungs, to: A}"),
                  {"case.yaml:5:", "network.blocks.h: ", "the key \"from\" is missing"}},
        Malformed{
            "HeartOfAMisspeltPeriod",
            network_of(
                {"h: {type: heart_and_lungs, from: RA, to: A, heart.perod: 1 s}",
                 "w: {type: windkessel, from: A, to: RA, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1e8 Pa.s/m3}"}),
            {"case.yaml:3:", "network.blocks.h.heart.perod: ", "did you mean \"period\"?"}}),
    name_of);

const std::string good = network_of({source, bed});

Malformed timed(const std::string& name, const std::string& time, const std::vector<std::string>& says) {
  std::string text = good.substr(0, good.find("time:"));
  return {name, text + "time: " + time + "\n", says};
}
Malformed section(const std::string& name, const std::string& text, const std::vector<std::string>& says) {
  return {name, good + text + "\n", says};
}
Malformed target(const std::string& name, const std::string& target, const std::string& parameter,
                 const std::vector<std::string>& says) {
  return section(name, "calibration: {targets: [{" + target + "}], parameters: [{" + parameter + "}]}", says);
}
const std::string wanted = "of: mean p:A, value: 90 mmHg, tolerance: 1 mmHg";
const std::string free_Rd = "name: w.Rd, low: 1e7 Pa.s/m3, high: 1e9 Pa.s/m3";

INSTANTIATE_TEST_SUITE_P(
    Sections, MalformedNetwork,
    testing::Values(timed("EndBeforeTheStart", "{end: -1 s}",
                          {"case.yaml:5:8: time.end: -1 s is not allowed"}),
                    timed("EndOfTheWorld", "{end: 1e20 s}", {"case.yaml:5:8: time.end: ", "<= 1000000000 s"}),
                    timed("EndAtOnce", "{end: 1e-20 s}", {"case.yaml:5:8: time.end: ", ">= 1e-06"}),
                    timed("MoreCyclesThanNumbers", "{period: 0.8 s, cycles: 99999999999}",
                          {"case.yaml:5:", "time.cycles: ", "<= 1000000"}),
                    timed("HalfACycle", "{period: 0.8 s, cycles: 1.5}",
                          {"case.yaml:5:", "time.cycles: expected a whole number"}),
                    timed("PeriodAsAList", "{period: [1 s], cycles: 1}",
                          {"case.yaml:5:", "time.period: ", "found a list"}),
                    timed("TimeAsAList", "[1]", {"case.yaml:5:1: time: expected a mapping"}),
                    section("NoTimeBetweenRows", "output: {every: 0 s}",
                            {"case.yaml:6:", "output.every: 0 s is not allowed"}),
                    section("UnknownOutput", "output: {evry: 1 s}",
                            {"case.yaml:6:", "output.evry: ", "did you mean \"every\"?"}),
                    section("SensitivityOfNothing", "sensitivities: {of: [], to: []}",
                            {"case.yaml:6:1: sensitivities: ", "at least one"}),
                    section("SensitivityOfAnUnknownSeries", "sensitivities: {of: [mean p:B], to: [w.Rd]}",
                            {"case.yaml:6:", "sensitivities.of: there is no series \"p:B\""}),
                    section("SensitivityToAnUnknownKey", "sensitivities: {of: [mean p:A], to: [w.Rx]}",
                            {"case.yaml:6:", "sensitivities.to: there is no parameter \"w.Rx\""}),
                    Malformed{"PeriodicWithoutPeriod",
                              "network:\n  initial: periodic\n" + good.substr(9, good.find("time:") - 9) +
                                  "time: {end: 1 s}\n",
                              {"case.yaml:2:3: network.initial: ", "needs \"time.period\""}}),
    name_of);

/// Only `check` and `calibrate` read this section.
class MalformedCalibration : public Front, public testing::WithParamInterface<Malformed> {};
TEST_P(MalformedCalibration, IsRefused) {
  write_all("case.yaml", GetParam());
  expect_refusal({"check", path("case.yaml")}, GetParam().says);
  expect_refusal({"calibrate", path("case.yaml"), "-o", path("results")}, GetParam().says);
}

INSTANTIATE_TEST_SUITE_P(
    Calibrations, MalformedCalibration,
    testing::Values(section("OfNothing", "calibration: {targets: [], parameters: []}",
                            {"case.yaml:6:1: calibration: ", "at least one of \"targets\""}),
                    target("OfAnUnknownSeries", "of: mean p:B, value: 90 mmHg, tolerance: 1 mmHg", free_Rd,
                           {"case.yaml:6:", "there is no series \"p:B\""}),
                    target("InAnotherUnit", "of: mean p:A, value: 90 mm, tolerance: 1 mmHg", free_Rd,
                           {"case.yaml:6:", "calibration.targets.1.value: ", "wrong dimension"}),
                    target("WithoutTolerance", "of: mean p:A, value: 90 mmHg, tolerance: 0 mmHg", free_Rd,
                           {"case.yaml:6:", "calibration.targets.1.tolerance: ", "must be > 0"}),
                    target("UpsideDown", wanted, "name: w.Rd, low: 1e9 Pa.s/m3, high: 1e7 Pa.s/m3",
                           {"case.yaml:6:", "calibration.parameters.1.low: ", "is not below \"high\""}),
                    target("LogarithmOfZero", wanted, "name: w.Rd, low: 0 Pa.s/m3, high: 1e7 Pa.s/m3",
                           {"case.yaml:6:", "calibration.parameters.1.low: ", "scale: linear"})),
    name_of);

}  // namespace
}  // namespace ostium::test
