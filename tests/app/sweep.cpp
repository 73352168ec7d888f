// `ostium sweep`: tables, statistics, what interruptions and processes leave unchanged.
#include <hdf5.h>

#include <cmath>

#include "sweeping.hpp"

namespace ostium::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST_F(Sweeping, ATableWithUnits) {
  write("case.yaml", rcr);
  const Outcome outcome = ostium("sweep case.yaml -o swept");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("50 samples of 2 parameters, 2 results"));
  const auto rows = lines("swept/sweep.csv");
  ASSERT_EQ(rows.size(), 51u);
  EXPECT_EQ(rows[0], "sample,bed.Rd [Pa.s/m3],bed.C [m3/Pa],mean p:A [Pa],pulse p:A [Pa],status");
  for (std::size_t i = 0; i < 50; ++i) {
    const auto row = cells(rows[i + 1]);
    ASSERT_EQ(row.size(), 6u);
    EXPECT_EQ(row[0], std::to_string(i));
    EXPECT_EQ(row[5], "ok");
    const double mean = q0 * (Rp + std::stod(row[1]));
    EXPECT_NEAR(std::stod(row[3]), mean, 1e-9 * mean);
  }
  const json s = summary("swept");
  EXPECT_EQ(s["status"], "finished");
  EXPECT_EQ(s["samples"]["done"], 50);
  EXPECT_EQ(s["samples"]["design"], "latin_hypercube");
  const double low = 100 * 133322.387415, middle = q0 * (Rp + (low + 4e8) / 2);
  EXPECT_NEAR(s["results"][0]["mean"], middle, 2e-2 * middle);
  EXPECT_FALSE(exists("swept/sobol.csv"));
  EXPECT_FALSE(exists("swept/checkpoint.h5"));
  EXPECT_THAT(content("swept/case.effective.yaml"), HasSubstr("sample: latin_hypercube"));
  EXPECT_THAT(ostium("sweep case.yaml -o swept").text, HasSubstr("replace them with --force"));
  ASSERT_EQ(ostium("sweep swept/case.effective.yaml -q -o again").code, 0);
  EXPECT_EQ(content("again/sweep.csv"), content("swept/sweep.csv"));
}

TEST_F(Sweeping, SameBytesForAnyThreads) {
  write("case.yaml", rcr);
  ASSERT_EQ(ostium("sweep case.yaml -q -o one --threads 1").code, 0);
  ASSERT_EQ(ostium("sweep case.yaml -q -o four --threads 4").code, 0);
  EXPECT_EQ(content("one/sweep.csv"), content("four/sweep.csv"));
  ASSERT_EQ(ostium("sweep case.yaml -q -o other --set sweep.seed=2").code, 0);
  EXPECT_NE(content("one/sweep.csv"), content("other/sweep.csv"));
}

TEST_F(Sweeping, AGrid) {
  write("case.yaml", rcr);
  const std::string grid =
      " --set 'sweep={sample: grid, results: [mean p:A], parameters: [{name: bed.Rd, values: [1e8 Pa.s/m3, "
      "200 "
      "Pa.s/mL]}, {name: bed.C, low: 1e-9 m3/Pa, high: 1e-7 m3/Pa, count: 3, scale: log}]}'";
  const Outcome outcome = ostium("sweep case.yaml -q -o swept" + grid);
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto rows = lines("swept/sweep.csv");
  ASSERT_EQ(rows.size(), 7u);
  EXPECT_THAT(rows[1], testing::StartsWith("0,100000000,1e-09,"));
  EXPECT_NEAR(std::stod(cells(rows[5])[2]), 1e-8, 1e-22);
  EXPECT_NEAR(std::stod(cells(rows[6])[1]), 2e8, 1e-6);
  EXPECT_EQ(cells(rows[6])[2], "1e-07");
}

/// The mean is q0 (Rp + Rd): its variance is shared as that of the two resistances.
TEST_F(Sweeping, SobolIndices) {
  write("case.yaml", rcr);
  const Outcome outcome = ostium(
      "sweep case.yaml -q -o swept --set 'sweep={sample: saltelli, count: 200, results: [mean p:A], "
      "parameters: "
      "[{name: bed.Rd, low: 1e8 Pa.s/m3, high: 4e8 Pa.s/m3}, {name: bed.Rp, low: 1e7 Pa.s/m3, high: 1.1e8 "
      "Pa.s/m3}]}'");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto rows = lines("swept/sobol.csv");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], "result,parameter,first_order,first_order_half_width,total,total_half_width");
  for (const auto& [row, parameter, exact] :
       {std::tuple(rows[1], "bed.Rd", 0.9), std::tuple(rows[2], "bed.Rp", 0.1)}) {
    const auto found = cells(row);
    EXPECT_EQ(found[1], parameter);
    EXPECT_NEAR(std::stod(found[2]), exact, 1.5 * std::stod(found[3]));
    EXPECT_NEAR(std::stod(found[4]), exact, 1.5 * std::stod(found[5]));
    EXPECT_EQ(summary("swept")["results"][0]["sobol"]["parameters"][parameter]["total"].get<double>(),
              std::stod(found[4]));
  }
  EXPECT_EQ(lines("swept/sweep.csv").size(), 801u);
  EXPECT_THAT(outcome.text, HasSubstr("first order"));
}

