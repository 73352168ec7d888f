/// Runs the program itself in a folder of its own.
#pragma once
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace ostium::test {

struct Outcome {
  int code;
  std::string text;  // stdout and stderr together
};

class ProgramTest : public testing::Test {
 protected:
  ProgramTest() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / (std::string("ostium_") + test->test_suite_name() +
                                                        "_" + test->name() + "_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~ProgramTest() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(folder_ / name, std::ios::binary) << content;
    return folder_ / name;
  }
  std::string content(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name).rdbuf();
    return text.str();
  }
  bool exists(const std::string& name) const { return std::filesystem::exists(folder_ / name); }

  Outcome ostium(const std::string& arguments) const { return shell(OSTIUM_BINARY " " + arguments); }

  /// Runs case.yaml, expects the refusal, returns what the terminal showed.
  std::string refused(const std::string& yaml) const {
    write("case.yaml", yaml);
    const Outcome outcome = ostium("run case.yaml -o results");
    EXPECT_EQ(outcome.code, 2) << outcome.text;
    EXPECT_FALSE(exists("results"));
    EXPECT_EQ(ostium("check case.yaml").code, 2);
    return outcome.text;
  }

  /// Any command in the folder of the test.
  Outcome shell(const std::string& command) const {
    std::FILE* pipe = popen(("cd '" + folder_.string() + "'; " + command + " 2>&1").c_str(), "r");
    Outcome outcome{-1, {}};
    std::array<char, 4096> buffer;
    while (const auto n = fread(buffer.data(), 1, buffer.size(), pipe)) outcome.text.append(buffer.data(), n);
    const int status = pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
    return outcome;
  }

  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace ostium::test
