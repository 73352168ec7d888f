// Waveforms: constant, table, Fourier series, files.
#include "malformed.hpp"

namespace ostium::test {
namespace {

class MalformedSource : public MalformedCase {};
TEST_P(MalformedSource, IsRefused) { refuse(); }

/// A flow source in line 3.
Malformed flow(const std::string& name, const std::string& flow, const std::string& key,
               const std::string& says, const Files& files = {}) {
  return {name,
          network_of({"q: {type: flow_source, to: A, flow: " + flow + "}", bed}),
          {"case.yaml:3:", "network.blocks.q" + key, says},
          files};
}

Malformed file(const std::string& name, const std::string& content, const std::string& says) {
  return flow(name, "{file: a.csv, unit: mL/s, period: 0.8 s}", ".flow.file: ", says, {{"a.csv", content}});
}

INSTANTIATE_TEST_SUITE_P(
    Forms, MalformedSource,
    testing::Values(
        flow("FlowInMmHg", "5 mmHg", ".flow: ", "converts to m3/s"),
        flow("FlowAndVelocity", "5 mL/s, velocity: 1 m/s", ": ",
             "needs one of `flow` and `velocity`, found both"),
        flow("TwoNumbers", "80 90 mL/s", ".flow: ", "holds two numbers"),
        flow("TooLargeForANumber", "1e400 mL/s", ".flow: ", "too large or too small for a number"),
        flow("Infinite", "inf mL/s", ".flow: ", "is not a finite number"),
        flow("Hexadecimal", "0x10 mL/s", ".flow: ", "unknown unit \"x10 mL/s\""),
        flow("DecimalComma", "\"5,2 mL/s\"", ".flow: ", "write a decimal point, not a comma"),
        flow("LogarithmicUnit", "5 lg(re 1 m3/s)", ".flow: ", "unknown unit"),
        flow("UnequalLists", "{times: [0, 0.4], values: [1, 2, 3], unit: mL/s, time_unit: s}",
             ".flow: ", "there are 2 times but 3 values"),
        flow("OneSample", "{times: [0], values: [1], unit: mL/s, time_unit: s}",
             ".flow: ", "at least two samples"),
        flow("WordAmongTimes", "{times: [0, a], values: [1, 2], unit: mL/s, time_unit: s}",
             ".flow.times.2: ", "\"a\" does not begin with a number"),
        flow("SamplesNoTimeApart", "{times: [0, 1e-320], values: [1, 2], unit: mL/s, time_unit: s}", ".flow",
             "1e-320"),
        flow("TimesInTheFarFuture", "{times: [0, 1e12], values: [1, 2], unit: mL/s, time_unit: s}",
             ".flow: ", "too far away"),
        flow("PeriodOfANanosecond", "{times: [0 s, 1e-12 s], values: [1, 2], unit: mL/s, period: 1e-9 s}",
             ".flow.period: ", "look at its unit"),
        flow("DelayOfAges",
             "{times: [0, 0.4], values: [1, 2], unit: mL/s, time_unit: s, period: 0.8 s, delay: 1e20 s}",
             ".flow: ", "too far away"),
        flow("FourierWithoutPeriod", "{fourier: {mean: 1}, unit: mL/s}",
             ".flow: ", "a Fourier series needs a period"),
        flow("FourierOfAWord", "{fourier: {mean: abc, cos: [1]}, unit: mL/s, period: 0.8 s}",
             ".flow.fourier.mean: ", "\"abc\" does not begin with a number"),
        flow("MillionsOfModes", "{file: a.csv, unit: mL/s, period: 0.8 s, modes: 1000000000}",
             ".flow.modes: ", "it must be >= 1 and <= 500", {{"a.csv", "0,1\n0.5,2\n"}}),
        Malformed{"PressureWithoutValue",
                  beside("x: {type: pressure_source, to: A}"),
                  {"case.yaml:5:", "network.blocks.x: the key \"pressure\" is missing"}},
        Malformed{"PressureAsAList",
                  beside("x: {type: pressure_source, to: A, pressure: [1 Pa, 2 Pa]}"),
                  {"case.yaml:5:", "network.blocks.x.pressure: expected a waveform"}}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Tables, MalformedSource,
    testing::Values(
        file("NotANumber", "0,1\n0.2,nan\n", "a.csv:2: the value nan is not a finite number"),
        file("BackInTime", "0,1\n0.2,2\n0.1,2\n", "a.csv:3: the time 0.1 s does not come after 0.2 s"),
        file("Empty", "", "there is no row of numbers in this file"),
        file("Binary", std::string("\0\1\2\xff\xfe\n\x80\x81,\x82\n", 11),
             "there is no row of numbers in this file"),
        file("BinaryCell", "0,1\n0.2,\x1b[31m\xff\n", "a.csv:2: column 2: \"\\x1b[31m\\xff\" is no number"),
        file("OneColumn", "0\n1\n", "found one column"),
        file("OneRow", "0,1\n", "at least two samples, found 1"),
        file("RaggedRows", "0,1\n0.2,2,3\n", "a.csv:2: expected 2 columns as in the first row, found 3"),
        file("LongerThanItsPeriod", "0,1\n2,2\n", "the samples span 2 s, more than the period of 0.8 s"),
        flow("FileOfPressures", "{file: a.csv, period: 0.8 s}", ".flow.file: ",
             "the unit \"mmHg\" has the wrong dimension", {{"a.csv", "t [s], p [mmHg]\n0,1\n0.2,2\n"}}),
        flow("FileWithoutUnit", "{file: a.csv, period: 0.8 s}", ".flow: ", "the unit of the values in ",
             {{"a.csv", "0,1\n0.2,2\n"}}),
        flow("FileMissing", "{file: none.csv, unit: mL/s}", ".flow.file: ", "there is no such file"),
        flow("FileIsAFolder", "{file: ., unit: mL/s}", ".flow.file: ", "this is a folder"),
        flow("FileWithoutEnd", "{file: /dev/zero, unit: mL/s}",
             ".flow.file: ", "no ordinary file but a device or a pipe"),
        flow("UnknownColumn", "{file: a.csv, unit: mL/s, columns: [t, flow]}", ".flow.columns: ",
             "the file has no column \"flow\"", {{"a.csv", "t [s], q [mL/s]\n0,1\n0.2,2\n"}})),
    name_of);

}  // namespace
}  // namespace ostium::test