TEST_F(Sweeping, SamplesFromAFile) {
  write("samples.csv", "patient,bed.C [mL/mmHg],bed.Rd (mmHg.s/mL)\n1,1.0,1.5\n2,0.5,1.0\n3,2,-1\n");
  write("case.yaml", with("sample: latin_hypercube\n  count: 50", "file: samples.csv"));
  const std::string columns = " --set 'sweep.parameters=[{name: bed.Rd}, {name: bed.C}]' ";
  EXPECT_THAT(ostium("sweep case.yaml -o swept" + columns).text,
              HasSubstr("samples.csv:4: column \"bed.Rd\": bed.Rd is -1.33322e+08 Pa.s/m3, and must be > 0"));
  write("samples.csv", "patient,bed.C [mL/mmHg],bed.Rd (mmHg.s/mL)\n1,1.0,1.5\n2,0.5,1.0\n");
  const Outcome outcome = ostium("sweep case.yaml -o swept" + columns);
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const auto rows = lines("swept/sweep.csv");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], "sample,bed.Rd [Pa.s/m3],bed.C [m3/Pa],mean p:A [Pa],pulse p:A [Pa],status");
  EXPECT_NEAR(std::stod(cells(rows[1])[1]), 1.5 * 133322387.415, 1);
  write("samples.csv", "bed.Rd [Pa.s/m3]\n1e8\n2e8\n");  // one column, and no list of parameters
  ASSERT_EQ(ostium("sweep case.yaml -o all --set 'sweep.parameters=[]'").code, 0);
  EXPECT_EQ(lines("all/sweep.csv").size(), 3u);
}

TEST_F(Sweeping, SamplesWithoutResult) {
  write("case.yaml", rcr);
  const std::string split =
      " --set 'sweep={sample: grid, results: [flow_split q:bed / q:in], parameters: [{name: in.flow.factor, "
      "values: "
      "[0, 1]}]}' ";
  const Outcome some = ostium("sweep case.yaml -o some" + split);
  EXPECT_EQ(some.code, 0) << some.text;
  EXPECT_THAT(some.text, HasSubstr("warning: sample 0: failed: the result \"flow_split q:bed / q:in\" is"));
  EXPECT_THAT(some.text, HasSubstr("1 of 2 samples have no result (1 failed, 0 refused)"));
  const auto rows = lines("some/sweep.csv");
  EXPECT_EQ(rows[1], "0,0,nan,failed");
  EXPECT_THAT(rows[2], testing::EndsWith(",ok"));
  EXPECT_EQ(summary("some")["samples"]["failed"], 1);
  const Outcome none = ostium("sweep case.yaml -o none" + split +
                              "--set 'sweep.parameters=[{name: in.flow.factor, values: [0]}]'");
  EXPECT_EQ(none.code, 3) << none.text;
  EXPECT_EQ(summary("none")["status"], "finished");
}

TEST_F(Sweeping, AKilledSweepGoesOnWithTheSameBytes) {
  write("case.yaml", rcr);
  const std::string count = " --set sweep.count=1500 ";
  EXPECT_THAT(cut_short("KILL", 1500), HasSubstr("code 137"));
  ASSERT_TRUE(exists("stopped/checkpoint.h5"));
  EXPECT_THAT(ostium("sweep case.yaml -o stopped" + count).text, HasSubstr("go on with it with --resume"));
  const std::string before = content("stopped/sweep.csv");
  const auto torn = before.find_last_of('\n', before.size() - 2) - 7;
  write("stopped/sweep.csv", before.substr(0, torn));
  const auto whole_rows = lines("stopped/sweep.csv").size() - 2;  // without header and torn row
  EXPECT_THAT(ostium("sweep case.yaml -o stopped --resume" + count + "--set sweep.seed=2").text,
              HasSubstr("belongs to another case"));
  EXPECT_THAT(ostium("sweep case.yaml -o stopped --resume" + count + "--set output.every=10ms").text,
              HasSubstr("belongs to another case"));
  const Outcome resumed = ostium("sweep case.yaml -q -o stopped --resume" + count);
  ASSERT_EQ(resumed.code, 0) << resumed.text;
  EXPECT_THAT(resumed.text, HasSubstr(fmt::format("the sweep goes on from sample {}\n", whole_rows)));
  ASSERT_EQ(ostium("sweep case.yaml -q -o whole --threads 1" + count).code, 0);
  EXPECT_TRUE(content("stopped/sweep.csv") == content("whole/sweep.csv"));
  EXPECT_EQ(summary("stopped")["results"], summary("whole")["results"]);
  EXPECT_THAT(ostium("sweep case.yaml -o stopped --resume" + count).text,
              HasSubstr("there is nothing to resume"));
}

