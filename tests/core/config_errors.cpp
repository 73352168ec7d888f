#include <gmock/gmock.h>

#include "config_struct.hpp"
#include "errors.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string error_in(const std::string& yaml) {
  return error_of([&] { read_study(yaml); });
}

TEST(ConfigErrors, UnknownKey) {
  EXPECT_THAT(
      error_in("title: a\ncylces: 3\n"),
      StartsWith("case.yaml:2:1: cylces: unknown key \"cylces\"; did you mean \"cycles\"? Allowed: title, "));
  EXPECT_EQ(error_in("output:\n  evry: 1 s\n"),
            "case.yaml:2:3: output.evry: unknown key \"evry\"; did you mean \"every\"? Allowed: every, "
            "fields_every");
}

TEST(ConfigErrors, MissingKey) {
  EXPECT_EQ(error_in("blocks:\n  dao: {Rp: 1 Pa.s/m3}\n"),
            "case.yaml:2:3: blocks.dao: the key \"C\" is missing: compliance [m3/Pa]");
  EXPECT_EQ(error_in("blocks:\n  dao:\n"),
            "case.yaml:2:3: blocks.dao: the key \"Rp\" is missing: proximal resistance [Pa.s/m3]");
}

TEST(ConfigErrors, MissingUnit) {
  EXPECT_EQ(error_in("blocks:\n  dao:\n    Rp: 9.8e6\n    C: 1 m3/Pa\n"),
            "case.yaml:3:5: blocks.dao.Rp: expected a value with a unit of dimension Pa.s/m3, found the bare "
            "number "
            "9.8e6; write for example \"9.8e6 Pa.s/m3\"");
}

TEST(ConfigErrors, WrongDimension) {
  EXPECT_THAT(
      error_in("blocks: {dao: {Rp: 9.8e6 mmHg, C: 1 m3/Pa}}"),
      StartsWith(
          "case.yaml:1:16: blocks.dao.Rp: the unit \"mmHg\" has the wrong dimension; expected a unit that "
          "converts to Pa.s/m3, such as dyn.s/cm5"));
  EXPECT_THAT(error_in("porosity: 5 mm"),
              StartsWith("case.yaml:1:1: porosity: the unit \"mm\" has the wrong dimension"));
}

TEST(ConfigErrors, OutOfRange) {
  EXPECT_EQ(error_in("blocks: {dao: {Rp: -9.8e6 Pa.s/m3, C: 1 m3/Pa}}"),
            "case.yaml:1:16: blocks.dao.Rp: -9.8e6 Pa.s/m3 is not allowed; it must be > 0 Pa.s/m3");
  EXPECT_EQ(error_in("blocks: {dao: {Rp: 0 dyn.s/cm5, C: 1 m3/Pa}}"),
            "case.yaml:1:16: blocks.dao.Rp: 0 dyn.s/cm5 (0 Pa.s/m3) is not allowed; it must be > 0 Pa.s/m3");
  EXPECT_EQ(error_in("porosity: 1"), "case.yaml:1:1: porosity: 1 is not allowed; it must be >= 0 and < 1");
  EXPECT_EQ(error_in("cycles: 0"), "case.yaml:1:1: cycles: 0 is not allowed; it must be >= 1 and <= 100");
}

TEST(ConfigErrors, WrongKinds) {
  EXPECT_EQ(error_in("cycles: 2.5"), "case.yaml:1:1: cycles: expected a whole number, found 2.5");
  EXPECT_EQ(error_in("cycles: many"), "case.yaml:1:1: cycles: \"many\" does not begin with a number");
  EXPECT_EQ(error_in("cycles: [1]"), "case.yaml:1:1: cycles: expected a whole number, found a list");
  EXPECT_EQ(error_in("cycles:"), "case.yaml:1:1: cycles: expected a whole number, found nothing");
  EXPECT_EQ(error_in("force: maybe"), "case.yaml:1:1: force: expected true or false, found \"maybe\"");
  EXPECT_EQ(error_in("output: 5 ms"),
            "case.yaml:1:1: output: expected a mapping with the keys every, fields_every; found the value "
            "\"5 ms\"");
  EXPECT_EQ(error_in("blocks: [a]"),
            "case.yaml:1:1: blocks: expected a mapping like {name: value}, found a list");
  EXPECT_EQ(error_in("tags: a"), "case.yaml:1:1: tags: expected a list like [a, b], found the value \"a\"");
  EXPECT_EQ(error_in("title: {a: b}"), "case.yaml:1:1: title: expected a text, found a mapping");
  EXPECT_EQ(error_in("file: ''"), "case.yaml:1:1: file: expected a file name, found an empty text");
  EXPECT_EQ(error_in("point: 1 2 mm"), "case.yaml:1:1: point: expected 3 values, found 2");
  EXPECT_THAT(error_in("point: 1 2 3"), HasSubstr("expected a unit of dimension m behind the values"));
  EXPECT_THAT(error_in("point: [1, 2, 3]"),
              HasSubstr("case.yaml:1:9: point.1: expected a value with a unit"));
  EXPECT_THAT(error_in("- a\n- b"), StartsWith("case.yaml:1:1: expected a mapping with the keys title"));
  EXPECT_THAT(error_in("only words"), HasSubstr("found the value \"only words\""));
}

