// Every file of the corpus once through its target: the seeds, and what once crashed, hung or was refused badly.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "targets.hpp"

namespace ostium::fuzz {
namespace {

std::string content_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

class Corpus : public testing::TestWithParam<Target> {};

TEST_P(Corpus, IsReadOrRefusedInOneLine) {
  const auto folder = std::filesystem::path(OSTIUM_SOURCE_DIR) / "tests/fuzz/corpus" / GetParam().name;
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename().string());
    EXPECT_NO_THROW(GetParam().run(content_of(entry.path())));
    ++count;
  }
  EXPECT_GT(count, 2);
}

INSTANTIATE_TEST_SUITE_P(Targets, Corpus, testing::ValuesIn(targets()),
                         [](const auto& p) { return p.param.name; });

}  // namespace
}  // namespace ostium::fuzz
