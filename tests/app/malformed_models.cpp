// Models of other programs: JSON of svZeroDSolver, YAML of openBF.
#include "malformed.hpp"

namespace ostium::test {
namespace {

const std::string rcr =
    R"({"simulation_parameters": {"number_of_cardiac_cycles": 2, "number_of_time_pts_per_cardiac_cycle": 11},
"boundary_conditions": [{"bc_name": "IN", "bc_type": "FLOW", "bc_values": {"Q": [0, 80, 0], "t": [0, 0.3, 0.8]}},
{"bc_name": "OUT", "bc_type": "RCR", "bc_values": {"Rp": 100, "C": 1e-4, "Rd": 1000, "Pd": 0}}],
"vessels": [{"vessel_id": 0, "vessel_name": "v0", "vessel_length": 1.0, "zero_d_element_type": "BloodVessel",
"zero_d_element_values": {"R_poiseuille": 100.0, "C": 1e-5}, "boundary_conditions": {"inlet": "IN", "outlet": "OUT"}}],
"junctions": []})";

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  return at == std::string::npos ? "the text has no " + what : text.replace(at, what.size(), by);
}

Malformed model(const std::string& name, const std::string& what, const std::string& by,
                const std::vector<std::string>& says) {
  std::vector<std::string> all{"model.json: "};
  all.insert(all.end(), says.begin(), says.end());
  return {name, replaced(rcr, what, by), all};
}
Malformed text(const std::string& name, const std::string& content, const std::string& says) {
  return {name, content, {"model.json: ", says}};
}

class MalformedModel : public Front, public testing::WithParamInterface<Malformed> {};
TEST_P(MalformedModel, IsRefused) {
  write_all("model.json", GetParam());
  expect_refusal({"import", "svzerod", path("model.json"), "-o", path("case.yaml")}, GetParam().says);
}

INSTANTIATE_TEST_SUITE_P(
    Json, MalformedModel,
    testing::Values(text("Empty", "", "this is no valid JSON: line 1, column 1"),
                    text("AList", "[]", "expected an object {..}"),
                    text("Deep", std::string(100000, '['), "nested 100000 deep, at most 64 is allowed"),
                    text("Cut", rcr.substr(0, rcr.size() - 3), "this is no valid JSON: line 6"),
                    model("NanToken", "0.3", "NaN", {"this is no valid JSON: line 2, column"}),
                    model("NumberOverflow", "\"Rd\": 1000", "\"Rd\": 1e400",
                          {"this is no valid JSON: ", "1e400"}),
                    model("NoUtf8", "v0", "v\xff", {"this is no valid JSON: line 4, column", "UTF-8"}),
                    model("KeyTwice", "\"Rp\": 100", "\"Rp\": 100, \"Rp\": 200",
                          {"boundary_conditions[1].bc_values.Rp: this key is given twice"}),
                    model("NameOfTwoLines", "v0", "v\\n0", {"is no name"})),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Models, MalformedModel,
    testing::Values(
        model("UnknownBoundary", "\"RCR\"", "\"RCX\"",
              {"boundary_conditions[1] (OUT).bc_type: ", "did you mean \"RCR\"?"}),
        model("MissingKey", "\"C\": 1e-4, ", "",
              {"boundary_conditions[1] (OUT).bc_values: the key \"C\" is missing"}),
        model("UnknownKey", "\"Pd\"", "\"Pdd\"",
              {"boundary_conditions[1] (OUT).bc_values.Pdd: ", "did you mean \"Pd\"?"}),
        model("WrongType", "\"Rp\": 100", "\"Rp\": \"high\"",
              {"boundary_conditions[1] (OUT).bc_values.Rp: expected a number, found the text \"high\""}),
        model("NegativeResistance", "\"Rd\": 1000", "\"Rd\": -1", {"bc_values.Rd: must be >= 0, found -1"}),
        model("ResistanceBeyondThisWorld", "\"Rd\": 1000", "\"Rd\": 1e200",
              {"OUT.R", "look at its exponent"}),
        model("UnknownBlock", "\"outlet\": \"OUT\"", "\"outlet\": \"OUTT\"",
              {"vessels[0] (v0).boundary_conditions.outlet: ", "did you mean \"OUT\"?"}),
        model("UnsortedTimes", "[0, 0.3, 0.8]", "[0, 0.9, 0.8]",
              {"boundary_conditions[0] (IN).bc_values.t: ", "times must"}),
        model("UnequalLists", "[0, 80, 0]", "[0, 80]",
              {"boundary_conditions[0] (IN).bc_values.Q: has 2 values for 3"}),
        model("EmptyLists", "[0, 80, 0], \"t\": [0, 0.3, 0.8]", "[], \"t\": []",
              {"bc_values.Q: has no values"}),
        model("PeriodOfNothing", "[0, 0.3, 0.8]", "[0, 1e-290, 1e-280]",
              {"bc_values.Q: the period of 1e-280 s"}),
        model("UnknownVessel", "\"junctions\": []",
              "\"junctions\": [{\"junction_name\": \"J\", \"junction_type\": \"NORMAL_JUNCTION\", "
              "\"inlet_vessels\": [0], "
              "\"outlet_vessels\": [7]}]",
              {"junctions[0] (J).outlet_vessels[0]: there is no vessel with the vessel_id 7"}),
        model("MisspeltSection", "\"vessels\"", "\"vesels\"",
              {"vesels: there is no such section; did you mean \"vessels\"?"}),
        model("NoParameters", "\"simulation_parameters\"", "\"_\"",
              {"the key \"simulation_parameters\" is missing"}),
        model("HalfACycle", "cycles\": 2", "cycles\": 2.5",
              {"number_of_cardiac_cycles: expected a whole number"}),
        model("MillionsOfPoints", "cycle\": 11", "cycle\": 900000000",
              {"must be at most 1000000, found 900000000"})),
    name_of);

