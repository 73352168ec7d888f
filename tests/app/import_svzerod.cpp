// Models of svZeroDSolver: exact solutions through import and run, names that map back, what is refused.
#include <cmath>

#include "svzerod_rows.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;

const std::string model = R"({
"simulation_parameters": {"number_of_cardiac_cycles": 3, "number_of_time_pts_per_cardiac_cycle": 11},
"boundary_conditions": [
  {"bc_name": "IN", "bc_type": "FLOW", "bc_values": {"Q": [5.0, 5.0], "t": [0.0, 1.0]}},
  {"bc_name": "OUT", "bc_type": "RCR", "bc_values": {"Rp": 100.0, "C": 1e-4, "Rd": 1000.0, "Pd": 50.0}}],
"vessels": [{"boundary_conditions": {"inlet": "IN", "outlet": "OUT"}, "vessel_id": 0, "vessel_name": "aorta",
  "zero_d_element_type": "BloodVessel", "zero_d_element_values": {"R_poiseuille": 10.0, "_comment": "short"}}]
})";

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return at == std::string::npos ? text : text.replace(at, what.size(), with);
}

class ImportSvzerod : public SvzerodTest {
 protected:
  SvzerodRows rows_of(const std::string& json, const std::string& options = "--units cgs") {
    return import_and_run(write("model.json", json), options);
  }
};

TEST_F(ImportSvzerod, SteadyFlowKeepsNamesAndUnits) {
  for (const char* units : {"cgs", "mmHg", "SI"}) {
    SCOPED_TRACE(units);
    auto rows = rows_of(model, std::string("--units ") + units);
    ASSERT_EQ(rows.size(), 5u) << refusal;
    EXPECT_NEAR(rows["flow:IN:aorta"].at(0.5), 5, 1e-9);
    EXPECT_NEAR(rows["pressure_c:OUT"].at(0.5), 5050, 1e-6);
    EXPECT_NEAR(rows["pressure:aorta:OUT"].at(0.5), 5550, 1e-6);
    EXPECT_NEAR(rows["pressure:IN:aorta"].at(0), 5600, 1e-6);
    EXPECT_EQ(rows["flow:aorta:OUT"].time.size(), 11u);
    EXPECT_NEAR(rows["flow:aorta:OUT"].time.back(), 1, 1e-12);
  }
}

/// Without the steady stage the Windkessel starts empty: C dPc/dt = Q - (Pc - Pd)/Rd.
TEST_F(ImportSvzerod, StartsWhereTheFileSays) {
  const auto json =
      replaced(replaced(model, "\"number_of_cardiac_cycles\": 3",
                        "\"number_of_cardiac_cycles\": 1, \"steady_initial\": false"),
               "\"vessels\"", "\"initial_condition\": {\"pressure_c:OUT\": 800.0},\n\"vessels\"");
  auto rows = rows_of(json);
  ASSERT_FALSE(rows.empty()) << refusal;
  for (double t : {0.1, 0.3, 1.0})
    EXPECT_NEAR(rows["pressure_c:OUT"].at(t), 5050 + (800 - 5050) * std::exp(-t / 0.1), 1e-4);
  EXPECT_EQ(rows["pressure_c:OUT"].at(0), 800) << "the first row is the start as given";
  EXPECT_EQ(rows["flow:IN:aorta"].at(0), 0) << "the first row is the start as given";
}

