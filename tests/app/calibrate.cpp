// `ostium calibrate`: cases with targets, and svZeroDSolver's own task.
#include <fstream>
#include <nlohmann/json.hpp>

#include "program.hpp"

namespace ostium::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* rcr = R"(network:
  blocks:
    in: {type: flow_source, to: A, flow: {fourier: {mean: 90, cos: [-60]}, unit: mL/s, period: 1 s}}
    bed: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 3e-9 m3/Pa, Rd: 4e8 Pa.s/m3}
time: {period: 1 s, cycles: 2}
output: {every: 10 ms}
calibration:
  targets:
    - {of: mean p:A, value: 93 mmHg, tolerance: 1 mmHg}
    - {of: pulse p:A, value: 40 mmHg, tolerance: 1 mmHg}
  parameters:
    - {name: bed.Rd, low: 1e7 Pa.s/m3, high: 1e10 Pa.s/m3}
    - {name: bed.C, low: 1e-10 m3/Pa, high: 1e-7 m3/Pa}
)";

class Calibrating : public ProgramTest {
 protected:
  static std::string with(const std::string& from, const std::string& to) {
    std::string text = rcr;
    text.replace(text.find(from), from.size(), to);
    return text;
  }
};

/// A vessel of R, L, S in front of C, and what a steady and a swinging flow make of it; p in dyn/cm2, q in cm3/s.
json observed_vessel() {
  const double R = 120, L = 2, S = 0.4, C = 1e-4;
  json model = {{"simulation_parameters", json::object()},
                {"boundary_conditions", json::array()},
                {"vessels",
                 {{{"vessel_id", 0},
                   {"vessel_name", "aorta"},
                   {"vessel_length", 10.0},
                   {"boundary_conditions", {{"inlet", "IN"}, {"outlet", "OUT"}}},
                   {"zero_d_element_type", "BloodVessel"},
                   {"zero_d_element_values", {{"R_poiseuille", 1.0}}}}}},
                {"junctions", json::array()}};
  model["boundary_conditions"].push_back(
      {{"bc_name", "IN"}, {"bc_type", "FLOW"}, {"bc_values", {{"Q", {1.0, 1.0}}, {"t", {0.0, 1.0}}}}});
  model["boundary_conditions"].push_back(
      {{"bc_name", "OUT"}, {"bc_type", "RESISTANCE"}, {"bc_values", {{"R", 100.0}, {"Pd", 0.0}}}});
  for (int k = 0; k < 40; ++k) {
    const double t = 0.025 * k, q = 80 + 60 * std::sin(6.3 * t), dq = 378 * std::cos(6.3 * t),
                 dp = 9000 * std::cos(6.3 * t + 1), p = 1e5 + 2000 * std::sin(9 * t);
    const double out = q - C * (dp - (R + 2 * S * q) * dq), dout = 100 * std::cos(5 * t);
    for (const auto& [name, value, rate] :
         {std::tuple("flow:IN:aorta", q, dq), std::tuple("pressure:IN:aorta", p, dp),
          std::tuple("flow:aorta:OUT", out, dout),
          std::tuple("pressure:aorta:OUT", p - (R + S * q) * q - L * dout, 0.0)})
      model["y"][name].push_back(value), model["dy"][name].push_back(rate);
  }
  return model;
}

TEST_F(Calibrating, AWindkesselMeetsItsTargets) {
  write("rcr.yaml", rcr);
  const Outcome outcome = ostium("calibrate rcr.yaml");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const json found = json::parse(content("calibration/rcr/summary.json"));
  EXPECT_EQ(found["stopped"], "met");
  EXPECT_NEAR(found["targets"][0]["after"], 93 * 133.322387415, 0.1);
  EXPECT_GT(found["targets"][0]["before"], 3e4);
  EXPECT_NEAR(found["parameters"][0]["after"], 93 * 133.322387415 / 90e-6 - 1e7, 1e4);
  EXPECT_EQ(found["singular_values"].size(), 2u);
  EXPECT_TRUE(exists("calibration/rcr/network_before.csv"));
  ASSERT_EQ(ostium("run calibration/rcr/calibrated.yaml -o results").code, 0);
  EXPECT_NEAR(json::parse(content("results/summary.json"))["series"]["p:A_Pa"]["mean"], 93 * 133.322387415,
              1);
  EXPECT_THAT(ostium("calibrate rcr.yaml").text, HasSubstr("replace them with --force"));
}

