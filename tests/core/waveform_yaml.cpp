#include <gmock/gmock.h>

#include "core/config.hpp"
#include "core/log.hpp"
#include "errors.hpp"

namespace ostium::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

class WaveformYaml : public testing::Test {
 protected:
  WaveformYaml() {
    log::show_on_terminal(false);
    log::forget_warnings();
  }
  ~WaveformYaml() override { log::show_on_terminal(true); }
  Waveform read(const std::string& yaml) const {
    const auto node = config::Node::parse("flow: " + yaml, (scratch.folder() / "case.yaml").string());
    return config::read_waveform(node.at("flow"), "m3/s");
  }
  std::string error_in(const std::string& yaml) const {
    return error_of([&] { read(yaml); });
  }
  Scratch scratch;
};

TEST_F(WaveformYaml, ConstantAndInline) {
  EXPECT_DOUBLE_EQ(read("6 L/min")(0.3), 1e-4);
  const Waveform w =
      read("{times: [0, 500], time_unit: ms, values: [0, 10], unit: mL/s, period: 1 s, sign: -1}");
  EXPECT_DOUBLE_EQ(w(0.25), -5e-6);
  EXPECT_EQ(w.period(), 1);
  EXPECT_DOUBLE_EQ(read("{times: [0 s, 1 min], values: [0 L/min, 6 L/min]}")(60), 1e-4);
}

TEST_F(WaveformYaml, Fourier) {
  const Waveform w =
      read("{fourier: {mean: 6, cos: [6], sin: [0, 3]}, unit: L/min, period: 1 s, delay: 0.25 s}");
  EXPECT_NEAR(w(0.25), 2e-4, 1e-18);
  EXPECT_DOUBLE_EQ(w.mean(), 1e-4);
  EXPECT_DOUBLE_EQ(read("{fourier: {mean: 6 L/min}, period: 1 s}").mean(), 1e-4);
}

TEST_F(WaveformYaml, Files) {
  scratch.write("a.csv", "time [ms], flow [mL/s]\n0, 1\n500, 3\r\n");
  EXPECT_DOUBLE_EQ(read("{file: a.csv, period: 1 s}")(0.25), 2e-6);
  scratch.write("b.flow", "2 16\n0.0   1.0\n 0.5\t3.0\n");
  EXPECT_DOUBLE_EQ(read("{file: b.flow, skip: 1, unit: cm3/s}")(0.25), 2e-6);
  scratch.write("c.csv", "# comment\nt;Q;Qmls\n0;9;1\n0.5;9;3\n");
  EXPECT_DOUBLE_EQ(read("{file: c.csv, columns: [t, Qmls], unit: mL/s}")(0.25), 2e-6);
  EXPECT_DOUBLE_EQ(read("{file: c.csv, columns: [1, 3], unit: mL/s}")(0.25), 2e-6);
}

TEST_F(WaveformYaml, MeasuredInflows) {
  const std::filesystem::path data = OSTIUM_DATA_DIR "/vessels";
  if (!std::filesystem::exists(data)) GTEST_SKIP() << "needs the folder of reference vessels, " << data;
  const auto from = [&](const char* file, const char* rest) {
    return read("{file: " + (data / file).string() + ", " + rest + "}");
  };
  const Waveform aorta = from("aorta_vmr0024/0154_0001_inflow.txt", "unit: mL/s, sign: -1");
  EXPECT_EQ(aorta.times().size(), 500u);
  EXPECT_GT(aorta.mean(), 10e-6);
  const Waveform pipe =
      from("pipe_rcr/lumen_inlet.flow", "unit: mL/s, skip: 1, period: 1 s, sign: -1, modes: 16");
  EXPECT_EQ(pipe.series().cos.size(), 16u);
  EXPECT_GT(pipe.mean(), 0);
  EXPECT_GT(from("bifurcation_sv_simple/inflow.flow", "unit: mm3/s").times().size(), 10u);
  EXPECT_THAT(error_in("{file: " + (data / "pipe_rcr/lumen_inlet.flow").string() + ", unit: mL/s}"),
              HasSubstr("lumen_inlet.flow:2: the time 0 s does not come after 33 s"));
}

TEST_F(WaveformYaml, HarmonicsOfATable) {
  const Waveform w =
      read("{times: [0, 0.25, 0.75], time_unit: s, values: [0, 1, -1], unit: m3/s, period: 1 s, modes: 3}");
  EXPECT_EQ(w.form(), Waveform::Form::fourier);
  EXPECT_NEAR(w(0.25), 8 / 9.8696044 * (1 + 1.0 / 9), 1e-7);
}

