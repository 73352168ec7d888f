// What is no YAML, or none that a case could be.
#include "malformed.hpp"

namespace ostium::test {
namespace {

class MalformedText : public MalformedCase {};
TEST_P(MalformedText, IsRefused) { refuse(); }

const std::string good = network_of({source, bed});

std::string with(const std::string& what, const std::string& by) {
  std::string text = good;
  return text.replace(text.find(what), what.size(), by);
}

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

/// Each line stands for nine times the one before.
std::string bomb(int lines) {
  std::string text = "x0: &x0 [a, a, a, a, a, a, a, a, a]\n";
  for (int i = 1; i < lines; ++i) {
    const std::string alias = "*x" + std::to_string(i - 1);
    text += fmt::format("x{0}: &x{0} [{1}]\n", i, alias + repeated(", " + alias, 8));
  }
  return text + good;
}

/// Each line holds the one before.
std::string chain(int lines) {
  std::string text = "x0: &x0 [a]\n";
  for (int i = 1; i < lines; ++i) text += fmt::format("x{0}: &x{0} [*x{1}]\n", i, i - 1);
  return text + good;
}

INSTANTIATE_TEST_SUITE_P(
    Yaml, MalformedText,
    testing::Values(
        Malformed{"Empty", "", {"case.yaml:1:1: this file is empty; expected a mapping with the keys title"}},
        Malformed{"AWord", "hello\n", {"case.yaml:1:1: expected a mapping", "found the value \"hello\""}},
        Malformed{"AList", "- a\n", {"case.yaml:1:1: expected a mapping", "found a list"}},
        Malformed{
            "Tabulators",
            with("    w", "\tw"),
            {"case.yaml:4:", "this is not valid YAML", "line 4 is indented with a tabulator, write blanks"}},
        Malformed{"KeyTwice",
                  good + "time: {end: 1 s}\n",
                  {"case.yaml:6:1: time: the name \"time\" is given twice, first at", "case.yaml:5:1"}},
        Malformed{"BlockTwice",
                  network_of({source, bed, bed}),
                  {"case.yaml:5:5: network.blocks.w: ", "given twice"}},
        Malformed{
            "TwoDocuments", good + "---\n" + good, {"case.yaml:7:1: a second YAML document begins here"}},
        Malformed{"OpenBracket", good + "output: {every: 1 s\n", {"case.yaml:", "this is not valid YAML"}},
        Malformed{"UnknownAnchor", network_of({source, "w: *x"}), {"case.yaml:4:", "anchor is not defined"}},
        Malformed{"AnchorInItself",
                  network_of({source, "w: &x {type: resistor, a: *x}"}),
                  {"case.yaml:4:", "this alias stands inside the value it refers to"}},
        Malformed{"AliasesWithoutEnd",
                  bomb(12),
                  {"case.yaml:6:", "the aliases up to here stand for more than 100000"}},
        Malformed{"AliasesNested", chain(10000), {"case.yaml:63:", "nested more than 64 deep"}},
        Malformed{"Deep",
                  "a: " + repeated("[", 100000) + "\n" + good,
                  {"case.yaml:1:", "nested more than 64 deep"}},
        Malformed{"NulByte",
                  with("5 L/min", std::string("5\0 L/min", 8)),
                  {"case.yaml:3:42: the byte 0x00 belongs to no"}},
        Malformed{"EndOfTransmission", with("cycles: 2", "cycles: 2\x04"), {"case.yaml:5:", "the byte 0x04"}},
        Malformed{"Latin1",
                  with("5 L/min", "5 \xb5L/min"),
                  {"case.yaml:3:", "0xb5 belongs to no text; save the file as"}},
        Malformed{"Binary", std::string("\xff\xfe\0\1\2", 5), {"case.yaml:1:1: the byte 0xff"}},
        Malformed{
            "EscapedControl", "title: \"a\\x01b\"\n" + good, {"case.yaml:1:", "holds a control character"}},
        Malformed{"HugeNumber",
                  with("5 L/min", std::string(1000000, '9')),
                  {"case.yaml:3:", "network.blocks.q.flow: "}},
        Malformed{
            "HugeName",
            beside("r: {type: resistor, from: A, to: " + std::string(100000, 'B') + ", R: 1e7 Pa.s/m3}"),
            {"case.yaml:5:", "network.blocks.r: ", "a name is one line of at most 200 characters"}},
        Malformed{"NameOfTwoLines",
                  beside("\"a\\nb\": {type: resistor, from: A, ground: 0 Pa, R: 1e7 Pa.s/m3}"),
                  {"case.yaml:5:", "\"a\\nb\" is no name"}},
        Malformed{"NodeOfTwoLines",
                  beside("r: {type: resistor, from: A, to: \"B\\nC\", R: 1e7 Pa.s/m3}"),
                  {"case.yaml:5:", "network.blocks.r: ", "has the node \"B\\nC\""}},
        Malformed{"NoName",
                  beside("\"\": {type: resistor, from: A, ground: 0 Pa, R: 1e7 Pa.s/m3}"),
                  {"case.yaml:5:", "\"\" is no name"}}),
    name_of);

class MalformedPlace : public Front {};

TEST_F(MalformedPlace, FolderDeviceAndUnreadableFile) {
  expect_refusal({"run", folder().string(), "-o", path("results")}, {"this is a folder"});
  expect_refusal({"run", "/dev/zero", "-o", path("results")}, {"/dev/zero: this is no ordinary file"});
  expect_refusal({"check", path("none.yaml")}, {"none.yaml: there is no such file"});
  const auto file = write("locked.yaml", good);
  std::filesystem::permissions(file, std::filesystem::perms::none);
  if (!std::ifstream(file))  // root reads everything
    expect_refusal({"check", file.string()},
                   {"locked.yaml: this file cannot be read; look at its permissions"});
}

}  // namespace
}  // namespace ostium::test