/// A compliance on a prescribed pressure takes C dP/dt; at a kink the rate before it.
TEST_F(ImportSvzerod, ComplianceOnAPressureSource) {
  auto rows = rows_of(
      R"({"simulation_parameters": {"number_of_cardiac_cycles": 2, "number_of_time_pts_per_cardiac_cycle": 11},
"boundary_conditions": [{"bc_name": "IN", "bc_type": "PRESSURE", "bc_values": {"P": [10, 11, 10], "t": [0, 0.5, 1]}},
  {"bc_name": "OUT", "bc_type": "FLOW", "bc_values": {"Q": [1], "t": [0]}}],
"vessels": [{"boundary_conditions": {"inlet": "IN", "outlet": "OUT"}, "vessel_id": 3, "vessel_name": "v",
  "zero_d_element_type": "BloodVesselCRL", "zero_d_element_values": {"R_poiseuille": 4.0, "C": 2.0}}]})");
  ASSERT_FALSE(rows.empty()) << refusal;
  EXPECT_NEAR(rows["flow:IN:v"].at(0.3), 1 + 2 * 2, 1e-6);
  EXPECT_NEAR(rows["flow:IN:v"].at(0.5), 1 + 2 * 2, 1e-6);
  EXPECT_NEAR(rows["flow:IN:v"].at(0.8), 1 - 2 * 2, 1e-6);
  EXPECT_NEAR(rows["pressure:v:OUT"].at(0.3), 10.6 - 4, 1e-6);
}

/// An inertance in series with a prescribed flow takes L dQ/dt.
TEST_F(ImportSvzerod, InertanceBehindAFlowSource) {
  auto json = replaced(model, "\"Q\": [5.0, 5.0], \"t\": [0.0, 1.0]",
                       "\"Q\": [5.0, 6.0, 5.0], \"t\": [0.0, 0.5, 1.0]");
  json = replaced(json, "\"R_poiseuille\": 10.0", "\"R_poiseuille\": 10.0, \"L\": 3.0");
  json = replaced(json, R"("RCR", "bc_values": {"Rp": 100.0, "C": 1e-4, "Rd": 1000.0, "Pd": 50.0})",
                  R"("RESISTANCE", "bc_values": {"R": 100.0, "Pd": 50.0})");
  auto rows = rows_of(json);
  ASSERT_FALSE(rows.empty()) << refusal;
  EXPECT_NEAR(rows["pressure:IN:aorta"].at(0.3), 50 + 5.6 * 110 + 3 * 2, 1e-5);
  EXPECT_NEAR(rows["pressure:IN:aorta"].at(0.8), 50 + 5.4 * 110 - 3 * 2, 1e-5);
  EXPECT_NEAR(rows["pressure:aorta:OUT"].at(0.8), 50 + 5.4 * 100, 1e-5);
}

/// Two compliances on one node: (C1 + C2) dp/dt = Q - p/R, and the flow between them is Q - C1 dp/dt.
TEST_F(ImportSvzerod, CompliancesOnOneNode) {
  auto rows = rows_of(
      R"({"simulation_parameters": {"number_of_cardiac_cycles": 1, "number_of_time_pts_per_cardiac_cycle": 21, "steady_initial": false},
"boundary_conditions": [{"bc_name": "IN", "bc_type": "FLOW", "bc_values": {"Q": [2, 2], "t": [0, 1]}},
  {"bc_name": "OUT", "bc_type": "RESISTANCE", "bc_values": {"R": 300, "Pd": 0}}],
"junctions": [{"junction_name": "J", "junction_type": "NORMAL_JUNCTION", "inlet_vessels": [0], "outlet_vessels": [1]}],
"vessels": [{"boundary_conditions": {"inlet": "IN"}, "vessel_id": 0, "vessel_name": "a", "zero_d_element_type": "BloodVessel",
   "zero_d_element_values": {"R_poiseuille": 50, "C": 1e-3}},
  {"boundary_conditions": {"outlet": "OUT"}, "vessel_id": 1, "vessel_name": "b", "zero_d_element_type": "BloodVesselCRL",
   "zero_d_element_values": {"R_poiseuille": 200, "C": 3e-3}}]})");
  ASSERT_FALSE(rows.empty()) << refusal;
  const double R = 500, C = 4e-3, Q = 2;
  for (double t : {0.1, 0.5, 1.0}) {
    const double e = std::exp(-t / (R * C)), p = Q * R * (1 - e), rate = Q / C * e;
    EXPECT_NEAR(rows["pressure:a:J"].at(t), p, 1e-6 * Q * R);
    EXPECT_NEAR(rows["flow:a:J"].at(t), Q - 1e-3 * rate, 1e-6);
    EXPECT_NEAR(rows["flow:J:b"].at(t), Q - 1e-3 * rate, 1e-6);
    EXPECT_NEAR(rows["flow:b:OUT"].at(t), p / R, 1e-6);
  }
}

