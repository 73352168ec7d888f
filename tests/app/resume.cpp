// A run that is stopped and resumed gives the same bytes as one that was not.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/checkpoint/hdf5_archive.hpp"
#include "core/error.hpp"
#include "program.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;

const char* channel = R"(vessel:
  dimension: 2
  outline: [[0 mm, 0 mm], [30 mm, 0 mm], [30 mm, 6 mm], [0 mm, 6 mm]]
  spacing: 0.6 mm
  openings:
    inlet: {edge: 3, profile: plug}
    outlet: {edge: 1}
fluid: {density: 1000 kg/m3, viscosity: 4 mPa.s}
network:
  blocks:
    pump: {type: flow_source, to: inlet, velocity: {fourier: {mean: 0.3, sin: [1]}, unit: m/s, period: 0.05 s}}
    bed: {type: windkessel, from: outlet, Rp: 1.5e5 Pa.s/m3, C: 2e-7 m3/Pa, Rd: 1.35e6 Pa.s/m3, Pd: 6000 Pa}
time: {period: 0.05 s, cycles: 1000}
output:
  every: 1 ms
  fields_every: 20 ms
  probes: {axis: {at: [10 mm, 3 mm]}, top: {at: [20 mm, 6 mm], on: wall}}
)";

const char* tube = R"(vessel:
  surface: tube.stl
  length_unit: mm
  spacing: 0.25 mm
  openings:
    inlet: {nearest: [0 mm, 0 mm, 0 mm]}
    outlet: {nearest: [0 mm, 0 mm, 4 mm]}
network:
  blocks:
    pump: {type: flow_source, to: inlet, flow: {fourier: {mean: 50, sin: [50]}, unit: mm3/s, period: 0.05 s}}
    bed: {type: windkessel, from: outlet, Rp: 1e9 Pa.s/m3, C: 1e-12 m3/Pa, Rd: 1e10 Pa.s/m3}
time: {period: 0.05 s, cycles: 1000}
output: {every: 1 ms, fields_every: 0 s, probes: {axis: {at: [0 mm, 0 mm, 2 mm]}}}
)";

const char* rcr = R"(network:
  blocks:
    heart: {type: flow_source, flow: {fourier: {mean: 5, sin: [2]}, unit: L/min, period: 0.8 s}, to: root}
    body:  {type: windkessel, from: root, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}
time: {period: 0.8 s, cycles: 100000}
)";

class Resume : public ProgramTest {
 protected:
  /// Starts the case, which would run for ever, and stops it a little later; returns what the terminal showed.
  std::string interrupt(const std::string& options = {}) const {
    const Outcome outcome = ostium("run case.yaml -q -o stopped " + options +
                                   " & pid=$!; for i in $(seq 600); do [ -e stopped/network.csv ] && break; "
                                   "kill -0 $pid || break; sleep 0.05; "
                                   "done; sleep 0.4; kill -TERM $pid; wait $pid; echo code $?");
    EXPECT_THAT(outcome.text, HasSubstr("code 130"));
    EXPECT_TRUE(exists("stopped/checkpoint.h5")) << outcome.text;
    EXPECT_EQ(summary("stopped")["status"], "interrupted");
    return outcome.text;
  }
  nlohmann::json summary(const std::string& results) const {
    return nlohmann::json::parse(content(results + "/summary.json"));
  }
  /// Sets the end shortly after the interruption: once in one go, once in two.
  void finish(double period, double longer) const {
    const double reached = summary("stopped")["time"]["reached_s"];
    const std::string end =
        fmt::format(" --set 'time={{period: {} s, end: {:.6f} s}}'", period, reached + longer);
    const Outcome whole = ostium("run case.yaml -q -o whole --threads 1" + end);
    const Outcome resumed = ostium("run case.yaml -q -o stopped --threads 2 --resume" + end);
    ASSERT_EQ(whole.code, 0) << whole.text;
    ASSERT_EQ(resumed.code, 0) << resumed.text;
    EXPECT_THAT(resumed.text, HasSubstr("the run goes on from"));
    EXPECT_FALSE(exists("stopped/checkpoint.h5"));
  }
  void expect_same_bytes(const std::vector<std::string>& files) const {
    for (const auto& file : files) {
      EXPECT_FALSE(content("whole/" + file).empty()) << file;
      EXPECT_TRUE(content("whole/" + file) == content("stopped/" + file)) << file;
    }
    const auto whole = summary("whole"), resumed = summary("stopped");
    EXPECT_EQ(whole["series"], resumed["series"]);
    EXPECT_EQ(whole["time"], resumed["time"]);
    EXPECT_EQ(resumed["status"], "finished");
  }
  std::string refused(const std::string& options = {}) const {
    const Outcome outcome = ostium("run case.yaml -q -o stopped --resume " + options);
    EXPECT_EQ(outcome.code, 2) << outcome.text;
    return outcome.text;
  }
};

