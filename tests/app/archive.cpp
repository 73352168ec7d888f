// Archives in HDF5: what is written is read back to the bit, and what does not fit is refused.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "app/checkpoint/hdf5_archive.hpp"
#include "core/error.hpp"

namespace ostium::app {
namespace {

using testing::HasSubstr;

struct Pair {
  float a, b;
};

struct Sample {
  double x = 0;
  std::int64_t n = 0;
  bool on = false;
  std::string text{};
  std::vector<double> numbers{}, none{};
  std::vector<std::uint8_t> bytes{};
  std::vector<Pair> pairs{};
  std::vector<std::vector<double>> lists{};
};

void archive(Archive& a, Sample& s) {
  a("x", s.x);
  a.part("inner", [&] {
    a("n", s.n);
    a.part("deeper", [&] { a("on", s.on); });
    a("text", s.text);
  });
  a("numbers", s.numbers);
  a("none", s.none);
  a("bytes", s.bytes);
  a.records<float>("pairs", s.pairs);
  a.list("lists", s.lists, [&](std::vector<double>& list) { a("list", list); });
}

Sample example() {
  Sample s{.x = 0.1, .n = -7, .on = true, .text = "a Windkessel", .numbers = {1.0 / 3, -0.0, 5e-324}};
  s.bytes.assign(5000, 3);
  for (int i = 0; i < 3000; ++i) s.pairs.push_back({0.1f * i, -1.0f / (1 + i)});
  s.lists = {{1}, {}, {2, 3}};
  return s;
}

class ArchiveFile : public testing::Test {
 protected:
  ArchiveFile() {
    Sample s = example();
    Hdf5Writer writer(file_);
    archive(writer, s);
    writer.finish();
  }
  ~ArchiveFile() override { std::filesystem::remove(file_); }

  template <class Read>
  std::string refusal(Read read) const {
    try {
      Hdf5Reader reader(file_);
      read(reader);
    } catch (const UserError& e) {
      return e.what();
    }
    return "nothing";
  }

  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("ostium_archive_" + std::to_string(getpid()) + ".h5");
};

TEST_F(ArchiveFile, ReadsBackToTheBit) {
  Hdf5Reader reader(file_);
  Sample s{.none = {1, 2}};
  archive(reader, s);
  const Sample wanted = example();
  EXPECT_EQ(s.x, wanted.x);
  EXPECT_EQ(s.n, wanted.n);
  EXPECT_TRUE(s.on);
  EXPECT_EQ(s.text, wanted.text);
  EXPECT_EQ(s.numbers, wanted.numbers);
  EXPECT_TRUE(std::signbit(s.numbers[1]));
  EXPECT_TRUE(s.none.empty());
  EXPECT_EQ(s.bytes, wanted.bytes);
  EXPECT_EQ(s.lists, wanted.lists);
  ASSERT_EQ(s.pairs.size(), wanted.pairs.size());
  for (std::size_t i = 0; i < s.pairs.size(); ++i) EXPECT_EQ(s.pairs[i].b, wanted.pairs[i].b);
}

TEST_F(ArchiveFile, WhatDoesNotFitIsRefused) {
  double x;
  std::vector<double> numbers;
  std::vector<std::array<float, 3>> triples;
  EXPECT_THAT(refusal([&](Archive& a) { a.part("inner", [&] { a("y", x); }); }),
              HasSubstr("this checkpoint is damaged or of another kind: /inner/y: it is missing"));
  EXPECT_THAT(refusal([&](Archive& a) { a("numbers", x); }), HasSubstr("/numbers: 3 numbers instead of one"));
  EXPECT_THAT(refusal([&](Archive& a) { a("bytes", numbers); }),
              HasSubstr("/bytes: numbers of another kind"));
  EXPECT_THAT(refusal([&](Archive& a) { a.records<float>("pairs", triples); }),
              HasSubstr("/pairs: records of 2 numbers, this program has 3"));
}

TEST_F(ArchiveFile, DamageIsNoticed) {
  const auto size = std::filesystem::file_size(file_);
  std::string all(size, ' ');
  std::ifstream(file_, std::ios::binary).read(all.data(), static_cast<std::streamsize>(size));
  const auto everything = [](Archive& a) {
    Sample s;
    archive(a, s);
  };
  const std::string bytes(100, 3);
  std::string changed = all;
  changed[changed.find(bytes) + 50] ^= 4;
  std::ofstream(file_, std::ios::binary) << changed;
  EXPECT_THAT(refusal(everything), HasSubstr("/bytes: its checksum does not fit"));
  std::ofstream(file_, std::ios::binary) << all.substr(0, size / 2);
  EXPECT_THAT(refusal(everything), HasSubstr("this checkpoint is damaged or no checkpoint at all"));
  std::ofstream(file_, std::ios::binary) << "no HDF5";
  EXPECT_THAT(refusal(everything), HasSubstr("start the run anew without --resume"));
}

TEST_F(ArchiveFile, AnUnfinishedFileLeavesTheOldOne) {
  {
    Hdf5Writer writer(file_);
    double x = 2;
    writer("x", x);
  }
  EXPECT_FALSE(std::filesystem::exists(file_.string() + ".part"));
  Hdf5Reader reader(file_);
  double x = 0;
  reader("x", x);
  EXPECT_EQ(x, 0.1);
}

}  // namespace
}  // namespace ostium::app