TEST(ConfigErrors, UnitNames) {
  EXPECT_THAT(error_in("length_unit: furlng"),
              StartsWith("case.yaml:1:1: length_unit: unknown unit \"furlng\""));
  EXPECT_THAT(error_in("length_unit: mmHg"), HasSubstr("the unit \"mmHg\" has the wrong dimension"));
  EXPECT_EQ(error_in("length_unit: -1 cm"),
            "case.yaml:1:1: length_unit: -1 cm is not allowed; a unit must be > 0 m");
  EXPECT_THAT(error_in("length_unit: 5"), HasSubstr("found the bare number 5"));
}

TEST(ConfigErrors, NotFinite) {
  EXPECT_EQ(error_in("output: {every: .nan s}"),
            "case.yaml:1:10: output.every: \".nan s\" does not begin with a number");
  EXPECT_EQ(error_in("output: {every: nan s}"),
            "case.yaml:1:10: output.every: \"nan s\" is not a finite number");
  EXPECT_EQ(error_in("porosity: inf"), "case.yaml:1:1: porosity: \"inf\" is not a finite number");
}

TEST(ConfigErrors, UnknownChoice) {
  EXPECT_EQ(
      error_in("scheme: hold"),
      "case.yaml:1:1: scheme: unknown choice \"hold\"; did you mean \"held\"? Allowed: linearised, held");
}

TEST(ConfigErrors, TwoOfOneName) {
  EXPECT_EQ(
      error_in("blocks:\n  a: {Rp: 1 Pa.s/m3, C: 1 m3/Pa}\n  b: {Rp: 1 Pa.s/m3, C: 1 m3/Pa}\n  a: {}\n"),
      "case.yaml:4:3: blocks.a: the name \"a\" is given twice, first at case.yaml:2:3; rename or delete one "
      "of them");
  EXPECT_THAT(error_in("title: a\ntitle: b"),
              StartsWith("case.yaml:2:1: title: the name \"title\" is given twice"));
}

TEST(ConfigErrors, EmptyFile) {
  for (const char* yaml : {"", "\n\n", "# only a comment\n", "---\n", "~"})
    EXPECT_THAT(error_in(yaml),
                HasSubstr("this file is empty; expected a mapping with the keys title, porosity"))
        << yaml;
}

TEST(ConfigErrors, BrokenYaml) {
  EXPECT_THAT(error_in("title: [a, b\n"), HasSubstr("this is not valid YAML"));
  EXPECT_THAT(error_in("title: a\n  bad: b\n"), StartsWith("case.yaml:2:"));
  EXPECT_THAT(error_in("a: *nowhere"), HasSubstr("this is not valid YAML"));
  EXPECT_THAT(error_in("? [a]\n: b"), HasSubstr("a key must be a single word"));
  EXPECT_THAT(error_in("title: a\n---\ntitle: b\n"), HasSubstr("a second YAML document begins here"));
  EXPECT_THAT(error_in("extra: &x [*x]"), HasSubstr("this alias stands inside the value it refers to"));
}

TEST(ConfigErrors, HostileDocumentsAreHarmless) {
  EXPECT_NE(error_in("extra: " + std::string(20000, '[')), "no error");
  EXPECT_NE(error_in(std::string(20000, '{')), "no error");
  std::string laughs = "extra:\n  l0: &l0 [a, a]\n";
  for (int i = 1; i < 60; ++i)
    laughs += "  l" + std::to_string(i) + ": &l" + std::to_string(i) + " [*l" + std::to_string(i - 1) +
              ", *l" + std::to_string(i - 1) + "]\n";
  EXPECT_THAT(error_in(laughs), HasSubstr("the aliases up to here stand for more than 100000 values"));
  EXPECT_NE(error_in(std::string("title: \0\x01\x02\xff", 11)), "");
}

TEST(ConfigErrors, Files) {
  EXPECT_EQ(error_of([] { config::Node::load("/nowhere/case.yaml"); }),
            "/nowhere/case.yaml: there is no such file; look at its name and its folder");
  const Scratch scratch;
  EXPECT_THAT(error_of([&] { config::Node::load(scratch.folder()); }), HasSubstr("this is a folder"));
}

struct Pair {
  double low = 0, high = 0;
};
void declare(config::Fields<Pair>& f) {
  f.number("low", &Pair::low, "");
  f.number("high", &Pair::high, "");
  f.check([](const Pair& p) { return p.low < p.high ? "" : "\"low\" must be less than \"high\""; });
}

TEST(ConfigErrors, ConditionOnSeveralFields) {
  EXPECT_EQ(error_of([] { config::read<Pair>(config::Node::parse("{low: 2, high: 1}", "c.yaml")); }),
            "c.yaml:1:1: \"low\" must be less than \"high\"");
}

}  // namespace
}  // namespace ostium::test