TEST_F(Resume, ACoupledRunIn2dGoesOnWithTheSameBytes) {
  write("case.yaml", channel);
  EXPECT_THAT(interrupt("--threads 2"), HasSubstr("go on with: ostium run case.yaml -o stopped --resume"));
  finish(0.05, 0.06);  // the cycle that was interrupted ends after it
  expect_same_bytes({"ports.csv", "network.csv", "balance.csv", "wall.csv", "probes.csv", "fields/fluid.pvd",
                     "fields/fluid_00001.vtp", "fields/surface.pvd", "fields/cycles_wall.pvd",
                     "fields/cycles_surface.pvd"});
  std::vector<std::string> cycles;
  for (const auto& file : std::filesystem::directory_iterator(folder() / "whole/fields"))
    if (const auto name = file.path().filename().string(); name.starts_with("cycle_"))
      cycles.push_back("fields/" + name);
  EXPECT_GE(cycles.size(), 2u);
  expect_same_bytes(cycles);
  const auto whole = summary("whole"), resumed = summary("stopped");
  for (const char* fact :
       {"acoustic_steps", "exchanges", "step_bounds", "checks", "max_speed_m_s", "particles"})
    EXPECT_EQ(whole[fact], resumed[fact]) << fact;
  EXPECT_THAT(content("stopped/log.txt"), HasSubstr("interrupted at"));
  EXPECT_THAT(content("stopped/log.txt"), HasSubstr("the run goes on from"));
}

TEST_F(Resume, ACoupledRunIn3dGoesOnWithTheSameBytes) {
  ASSERT_EQ(ostium("geometry tube --radius '1 mm' --length '4 mm' -o tube.stl").code, 0);
  write("case.yaml", tube);
  interrupt("--threads 2");
  finish(0.05, 0.003);
  expect_same_bytes({"ports.csv", "network.csv", "balance.csv", "wall.csv", "probes.csv"});
}

TEST_F(Resume, AWallThatMovesGoesOnWithTheSameBytes) {
  const std::string spacing = "  spacing: 0.6 mm\n", yaml = channel;
  const auto at = yaml.find(spacing) + spacing.size();
  write("case.yaml", yaml.substr(0, at) +
                         "  wall: {model: shell, thickness: 0.6 mm, material: {E: 5 MPa, nu: 0.45}, "
                         "outside_pressure: 6 kPa, "
                         "support: {spring: 2e7 Pa/m, dashpot: 1e4 Pa.s/m}}\n" +
                         yaml.substr(at));
  interrupt("--threads 2");
  finish(0.05, 0.02);
  expect_same_bytes({"ports.csv", "network.csv", "balance.csv", "wall.csv", "probes.csv"});
}

TEST_F(Resume, ASolidWallGoesOnWithTheSameBytes) {
  const std::string spacing = "  spacing: 0.6 mm\n", yaml = channel;
  const auto at = yaml.find(spacing) + spacing.size();
  write("case.yaml", yaml.substr(0, at) +
                         "  wall: {model: solid, thickness: 1.2 mm, material: {E: 5 MPa, nu: 0.45}, "
                         "outside_pressure: 6 kPa}\n" +
                         yaml.substr(at));
  interrupt("--threads 2");
  finish(0.05, 0.02);
  expect_same_bytes({"ports.csv", "network.csv", "balance.csv", "wall.csv", "probes.csv"});
}

TEST_F(Resume, ANetworkAloneGoesOnWithTheSameBytes) {
  write("case.yaml", rcr);
  interrupt();
  finish(0.8, 20.003);
  expect_same_bytes({"network.csv"});
}

TEST_F(Resume, CheckpointsAreWrittenOnTheWay) {
  write("case.yaml", channel);
  const Outcome outcome = ostium(
      "run case.yaml -q -o stopped --set 'output.checkpoint_every=50 ms'"
      " & pid=$!; for i in $(seq 600); do [ -e stopped/checkpoint.h5 ] && break; sleep 0.05; "
      "done; sleep 0.2; kill -KILL $pid; wait $pid; echo code $?");
  EXPECT_THAT(outcome.text, HasSubstr("code 137"));
  ASSERT_TRUE(exists("stopped/checkpoint.h5"));
  write("stopped/summary.json", R"({"time": {"reached_s": 0.2}})");  // a killed run writes none
  finish(0.05, 0.1);
  expect_same_bytes({"ports.csv", "network.csv", "balance.csv", "wall.csv", "probes.csv"});
}

TEST_F(Resume, WhereThereIsNothingToResume) {
  write("case.yaml", rcr);
  EXPECT_THAT(
      refused(),
      HasSubstr("stopped: there is no checkpoint.h5 in this folder to resume from; name the folder of "
                "the interrupted run with -o, or start without --resume"));
  EXPECT_FALSE(exists("stopped"));
  ASSERT_EQ(ostium("run case.yaml -q -o stopped --set time.cycles=1").code, 0);
  EXPECT_THAT(refused(), HasSubstr("the run in this folder is finished, there is nothing to resume"));
  EXPECT_EQ(ostium("run case.yaml -o stopped --resume --force").code, 2);
}