TEST_F(Calibrating, Refusals) {
  const std::tuple<std::string, std::string, std::string> all[] = {
      {"93 mmHg", "93 mL", "calibration.targets.1.value: the unit \"mL\" has the wrong dimension"},
      {"tolerance: 1 mmHg", "tolerance: 0 mmHg",
       "calibration.targets.1.tolerance: 0 mmHg is not allowed; it must be > 0"},
      {"mean p:A", "mean p:B", "p:A"},
      {"bed.C,", "bed.D,", "there is no parameter \"bed.D\""},
      {"high: 1e10 Pa.s/m3", "high: 1e8 Pa.s/m3", "bed.Rd starts at 4e+08 Pa.s/m3, outside its bounds"},
      {"low: 1e7 Pa.s/m3", "low: 0 Pa.s/m3", "0 Pa.s/m3 is not > 0, which a logarithmic scale needs"},
      {"    - {name: bed.Rd", "    - {nam: bed.Rd", "did you mean \"name\"?"},
  };
  for (const auto& [from, to, sentence] : all) {
    write("rcr.yaml", with(from, to));
    const Outcome outcome = ostium("calibrate rcr.yaml");
    EXPECT_EQ(outcome.code, 2) << sentence;
    EXPECT_THAT(outcome.text, HasSubstr(sentence));
    EXPECT_FALSE(exists("calibration"));
  }
}

TEST_F(Calibrating, AVesselFromWhatWasObserved) {
  write("vessel.json", observed_vessel().dump());
  const Outcome outcome = ostium("calibrate vessel.json -o fit.json");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const json fit = json::parse(content("fit.json"));
  EXPECT_FALSE(fit.contains("y"));
  const auto values = fit["vessels"][0]["zero_d_element_values"];
  EXPECT_NEAR(values["R_poiseuille"], 120, 1e-6);
  EXPECT_NEAR(values["L"], 2, 1e-8);
  EXPECT_NEAR(values["C"], 1e-4, 1e-10);
  EXPECT_NEAR(values["stenosis_coefficient"], 0.4, 1e-8);
}

TEST_F(Calibrating, RefusedModels) {
  const auto refused = [&](const json& model, const std::string& sentence) {
    write("vessel.json", model.dump());
    const Outcome outcome = ostium("calibrate vessel.json -o fit.json");
    EXPECT_EQ(outcome.code, 2) << sentence;
    EXPECT_THAT(outcome.text, HasSubstr(sentence));
    EXPECT_FALSE(exists("fit.json"));
  };
  json model = observed_vessel();
  model.erase("y"), model.erase("dy");
  refused(model, "holds no observations to fit");
  model = observed_vessel(), model["y"].erase("flow:aorta:OUT");
  refused(model, "flow:aorta:OUT");
  model = observed_vessel(), model["dy"]["flow:aorta:OUT"].erase(3);
  refused(model, "has 39 values where the first series of \"y\" has 40");
  model = observed_vessel(), model["y"]["flow:aorta:OUT"][3] = "much";
  refused(model, "expected a number");
  write("vessel.json", "{\"y\": ");
  EXPECT_EQ(ostium("calibrate vessel.json -o fit.json").code, 2);
}

/// The optimum which that program's own optimiser found for a patient's aorta with eight branches (reference data needed).
TEST_F(Calibrating, TheOptimumOfAPatientsAorta) {
  const auto folder = std::filesystem::path(OSTIUM_DATA_DIR) / "svzerod-cases/calibration";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "needs the reference data at " << folder;
  ASSERT_EQ(
      ostium("calibrate '" + (folder / "0104_0001_calibrate_from_0d.json").string() + "' -o fit.json").code,
      0);
  std::ifstream stream(folder / "0104_0001_optimal_from_0d.json");
  const json fit = json::parse(content("fit.json")), optimum = json::parse(stream);
  ASSERT_EQ(fit["vessels"].size(), optimum["vessels"].size());
  for (std::size_t k = 0; k < fit["vessels"].size(); ++k) {
    const auto &found = fit["vessels"][k]["zero_d_element_values"],
               &best = optimum["vessels"][k]["zero_d_element_values"];
    for (const char* key : {"R_poiseuille", "C", "L", "stenosis_coefficient"}) {
      const double x = best.value(key, 0.0);
      EXPECT_NEAR(found.value(key, 0.0), x, 1e-6 * std::abs(x) + 1e-10)
          << fit["vessels"][k]["vessel_name"] << " " << key;
    }
  }
}

}  // namespace
}  // namespace ostium::test
