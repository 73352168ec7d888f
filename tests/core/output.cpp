#include <gmock/gmock.h>

#include <fstream>
#include <sstream>

#include "core/csv.hpp"
#include "core/log.hpp"
#include "core/progress.hpp"
#include "errors.hpp"

namespace ostium::test {
namespace {

using testing::HasSubstr;

std::string content(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(Csv, WritesExactNumbersAndQuotesText) {
  const Scratch scratch;
  const auto file = scratch.folder() / "a.csv";
  {
    CsvWriter csv(file, {"time_s", "port"});
    csv << 0.1 << std::string("DAo");
    csv.end_row();
    csv << 1.0 / 3 << std::string("a,\"b\"");
    csv.end_row();
  }
  EXPECT_EQ(content(file), "time_s,port\n0.1,DAo\n0.3333333333333333,\"a,\"\"b\"\"\"\n");
}

TEST(Csv, RowsReadBackBitByBit) {
  const Scratch scratch;
  const auto file = scratch.folder() / "a.csv";
  const std::vector<double> row{1e-300, -0.1, 12345678.9, 6.02e-9};
  {
    CsvWriter csv(file, {"a", "b", "c", "d"});
    for (int i = 0; i < 5000; ++i) csv.row(row);
  }
  const Table table = read_table(file);
  EXPECT_THAT(table.names, testing::ElementsAre("a", "b", "c", "d"));
  ASSERT_EQ(table.columns[3].size(), 5000u);
  for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(table.columns[k].back(), row[k]);
  EXPECT_EQ(table.lines.back(), 5001);
}

TEST(Csv, WrongNumberOfCellsIsABug) {
  const Scratch scratch;
  CsvWriter csv(scratch.folder() / "a.csv", {"a", "b"});
  csv << 1.0;
  EXPECT_THROW(csv.end_row(), Bug);
}

TEST(Csv, UnwritableFile) {
  EXPECT_EQ(error_of([] { CsvWriter("/nowhere/a.csv", {"a"}); }),
            "/nowhere/a.csv: this file cannot be written");
}

TEST(Progress, Line) {
  const Progress::Options options{.start = 0, .end = 1.32, .period = 0.66};
  EXPECT_EQ(Progress::line(options, 0.33, 1000, 10, "max 0.8 m/s"),
            "0.33 / 1.32 s  cycle 1  25 %  100 steps/s  ETA 0:30  max 0.8 m/s");
  EXPECT_THAT(Progress::line(options, 0.66, 1, 4000, ""), HasSubstr("cycle 2  50 %"));
  EXPECT_THAT(Progress::line(options, 0.66, 1, 4000, ""), HasSubstr("ETA 1:06:40"));
  EXPECT_THAT(Progress::line(options, 0, 0, 0, ""), HasSubstr("0 %  0 steps/s  ETA ?"));
  EXPECT_EQ(Progress::line({.end = 1, .task = "filling the vessel"}, 0.4, 0, 8, ""),
            "filling the vessel  40 %  ETA 0:12");
  EXPECT_EQ(Progress::line({.start = 20, .end = 120, .task = "sweep"}, 70, 0, 8, "70 of 120 samples"),
            "sweep  50 %  ETA 0:08  70 of 120 samples");
}

TEST(Progress, PlainLinesInAPipe) {
  std::FILE* stream = std::tmpfile();
  {
    Progress often({.end = 1, .stream = stream, .pipe_interval = 0});
    for (int i = 0; i < 10; ++i) often.update(0.01 * i, i);
    Progress seldom({.end = 1, .stream = stream, .pipe_interval = 1e3});
    for (int i = 0; i < 10; ++i) seldom.update(0.01 * i, i);
  }
  std::rewind(stream);
  char text[2048] = {};
  const auto size = std::fread(text, 1, sizeof text - 1, stream);
  std::fclose(stream);
  EXPECT_EQ(std::count(text, text + size, '\n'), 10);
  EXPECT_EQ(std::count(text, text + size, '\r'), 0);
}

TEST(Log, FileHoldsWhatWasShownAndWarningsAreKept) {
  const Scratch scratch;
  log::show_on_terminal(false);
  log::forget_warnings();
  log::open_file(scratch.folder() / "log.txt");
  log::info("{} openings", 5);
  log::warn("braces {{}} survive");
  log::close_file();
  log::info("not in the file");
  log::show_on_terminal(true);
  EXPECT_EQ(content(scratch.folder() / "log.txt"), "5 openings\nwarning: braces {} survive\n");
  EXPECT_THAT(log::warnings(), testing::ElementsAre("braces {} survive"));
  EXPECT_THAT(error_of([] { log::open_file("/dev/null/log.txt"); }), HasSubstr("the log cannot be written"));
}

}  // namespace
}  // namespace ostium::test