TEST_F(Sweeping, AnInterruptedSweepSaysHowToGoOn) {
  write("case.yaml", rcr);
  const std::string said = cut_short("TERM", 1000000);
  EXPECT_THAT(said, HasSubstr("code 130"));
  EXPECT_THAT(said,
              HasSubstr("go on with: ostium sweep case.yaml --set sweep.count=1000000 -o stopped --resume"));
  EXPECT_EQ(summary("stopped")["status"], "interrupted");
  EXPECT_EQ(content("stopped/sweep.csv").back(), '\n');
  EXPECT_EQ(lines("stopped/sweep.csv").size(), summary("stopped")["samples"]["done"].get<std::size_t>() + 1);
}

TEST_F(Sweeping, ARowOfAnotherSweepIsRefused) {
  write("case.yaml", rcr);
  cut_short("KILL", 1000000);
  std::string table = content("stopped/sweep.csv");
  write("stopped/sweep.csv", with("\n1,", "\n1,9", table));
  const std::string resume = "sweep case.yaml -o stopped --resume --set sweep.count=1000000";
  EXPECT_THAT(ostium(resume).text, HasSubstr("sweep.csv:3: this row is not that of sample 1 of this sweep"));
  write("stopped/sweep.csv", with("bed.C", "bed.D", table));
  EXPECT_THAT(ostium(resume).text, HasSubstr("sweep.csv:1: the table has other columns"));
}

TEST_F(Sweeping, ManyProcessesGiveTheSameBytes) {
  if (shell("mpirun --version").code != 0) GTEST_SKIP() << "mpirun is not installed";
  write("case.yaml", rcr);
  const std::string two =
      "mpirun --allow-run-as-root --oversubscribe -n 2 " OSTIUM_BINARY " sweep case.yaml -q ";
  const Outcome both = shell(two + "-o two --threads 1");
  ASSERT_EQ(both.code, 0) << both.text;
  EXPECT_THAT(both.text, HasSubstr("1 thread in each of 2 processes"));
  ASSERT_EQ(ostium("sweep case.yaml -q -o one").code, 0);
  EXPECT_EQ(content("one/sweep.csv"), content("two/sweep.csv"));
  const Outcome refused = shell(two + "-o two");
  EXPECT_NE(refused.code, 0);
  const auto sentence = refused.text.find("error: two: this folder holds the results of a finished run");
  ASSERT_NE(sentence, std::string::npos) << refused.text;
  EXPECT_EQ(refused.text.find("error: two", sentence + 1), std::string::npos);  // said once
}

/// 1000 x 101 samples of a network that takes no time: a resistance.
TEST_F(Sweeping, LargeTablesAreAlsoHdf5) {
  write("case.yaml", R"(network:
  blocks:
    in: {type: flow_source, to: A, flow: 90 mL/s}
    r: {type: resistor, from: A, ground: 0 Pa, R: 1e8 Pa.s/m3}
time: {end: 1 s}
output: {every: 1 s}
sweep:
  sample: grid
  parameters:
    - {name: in.flow, low: 10 mL/s, high: 100 mL/s, count: 101}
    - {name: r.R, low: 1e7 Pa.s/m3, high: 1e9 Pa.s/m3, count: 1000}
  results: [mean p:A]
)");
  const Outcome outcome = ostium("sweep case.yaml -q -o swept");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const hid_t file = H5Fopen((folder() / "swept/sweep.h5").c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  const auto read = [&](const char* name) {
    const hid_t set = H5Dopen2(file, name, H5P_DEFAULT), space = H5Dget_space(set);
    std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    EXPECT_GE(H5Dread(set, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
    H5Sclose(space), H5Dclose(set);
    return values;
  };
  const auto parameters = read("parameters"), results = read("results"), status = read("status");
  H5Fclose(file);
  ASSERT_EQ(parameters.size(), 202000u);
  ASSERT_EQ(results.size(), 101000u);
  ASSERT_EQ(status.size(), 101000u);
  for (std::size_t i = 0; i < results.size(); i += 997)
    EXPECT_NEAR(results[i], parameters[2 * i] * parameters[2 * i + 1], 1e-9 * results[i]);
  const auto last = cells(lines("swept/sweep.csv").back());
  EXPECT_EQ(std::stod(last[3]), results.back());
}

/// The example of docs/running.md, with a network that has its names.
TEST_F(Sweeping, TheExampleOfThePages) {
  std::ostringstream page;
  page << std::ifstream(OSTIUM_SOURCE_DIR "/docs/running.md").rdbuf();
  const std::string text = page.str(), fence = "```";
  const auto begin = text.find("sweep:\n"), end = text.find(fence, begin);
  ASSERT_NE(begin, std::string::npos);
  std::string network = std::string(rcr).substr(0, std::string(rcr).find("sweep:"));
  network = with("to: A", "to: root", with("from: A", "from: root", with("bed", "body", network)));
  write("case.yaml", network + text.substr(begin, end - begin));
  EXPECT_THAT(ostium("check case.yaml").text, HasSubstr("in order"));
  const Outcome outcome = ostium("sweep case.yaml -q -o swept --set sweep.count=20");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_EQ(lines("swept/sweep.csv").size(), 21u);
}

}  // namespace
}  // namespace ostium::test
