/// Malformed inputs through the program's front door: each is refused with exit code 2 and one line that says where,
/// and nothing is written.
#pragma once
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <map>
#include <set>

#include "app/command_line.hpp"
#include "program.hpp"

namespace ostium::test {

using Files = std::map<std::string, std::string>;

/// An input and what its refusal must say: the place first (file and line or JSON path, block and key).
struct Malformed {
  std::string name;
  std::string text;
  std::vector<std::string> says;
  Files files = {};
};

inline std::string name_of(const testing::TestParamInfo<Malformed>& info) { return info.param.name; }
inline void PrintTo(const Malformed& m, std::ostream* out) { *out << m.name; }

class Front : public ProgramTest {
 protected:
  std::set<std::string> content_of_folder() const {
    std::set<std::string> all;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder()))
      all.insert(entry.path().string());
    return all;
  }
  std::string path(const std::string& name) const { return (folder() / name).string(); }

  /// The program in this process: its exit code and what it wrote to stderr.
  static Outcome program(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "ostium");
    std::vector<char*> argv;
    for (auto& a : arguments) argv.push_back(a.data());
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    const int code = app::run_program(static_cast<int>(argv.size()), argv.data());
    testing::internal::GetCapturedStdout();
    return {code, testing::internal::GetCapturedStderr()};
  }

  void expect_refusal(const std::vector<std::string>& arguments, const std::vector<std::string>& says) const {
    const auto before = content_of_folder();
    const Outcome outcome = program(arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.text;
    EXPECT_TRUE(outcome.text.starts_with("error: ")) << outcome.text;
    EXPECT_EQ(std::count(outcome.text.begin(), outcome.text.end(), '\n'), 1) << outcome.text;
    EXPECT_LT(outcome.text.size(), 2000u) << outcome.text;
    for (const auto& part : says) EXPECT_THAT(outcome.text, testing::HasSubstr(part));
    EXPECT_EQ(content_of_folder(), before);
  }

  void write_all(const std::string& name, const Malformed& input) const {
    write(name, input.text);
    for (const auto& [file, content] : input.files) write(file, content);
  }
};

/// As `ostium run` and `ostium check` see it.
class MalformedCase : public Front, public testing::WithParamInterface<Malformed> {
 protected:
  void refuse() const {
    write_all("case.yaml", GetParam());
    expect_refusal({"check", path("case.yaml")}, GetParam().says);
    expect_refusal({"run", path("case.yaml"), "-q", "-o", path("results")}, GetParam().says);
  }
};

inline const std::string source = "q: {type: flow_source, to: A, flow: 5 L/min}";
inline const std::string bed =
    "w: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1e8 Pa.s/m3}";

/// A case of these blocks, which stand from line 3 on.
inline std::string network_of(const std::vector<std::string>& blocks) {
  std::string text = "network:\n  blocks:\n";
  for (const auto& block : blocks) text += "    " + block + "\n";
  return text + "time: {period: 0.8 s, cycles: 2}\n";
}

/// A block in line 5, at the node A of a source and a Windkessel.
inline std::string beside(const std::string& block) { return network_of({source, bed, block}); }

}  // namespace ostium::test
