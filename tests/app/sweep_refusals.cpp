// `ostium sweep`: bad descriptions and bad files of samples, each refused in a sentence.
#include "sweeping.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;

TEST_F(Sweeping, Refusals) {
  write("samples.csv", "bed.Rd [Pa.s/m3],bed.C\n1e8,1e-9\n");
  const std::tuple<std::string, std::string, std::string> all[] = {
      {"bed.Rd,", "bed.Rdd,", "there is no parameter \"bed.Rdd\""},
      {"bed.Rd,", "bed.Rdd,", "did you mean \"bed.Rd\"?"},
      {"low: 100 mmHg.s/L", "low: 5e8 Pa.s/m3",
       "bed.Rd: low is 5e+08 and high 4e+08 Pa.s/m3; low must be below high"},
      {"low: 100 mmHg.s/L", "low: 100 mmHg",
       "case.yaml:11:22: sweep.parameters.1.low: the unit \"mmHg\" has the wrong dimension"},
      {"low: 100 mmHg.s/L", "low: 100", "expected a value with a unit of dimension Pa.s/m3"},
      {"low: 100 mmHg.s/L", "low: -1 Pa.s/m3", "bed.Rd is -1 Pa.s/m3, and must be > 0 Pa.s/m3"},
      {"low: 100 mmHg.s/L, ", "", "\"low\" is missing"},
      {"low: 1e-9 m3/Pa", "low: 0 m3/Pa", "a logarithmic scale needs low > 0"},
      {"bed.C, low", "bed.Rd, low", "the unit \"m3/Pa\" has the wrong dimension"},
      {"scale: log", "scale: log, count: 3", "values from low to high are counted in a grid"},
      {"scale: log", "distribution: normal", "belong together"},
      {"scale: log", "scale: logarithmic", "scale"},
      {"    - {name: bed.C, low: 1e-9 m3/Pa, high: 1e-8 m3/Pa, scale: log}",
       "    - {name: bed.Rd, low: 1e8 Pa.s/m3, high: 2e8 Pa.s/m3}", "the parameter bed.Rd is given twice"},
      {"count: 50", "count: 0", "must be >= 1"},
      {"  count: 50\n", "", "the number of samples is missing; add for example \"count: 1000\""},
      {"count: 50", "count: 1000000000", "at most 2e+08 are allowed; choose fewer values"},
      {"latin_hypercube\n  count: 50", "grid", "in a grid \"count\" is missing"},
      {"latin_hypercube", "grid", "a grid has a \"count\" for each parameter"},
      {"latin_hypercube", "latin_hypercub", "did you mean \"latin_hypercube\"?"},
      {"sample: latin_hypercube\n  count: 50", "file: samples.csv", "leave all but \"name\" out"},
      {"count: 50", "file: samples.csv", "give either \"sample\""},
      {"[mean p:A, pulse p:A]", "[meen p:A]", "there is no index \"meen\"; did you mean \"mean\"?"},
      {"[mean p:A, pulse p:A]", "[mean p:B]", "there is no series \"p:B\""},
      {"[mean p:A, pulse p:A]", "[]", "no result is asked for"},
      {"sweep:", "swep:", "did you mean \"sweep\"?"},
  };
  for (const auto& [from, to, sentence] : all) {
    write("case.yaml", with(from, to));
    const Outcome outcome = ostium("sweep case.yaml -o swept");
    EXPECT_EQ(outcome.code, 2) << sentence << "\n" << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr(sentence));
    EXPECT_THAT(outcome.text, HasSubstr("case.yaml:"));
    EXPECT_FALSE(exists("swept"));
  }
  write("case.yaml", std::string(rcr).substr(0, std::string(rcr).find("sweep:")));
  EXPECT_THAT(ostium("sweep case.yaml").text, HasSubstr("a sweep needs the section \"sweep\""));
}

TEST_F(Sweeping, RefusedFiles) {
  write("case.yaml", with("sample: latin_hypercube\n  count: 50", "file: samples.csv"));
  const std::string bare = " --set 'sweep.parameters=[]'",
                    named = " --set 'sweep.parameters=[{name: bed.Rd}]'";
  const std::tuple<std::string, std::string, std::string> all[] = {
      {"bed.Rd [Pa.s/m3],bed.C\n1e8,1e-9\n", bare,
       "the column \"bed.C\" has no unit; write for example \"bed.C [m3/Pa]\""},
      {"bed.Rd [mmHg],bed.C [m3/Pa]\n1e8,1e-9\n", bare, "the unit \"mmHg\" has the wrong dimension"},
      {"bed.Rd [Pa.s/m3],bed.C [m3/Pa]\n1e8,much\n", bare, "samples.csv:2: column 2: \"much\" is no number"},
      {"bed.Rd [Pa.s/m3],bed.C [m3/Pa]\n1e8,nan\n", bare,
       "samples.csv:2: column \"bed.C\": bed.C is nan m3/Pa, and must be"},
      {"bed.Rdd [Pa.s/m3],bed.C [m3/Pa]\n1e8,1e-9\n", bare, "there is no parameter \"bed.Rdd\""},
      {"bed.Rdd [Pa.s/m3],bed.C [m3/Pa]\n1e8,1e-9\n", named,
       "the samples have no column \"bed.Rd\"; did you mean \"bed.Rdd\"?"},
      {"1e8,1e-9\n", bare, "need a header line"},
      {"bed.Rd [Pa.s/m3],bed.C [m3/Pa]\n", bare, "no row of numbers"},
  };
  for (const auto& [text, parameters, sentence] : all) {
    write("samples.csv", text);
    const Outcome outcome = ostium("sweep case.yaml -o swept" + parameters);
    EXPECT_EQ(outcome.code, 2) << sentence << "\n" << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr(sentence));
    EXPECT_THAT(outcome.text, HasSubstr("sweep.file: "));
    EXPECT_FALSE(exists("swept"));
  }
}

}  // namespace
}  // namespace ostium::test