TEST_F(ImportSvzerod, Check) {
  write("model.json", replaced(model, "11}", "11, \"rho_infty\": 0.5}"));
  const Outcome outcome = ostium("import svzerod model.json --check");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("3 blocks"));
  EXPECT_THAT(outcome.text, HasSubstr("not carried over: rho_infty"));
  EXPECT_FALSE(exists("model.yaml"));
}

TEST_F(ImportSvzerod, KeepsAnExistingCase) {
  write("model.json", model);
  EXPECT_EQ(ostium("import svzerod model.json").code, 0);
  EXPECT_TRUE(exists("model.yaml"));
  const Outcome again = ostium("import svzerod model.json");
  EXPECT_EQ(again.code, 2);
  EXPECT_THAT(again.text,
              HasSubstr("this file exists; choose another one with -o, or replace it with --force"));
}

struct Refusal {
  const char *what, *with, *text;
};

class ImportSvzerodErrors : public ImportSvzerod, public testing::WithParamInterface<Refusal> {};

TEST_P(ImportSvzerodErrors, NamePathAndRemedy) {
  write("model.json", replaced(model, GetParam().what, GetParam().with));
  const Outcome outcome = ostium("import svzerod model.json -o case.yaml");
  EXPECT_EQ(outcome.code, 2) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("error: model.json: "));
  EXPECT_THAT(outcome.text, HasSubstr(GetParam().text));
  EXPECT_FALSE(exists("case.yaml"));
}

