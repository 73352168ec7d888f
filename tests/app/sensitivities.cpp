// The periodic state and the sensitivities as the user of a case sees them.
#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "program.hpp"

namespace ostium::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string rcr = R"(network:
  blocks:
    heart: {type: flow_source, flow: {fourier: {mean: 5, sin: [2]}, unit: L/min, period: 0.8 s}, to: root}
    body:  {type: windkessel, from: root, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}
time: {period: 0.8 s, cycles: 1}
sensitivities:
  of: [mean p:root, pulse p:root]
  to: [body.Rd, body.C]
)";

class SensitivityRuns : public ProgramTest {
 protected:
  json summary() const { return json::parse(content("results/rcr/summary.json")); }
  std::string with(const std::string& from, const std::string& to) const {
    std::string text = rcr;
    return text.replace(text.find(from), from.size(), to);
  }
};

TEST_F(SensitivityRuns, TableAndSummary) {
  write("rcr.yaml", rcr);
  const Outcome outcome = ostium("run rcr.yaml");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("4 sensitivities in results/rcr/sensitivities.csv"));
  const auto mean = summary()["sensitivities"][0];
  const double q = 5e-3 / 60;
  EXPECT_EQ(mean["index"], "mean p:root");
  EXPECT_NEAR(mean["value"].get<double>(), q * 1.748e8, 1e-6 * q * 1.748e8);
  EXPECT_NEAR(mean["to"]["body.Rd"]["derivative"].get<double>(), q, 1e-5 * q);
  EXPECT_NEAR(mean["to"]["body.C"]["relative"].get<double>(), 0, 1e-5);
  EXPECT_LT(summary()["sensitivities"][1]["to"]["body.C"]["relative"].get<double>(), -0.1);
  EXPECT_THAT(content("results/rcr/sensitivities.csv"),
              HasSubstr("index,unit,value,parameter,parameter_unit,parameter_value,derivative,relative\nmean "
                        "p:root,Pa,"));
}

TEST_F(SensitivityRuns, PeriodicStateIsAccountedFor) {
  write("rcr.yaml", rcr);
  const Outcome outcome = ostium("run rcr.yaml");
  EXPECT_THAT(outcome.text, HasSubstr("periodic state after 2 integrated cycles (exact)"));
  const auto state = summary()["periodic_state"];
  EXPECT_EQ(state["cycle_integrations"], 2);
  EXPECT_LT(std::abs(state["residuals"]["p:body.Pc_Pa"]["relative"].get<double>()), 1e-6);
  EXPECT_EQ(ostium("run rcr.yaml --force --set network.periodic=false").code, 0);
  EXPECT_FALSE(summary().contains("periodic_state"));
}

TEST_F(SensitivityRuns, Refusals) {
  const std::tuple<std::string, std::string, std::string> all[] = {
      {"body.C]", "body.D]", "rcr.yaml:6:1: sensitivities.to: there is no parameter \"body.D\""},
      {"pulse p:root", "puls p:root",
       "rcr.yaml:6:1: sensitivities.of: there is no index \"puls\"; did you mean \"pulse\"?"},
      {"network:\n", "network:\n  initial: rest\n  periodic: true\n",
       "give either \"initial\" or \"periodic\", not both: they say the same"},
  };
  for (const auto& [from, to, sentence] : all) {
    write("rcr.yaml", with(from, to));
    for (const char* command : {"run", "check"}) {
      const Outcome outcome = ostium(std::string(command) + " rcr.yaml");
      EXPECT_EQ(outcome.code, 2) << sentence;
      EXPECT_THAT(outcome.text, HasSubstr(sentence));
    }
    EXPECT_FALSE(exists("results"));
  }
}

/// A model made elsewhere: heart, two coronary beds and lungs in a closed loop (reference data needed).
TEST_F(SensitivityRuns, ClosedLoopHeartWithCoronariesInFourCycles) {
  const std::filesystem::path model = std::filesystem::path(OSTIUM_DATA_DIR) /
                                      "svzerod-cases/cases/closedLoopHeart_withCoronaries__variant.json";
  if (!std::filesystem::exists(model)) GTEST_SKIP() << "needs the reference data at " << model;
  ASSERT_EQ(ostium("import svzerod '" + model.string() + "' -o rcr.yaml").code, 0);
  const Outcome outcome = ostium("run rcr.yaml --set network.initial=periodic --set time.cycles=2");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_LE(summary()["periodic_state"]["cycle_integrations"], 4);
  EXPECT_EQ(summary()["periodic_state"]["conserved_quantities"], 1);
  EXPECT_LT(summary()["periodic_state"]["change_per_cycle"], 1e-6);
  EXPECT_LT(summary()["periodicity"]["change_between_last_cycles"], 1e-6);
}

}  // namespace
}  // namespace ostium::test
