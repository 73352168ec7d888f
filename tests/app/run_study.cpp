#include <nlohmann/json.hpp>

#include "core/csv.hpp"
#include "program.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;

const char* rcr = R"(title: Windkessel
network:
  blocks:
    heart: {type: flow_source, flow: {fourier: {mean: 5, sin: [2]}, unit: L/min, period: 0.8 s}, to: root}
    body:  {type: windkessel, from: root, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}
time: {period: 0.8 s, cycles: 3}
)";

class RunStudy : public ProgramTest {};

TEST_F(RunStudy, ResultsFolder) {
  write("rcr.yaml", rcr);
  const Outcome outcome = ostium("run rcr.yaml");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("results in results/rcr"));
  EXPECT_THAT(content("results/rcr/log.txt"), HasSubstr("p:root_Pa"));
  EXPECT_FALSE(exists("results/rcr/ports.csv"));
  const auto table = read_table(folder() / "results/rcr/network.csv");
  EXPECT_EQ(table.names[0], "time_s");
  EXPECT_EQ(table.lines.size(), 241u);
  EXPECT_DOUBLE_EQ(table.columns[0].back(), 2.4);
}

TEST_F(RunStudy, SummaryHoldsMeansOfThePeriodicState) {
  write("rcr.yaml", rcr);
  ASSERT_EQ(ostium("run rcr.yaml").code, 0);
  const auto summary = nlohmann::json::parse(content("results/rcr/summary.json"));
  EXPECT_EQ(summary["status"], "finished");
  EXPECT_EQ(summary["title"], "Windkessel");
  const double q = 5e-3 / 60, mean = q * (9.8e6 + 1.65e8);
  EXPECT_NEAR(summary["series"]["p:root_Pa"]["mean"].get<double>(), mean, 1e-3 * mean);
  EXPECT_NEAR(summary["series"]["q:heart_m3_s"]["mean"].get<double>(), q, 1e-6 * q);
  EXPECT_LT(summary["periodicity"]["change_between_last_cycles"].get<double>(), 1e-6);
}

TEST_F(RunStudy, EffectiveCaseGivesTheSameRun) {
  write("rcr.yaml", rcr);
  ASSERT_EQ(ostium("run rcr.yaml").code, 0);
  const Outcome again = ostium("run results/rcr/case.effective.yaml -o again");
  ASSERT_EQ(again.code, 0) << again.text;
  EXPECT_EQ(content("again/network.csv"), content("results/rcr/network.csv"));
  EXPECT_EQ(content("again/case.effective.yaml"), content("results/rcr/case.effective.yaml"));
}

TEST_F(RunStudy, FinishedResultsAreKeptUnlessForced) {
  write("rcr.yaml", rcr);
  ASSERT_EQ(ostium("run rcr.yaml").code, 0);
  write("results/rcr/notes.txt", "mine");
  const Outcome refused = ostium("run rcr.yaml");
  EXPECT_EQ(refused.code, 2);
  EXPECT_THAT(refused.text,
              HasSubstr("this folder holds the results of a finished run; choose another one with -o, or "
                        "replace them with --force"));
  EXPECT_EQ(ostium("run rcr.yaml --force --set time.cycles=1").code, 0);
  EXPECT_EQ(content("results/rcr/notes.txt"), "mine");
  EXPECT_EQ(read_table(folder() / "results/rcr/network.csv").columns[0].back(), 0.8);
}

TEST_F(RunStudy, NamesOfCases) {
  std::filesystem::create_directories(folder() / "windkessel");
  write("windkessel/case.yaml", rcr);
  ASSERT_EQ(ostium("run windkessel/case.yaml").code, 0);
  EXPECT_TRUE(exists("results/windkessel/summary.json"));
  write("blocked", "a file");
  EXPECT_THAT(ostium("run windkessel/case.yaml -o blocked").text,
              HasSubstr("the results need a folder, but this is a file"));
}

TEST_F(RunStudy, InterruptEndsCleanly) {
  write("rcr.yaml", rcr);
  const Outcome outcome = ostium(
      "run rcr.yaml --set time.cycles=20000 & pid=$!; "
      "for i in $(seq 100); do [ -e results/rcr/network.csv ] && break; sleep 0.05; done; "
      "sleep 0.2; kill -TERM $pid; wait $pid; echo code $?");
  EXPECT_THAT(outcome.text, HasSubstr("code 130"));
  EXPECT_THAT(outcome.text, HasSubstr("interrupted at"));
  EXPECT_EQ(nlohmann::json::parse(content("results/rcr/summary.json"))["status"], "interrupted");
  EXPECT_THAT(ostium("run rcr.yaml").text,
              HasSubstr("this folder holds a run that was not finished; go on with it with "
                        "--resume, replace it with --force"));
  EXPECT_EQ(ostium("run rcr.yaml --force").code, 0);
}

TEST_F(RunStudy, Check) {
  write("rcr.yaml", rcr);
  const Outcome outcome = ostium("check rcr.yaml");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_THAT(outcome.text, HasSubstr("windkessel       from root to ground"));
  EXPECT_THAT(outcome.text, HasSubstr("2.4 s, 3 periods of 0.8 s"));
  EXPECT_FALSE(exists("results"));
}

}  // namespace
}  // namespace ostium::test