INSTANTIATE_TEST_SUITE_P(
    Table, ImportSvzerodErrors,
    testing::Values(
        Refusal{"{\"number", "{number", "this is no valid JSON: line 2, column"},
        Refusal{"\"vessels\": [", "\"vessels\": [], \"vessels\": [", "vessels: this key is given twice"},
        Refusal{"\"vessels\": [", "\"vessels\": 3, \"x\": [",
                "vessels: expected a list [..], found the number 3"},
        Refusal{"\"simulation_parameters\"", "\"simulation_parameter\"",
                "simulation_parameter: there is no such section; did you mean \"simulation_parameters\"?"},
        Refusal{"\"number_of_cardiac_cycles\": 3", "\"number_of_cardiac_cycles\": 0",
                "simulation_parameters.number_of_cardiac_cycles: must be at least 1, found 0"},
        Refusal{"\"number_of_cardiac_cycles\": 3", "\"number_of_cardiac_cycles\": 2.5",
                "expected a whole number, found the number 2.5"},
        Refusal{"cycle\": 11", "cycle\": 1",
                "number_of_time_pts_per_cardiac_cycle: must be at least 2, found 1"},
        Refusal{"cycle\": 11", "cycle\": 11, \"cardiac_period\": 0.9",
                "the period is 0.9 here and 1 at boundary_conditions[0] (IN).bc_values.Q"},
        Refusal{"cycle\": 11", "cycle\": 11, \"coupled_simulation\": true", "one half of a coupled run"},
        Refusal{"cycle\": 11", "cycle\": 11, \"steady_initial\": 1",
                "expected true or false, found the number 1"},
        Refusal{
            "\"FLOW\"", "\"FLOWS\"",
            "boundary_conditions[0] (IN).bc_type: there is no type \"FLOWS\" here; did you mean \"FLOW\"?"},
        Refusal{"[5.0, 5.0]", "[5.0]", "has 1 values for 2 times in \"t\""},
        Refusal{"[0.0, 1.0]", "[0.5, 1.0]",
                "bc_values.t: begins at 0.5; the times of a series must begin at 0"},
        Refusal{"[5.0, 5.0], \"t\": [0.0, 1.0]", "[5.0, 5.0, 5.0], \"t\": [0.0, 1.0, 0.5]",
                "goes back from 1 to 0.5 at item 2"},
        Refusal{"[0.0, 1.0]", "[0.0, 0.0]", "spans no time"},
        Refusal{"[5.0, 5.0]", "[5.0, \"x\"]", "bc_values.Q[1]: expected a number, found the text \"x\""},
        Refusal{"[5.0, 5.0]", "[5.0, null]", "bc_values.Q[1]: expected a number, found null"},
        Refusal{"\"Rp\": 100.0", "\"Rq\": 100.0",
                "boundary_conditions[1] (OUT).bc_values.Rq: there is no such key; did you mean \"R"},
        Refusal{"\"Rp\": 100.0, ", "", "boundary_conditions[1] (OUT).bc_values: the key \"Rp\" is missing"},
        Refusal{"\"C\": 1e-4", "\"C\": -1e-4",
                "boundary_conditions[1] (OUT).bc_values.C: must be >= 0, found -0.0001"},
        Refusal{"\"bc_name\": \"OUT\"", "\"bc_name\": \"IN\"",
                "the name \"IN\" is taken by boundary_conditions[0] (IN)"},
        Refusal{"\"outlet\": \"OUT\"", "\"outlet\": \"OUTT\"",
                "vessels[0] (aorta).boundary_conditions.outlet: there is no block \"OUTT\"; did you mean "
                "\"OUT\"?"},
        Refusal{", \"outlet\": \"OUT\"", "",
                "nothing is joined to the outlet of \"aorta\"; it needs exactly one block there"},
        Refusal{"\"outlet\": \"OUT\"", "\"outlets\": \"OUT\"",
                "outlets: there is no such key; did you mean \"outlet\"?"},
        Refusal{"\"inlet\": \"IN\", \"outlet\": \"OUT\"", "\"inlet\": \"OUT\", \"outlet\": \"IN\"",
                "a RCR stands at the outlet of a vessel"},
        Refusal{"\"vessels\"",
                "\"junctions\": [{\"junction_name\": \"J\", \"junction_type\": \"NORMAL_JUNCTION\"}], "
                "\"vessels\"",
                "junctions[0] (J): a junction needs \"inlet_vessels\""},
        Refusal{"\"vessels\"",
                "\"valves\": [{\"type\": \"ValveTanh\", \"name\": \"V\", \"params\": {\"upstream_block\": "
                "\"aorta\"}}], \"vessels\"",
                "valves[0] (V).params: the key \"downstream_block\" is missing"},
        Refusal{"\"R_poiseuille\": 10.0", "\"R_poiseuille\": 10.0, \"C\": -1.0",
                "zero_d_element_values.C: must be >= 0, found -1"}));

/// A compliance of 1e-15 cm^5/dyn beside an inertance of 1 swings five million times a second.
TEST_F(ImportSvzerod, SteadyStageThatDoesNotEnd) {
  const auto stiff = replaced(
      replaced(model, "\"R_poiseuille\": 10.0",
               "\"R_poiseuille\": 100.0, \"C\": 1e-15, \"L\": 1.0, \"stenosis_coefficient\": 1.001"),
      "\"vessels\"", "\"initial_condition\": {\"pressure_all\": 625940.0, \"flow_all\": 80},\n\"vessels\"");
  write("model.json", stiff);
  const Outcome outcome = ostium("import svzerod model.json --units cgs");
  EXPECT_EQ(outcome.code, 2) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("error: model.json: simulation_parameters: the steady stage of 3.1 s"));
  EXPECT_THAT(outcome.text, HasSubstr("look for a C or L that is off by orders of magnitude"));
  write("model.json", replaced(stiff, "cycle\": 11", "cycle\": 11, \"steady_initial\": false"));
  EXPECT_EQ(ostium("import svzerod model.json --units cgs").code, 0);
}

TEST_F(ImportSvzerod, UnknownUnits) {
  write("model.json", model);
  EXPECT_THAT(ostium("import svzerod model.json --units cgss").text,
              HasSubstr("--units cgss: there is no such system of units; did you mean \"cgs\"?"));
  EXPECT_THAT(ostium("import svzerod none.json").text, HasSubstr("none.json: there is no such file"));
}

}  // namespace
}  // namespace ostium::test