TEST_F(Resume, OfAnotherCase) {
  write("case.yaml", channel);
  interrupt();
  EXPECT_THAT(
      refused("--set 'vessel.spacing=0.5 mm'"),
      HasSubstr(
          "checkpoint.h5: this checkpoint belongs to another case: it has `spacing: 0.0006 m` where the case "
          "has `spacing: 0.0005 m`"));
  EXPECT_THAT(refused("--set 'vessel.outline=[[0 mm, 0 mm], [31 mm, 0 mm], [31 mm, 6 mm], [0 mm, 6 mm]]'"),
              HasSubstr("belongs to another case: it has `geometry: 4 corners, hash"));
  EXPECT_THAT(refused("--set 'network.blocks.bed.Rp=1.6e5 Pa.s/m3'"), HasSubstr("belongs to another case"));
  write("case.yaml", rcr);
  EXPECT_THAT(refused(), HasSubstr("it has `vessel in 2D` where the case has `network`"));
}

TEST_F(Resume, WithAnotherProbe) {
  write("case.yaml", channel);
  interrupt();
  const std::string before = content("stopped/probes.csv");
  const double reached = summary("stopped")["time"]["reached_s"];
  const auto go_on = [&](const std::string& probes) {
    return ostium(
        fmt::format("run case.yaml -q -o stopped --resume --set 'time={{period: 0.05 s, end: {} s}}' "
                    "--set 'output.probes={}'",
                    reached + 0.01, probes));
  };
  const Outcome outcome = go_on("{jet: {at: [2 mm, 3 mm]}}");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  const std::string after = content("stopped/probes.csv");
  EXPECT_EQ(after.substr(0, before.size()), before);
  EXPECT_THAT(after.substr(before.size()),
              testing::AllOf(HasSubstr(",jet,"), testing::Not(HasSubstr("axis"))));
}

TEST_F(Resume, WithOtherSettings) {
  write("case.yaml", channel);
  interrupt();
  const double reached = summary("stopped")["time"]["reached_s"];
  const Outcome outcome =
      ostium(fmt::format("run case.yaml -q -o stopped --resume --set 'time={{period: 0.05 s, end: {} s}}' "
                         "--set numerics.acoustic_cfl=0.3 --set 'output.every=2 ms'",
                         reached + 0.01));
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("the run goes on with other settings than it had: "));
}

TEST_F(Resume, FromADamagedCheckpoint) {
  write("case.yaml", rcr);
  interrupt();
  const std::string good = content("stopped/checkpoint.h5"), rows = content("stopped/network.csv");
  write("stopped/checkpoint.h5", good.substr(0, good.size() / 2));
  EXPECT_THAT(
      refused(),
      HasSubstr("stopped/checkpoint.h5: this checkpoint is damaged or no checkpoint at all; start the "
                "run anew without --resume"));
  write("stopped/checkpoint.h5", good);
  write("stopped/network.csv", rows.substr(0, rows.size() / 2));
  EXPECT_THAT(refused(), HasSubstr("bytes, at the checkpoint it had"));
}

TEST_F(Resume, FromAnotherFormat) {
  write("case.yaml", rcr);
  interrupt();
  std::int64_t format = 99;
  std::string program = "9.9";
  app::Hdf5Writer writer(folder() / "stopped/checkpoint.h5");
  writer("format", format);
  writer("program", program);
  writer.finish();
  EXPECT_THAT(
      refused(),
      HasSubstr("this checkpoint has format 99 (ostium 9.9), this program reads format 4; resume with "
                "the program that wrote it"));
}

TEST_F(Resume, NumericsErrorsSaveTheLastSoundState) {
  write("case.yaml", channel);
  // sound for 0.3 s, then ten times faster than the sound speed chosen from the first period
  const std::string pump =
      " --set 'network.blocks.pump.velocity={times: [0, 0.3, 0.31, 1], values: [0.1, 0.1, 20, 20], unit: "
      "m/s, "
      "time_unit: s}' --set network.initial=rest --set 'time={period: 0.1 s, end: 0.5 s}'";
  const Outcome outcome = ostium("run case.yaml -q -o stopped" + pump);
  EXPECT_EQ(outcome.code, 3) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("numerics error: the flow has blown up"));
  EXPECT_THAT(outcome.text, HasSubstr("the last sound state, of 0."));
  EXPECT_THAT(outcome.text, HasSubstr("-o stopped --resume --set numerics.acoustic_cfl=0.3"));
  EXPECT_EQ(summary("stopped")["status"], "failed");
  const Outcome resumed = ostium("run case.yaml -q -o stopped --resume --set numerics.acoustic_cfl=0.3" +
                                 pump + " --set 'time={period: 0.1 s, end: 0.3 s}'");
  EXPECT_EQ(resumed.code, 0) << resumed.text;
  EXPECT_NEAR(summary("stopped")["time"]["reached_s"].get<double>(), 0.3, 1e-12);
}

}  // namespace
}  // namespace ostium::test