const std::string network = R"(project_name: tree
inlet_file: in.dat
blood: {rho: 1060, mu: 4e-3}
network:
  - {label: a, sn: 1, tn: 2, L: 0.1, E: 4e5, R0: 1e-2, h0: 1e-3}
  - {label: b, sn: 2, tn: 3, L: 0.1, E: 4e5, Rp: 8e-3, Rd: 7e-3, R1: 1e7, R2: 1e8, Cc: 1e-9}
)";
const std::string inflow = "0 0\n0.1 1e-4\n0.3 2e-5\n0.8 0\n";

Malformed openbf(const std::string& name, const std::string& what, const std::string& by,
                 const std::vector<std::string>& says) {
  return {name, replaced(network, what, by), says, {{"in.dat", inflow}}};
}
Malformed inlet(const std::string& name, const std::string& what, const std::string& by,
                const std::vector<std::string>& says) {
  return {name, network, says, {{"in.dat", replaced(inflow, what, by)}}};
}

class MalformedOpenbf : public Front, public testing::WithParamInterface<Malformed> {};
TEST_P(MalformedOpenbf, IsRefused) {
  write_all("model.yaml", GetParam());
  expect_refusal({"import", "openbf", path("model.yaml"), "-o", path("case.yaml")}, GetParam().says);
}

INSTANTIATE_TEST_SUITE_P(
    Openbf, MalformedOpenbf,
    testing::Values(
        openbf("NegativeStiffness", "E: 4e5, R0", "E: -4e5, R0",
               {"model.yaml:5:", "network.1.E: ", "must be > 0"}),
        openbf("VesselToItself", "tn: 3", "tn: 2",
               {"model.yaml:6:", "network.2: the vessel begins and ends at the node 2"}),
        openbf("DensityWithAUnit", "1060", "1060 kg/m3", {"model.yaml:3:", "blood.rho: ", "wrong dimension"}),
        openbf("NoInlet", "sn: 1", "sn: 3", {"model.yaml:6:", "drop the one or the other"}),
        openbf("MissingInflow", "in.dat", "no.dat",
               {"model.yaml:2:1: inlet_file: ", "no.dat: there is no such file"}),
        inlet("InflowNotANumber", "1e-4", "nan",
              {"model.yaml:2:", "in.dat:2: the value nan is not a finite number"}),
        inlet("InflowBackInTime", "0.3", "0.05", {"model.yaml:2:", "in.dat:3: ", "times must increase"}),
        inlet("InflowOfAnOcean", "1e-4", "1e9", {"model.yaml:5:", "network.1: "})),
    name_of);

}  // namespace
}  // namespace ostium::test