TEST_F(WaveformYaml, ErrorsInFiles) {
  const std::string at =
      scratch.folder().string() + "/case.yaml:1:8: flow.file: " + scratch.folder().string();
  scratch.write("order.csv", "t [s], Q [mL/s]\n0,1\n0.2,2\n0.1,3\n");
  EXPECT_EQ(
      error_in("{file: order.csv, period: 1 s}"),
      at + "/order.csv:4: the time 0.1 s does not come after 0.2 s of the row before; times must increase");
  scratch.write("nan.csv", "t [s], Q [mL/s]\n0,1\n0.2,nan\n");
  EXPECT_EQ(error_in("{file: nan.csv}"), at + "/nan.csv:3: the value nan is not a finite number");
  scratch.write("word.csv", "0 1\n0.1 x\n");
  EXPECT_EQ(error_in("{file: word.csv, unit: mL/s}"), at + "/word.csv:2: column 2: \"x\" is no number");
  scratch.write("short.csv", "0 1\n0.1\n");
  EXPECT_EQ(error_in("{file: short.csv, unit: mL/s}"),
            at + "/short.csv:2: expected 2 columns as in the first row, found 1");
  scratch.write("empty.csv", "t,Q\n");
  EXPECT_EQ(error_in("{file: empty.csv, unit: mL/s}"),
            at + "/empty.csv: there is no row of numbers in this file");
  EXPECT_EQ(error_in("{file: missing.csv, unit: mL/s}"),
            at + "/missing.csv: there is no such file; look at its name and its folder");
  scratch.write("good.csv", "t,Q\n0,1\n1,2\n");
  EXPECT_THAT(error_in("{file: good.csv}"), EndsWith("is missing; add for example \"unit: m3/s\""));
  EXPECT_THAT(error_in("{file: good.csv, unit: mmHg}"),
              HasSubstr("the unit \"mmHg\" has the wrong dimension"));
  EXPECT_THAT(error_in("{file: good.csv, unit: mL/s, columns: [t, q]}"),
              HasSubstr("the file has no column \"q\""));
  EXPECT_THAT(error_in("{file: good.csv, unit: mL/s, period: 0.5 s}"),
              HasSubstr("more than the period of 0.5 s"));
  scratch.write("one.csv", "1\n2\n");
  EXPECT_THAT(error_in("{file: one.csv, unit: mL/s}"), HasSubstr("found one column"));
}

TEST_F(WaveformYaml, ErrorsInline) {
  EXPECT_THAT(
      error_in("{times: [0, 1], time_unit: s, values: [0, 1]}"),
      HasSubstr(
          "case.yaml:1:46: flow.values.1: expected a value with a unit of dimension m3/s, found the bare "
          "number 0; add \"unit: m3/s\""));
  EXPECT_THAT(error_in("{times: [0, 2, 1], time_unit: s, values: [0, 1, 2], unit: mL/s}"),
              HasSubstr("flow: row 3: the time 1 s does not come after 2 s"));
  EXPECT_THAT(error_in("{times: [0, 1], time_unit: s, values: [0, .nan], unit: mL/s}"),
              HasSubstr("flow.values.2: "));
  EXPECT_THAT(error_in("{times: [0, 1], time_unit: s, values: [0, nan], unit: mL/s}"),
              HasSubstr("flow.values.2: \"nan\" is not a finite number"));
  EXPECT_THAT(error_in("{times: [0, 1]}"), HasSubstr("\"times\" and \"values\" belong together"));
  EXPECT_THAT(error_in("{unit: mL/s}"), HasSubstr("a waveform is given by exactly one of"));
  EXPECT_THAT(error_in("[1, 2]"), HasSubstr("expected a waveform: a constant like \"5 m3/s\""));
  EXPECT_THAT(error_in("5"), HasSubstr("found the bare number 5"));
  EXPECT_THAT(error_in("{fourier: {mean: 1}, unit: mL/s}"), HasSubstr("a Fourier series needs a period"));
  EXPECT_THAT(error_in("{fourier: {maen: 1}, unit: mL/s, period: 1 s}"), HasSubstr("did you mean \"mean\"?"));
  EXPECT_THAT(error_in("{file: x.csv, intepolation: linear}"), HasSubstr("did you mean \"interpolation\"?"));
}

TEST_F(WaveformYaml, EndsThatDisagreeWarn) {
  read("{times: [0, 0.5, 1], time_unit: s, values: [0, 1, 0], unit: mL/s, period: 1 s}");
  EXPECT_TRUE(log::warnings().empty());
  read("{times: [0, 0.5, 1], time_unit: s, values: [0, 1, 0.5], unit: m3/s, period: 1 s}");
  ASSERT_EQ(log::warnings().size(), 1u);
  EXPECT_THAT(log::warnings()[0],
              HasSubstr("flow: the first and the last value of the period differ (0 and 0.5 m3/s)"));
}

TEST_F(WaveformYaml, WriteBackIsExact) {
  for (const char* yaml :
       {"5 L/min", "{times: [0, 0.1, 0.3], time_unit: s, values: [1, 7, 2], unit: L/min, period: 0.9 s}",
        "{times: [0, 0.1, 0.3], time_unit: ms, values: [1, 7, 2], unit: L/min, interpolation: "
        "monotone_cubic}",
        "{fourier: {mean: 5, cos: [0.1, 0.2], sin: [0.3]}, unit: L/min, period: 0.77 s}"}) {
    const Waveform w = read(yaml);
    EXPECT_EQ(read(config::to_text(config::write_waveform(w, "m3/s"))), w) << yaml;
  }
}

}  // namespace
}  // namespace ostium::test
