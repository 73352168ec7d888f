// Files that hold no vessel: each refused in a sentence, whatever is wrong with it.
#include <gmock/gmock.h>

#include <cstring>
#include <random>

#include "sph3d/geometry/write_stl.hpp"
#include "surface_files.hpp"

namespace ostium::sph3d {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(ReadLumen, ClosedWithoutOpeningIsRefused) {
  EXPECT_THAT(refusal({.file = write("sphere.stl", ascii(shapes::sphere(0.01, 4)))}),
              HasSubstr("has no opening"));
}

TEST(ReadLumen, InnerWallsAreRefusedWithTheirPlace) {
  auto tube = shapes::tube(0.01, 0.1);
  const int middle = int(tube.points.size());
  tube.points.emplace_back(0, 0, 0.05);
  for (int i = 0; i < 64; ++i) tube.facets.push_back({10 * 64 + i, 10 * 64 + (i + 1) % 64, middle});
  EXPECT_THAT(refusal({.file = write("wall.stl", ascii(tube))}),
              AllOf(HasSubstr("64 edges are shared by more than two triangles"), HasSubstr("50) mm")));
}

TEST(ReadLumen, TwoVesselsAreRefused) {
  auto two = shapes::tube(0.01, 0.1), other = two;
  const int n = int(two.points.size());
  for (const auto& x : other.points) two.points.push_back(x + Vec3(0.1, 0, 0));
  for (auto [a, b, c] : other.facets) two.facets.push_back({a + n, b + n, c + n});
  EXPECT_THAT(refusal({.file = write("two.stl", ascii(two))}), HasSubstr("2 separate shells"));
}

TEST(ReadLumen, UnreadableFiles) {
  const auto good = ascii(shapes::tube(0.01, 0.1));
  const auto binary = [](std::uint32_t count, std::size_t bytes) {
    std::string text(std::max<std::size_t>(84, bytes), '\0');
    std::memcpy(text.data() + 80, &count, 4);
    return text;
  };
  EXPECT_THAT(refusal({.file = "no/such.stl"}), HasSubstr("no/such.stl: no such file"));
  EXPECT_THAT(refusal({.file = write("a.obj", good)}),
              HasSubstr("read from .stl and .vtp files, not from \".obj\""));
  EXPECT_THAT(refusal({.file = write("empty.stl", "")}), HasSubstr("the file is empty"));
  EXPECT_THAT(refusal({.file = write("none.stl", "solid x\nendsolid x\n")}), HasSubstr("holds no triangle"));
  EXPECT_THAT(refusal({.file = write("cut.stl", good.substr(0, 10000))}), HasSubstr("truncated"));
  EXPECT_THAT(refusal({.file = write("end.stl", good.substr(0, good.size() - 20))}), HasSubstr("truncated"));
  EXPECT_THAT(refusal({.file = write("word.stl", "solid x\nfacet\nvertex 1 2 x3\nendfacet\nendsolid")}),
              HasSubstr("word.stl:3: expected a coordinate, found \"x3\""));
  EXPECT_THAT(refusal({.file = write("nan.stl", "solid x\nfacet\nvertex 1 2 nan\nendfacet\nendsolid")}),
              HasSubstr("not a finite point"));
  EXPECT_THAT(refusal({.file = write("two.stl", "solid x\nfacet\nvertex 1 2 3\nendfacet\nendsolid")}),
              HasSubstr("a facet has three vertices, this one has 1"));
  EXPECT_THAT(refusal({.file = write("short.stl", "garbage")}), HasSubstr("neither an ASCII STL"));
  EXPECT_THAT(
      refusal({.file = write("huge.stl", binary(4000000000u, 500))}),
      HasSubstr("announces 4000000000 triangles, which need 200000000084 bytes, but the file has 500"));
  EXPECT_THAT(refusal({.file = write("zero.stl", binary(0, 84))}), HasSubstr("holds no triangle"));
}

TEST(ReadLumen, UnreadableVtp) {
  const auto good = vtp(shapes::tube(0.01, 0.1));
  const auto edit = [&](const std::string& from, const std::string& to) {
    auto text = good;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_THAT(refusal({.file = write("empty.vtp", "")}), HasSubstr("the file is empty"));
  EXPECT_THAT(refusal({.file = write("garbage.vtp", "no xml at all")}), HasSubstr("not a VTP file"));
  EXPECT_THAT(refusal({.file = write("cut.vtp", good.substr(0, good.size() / 2))}), HasSubstr("damaged"));
  EXPECT_THAT(
      refusal({.file = write("huge.vtp", edit("NumberOfPoints=\"1346\"", "NumberOfPoints=\"99999999999\""))}),
      HasSubstr("announces 99999999999 Points"));
  EXPECT_THAT(refusal({.file = write("index.vtp", edit(">0 1 65", ">0 1 9965"))}),
              HasSubstr("uses the point 9965"));
  EXPECT_THAT(refusal({.file = write("few.vtp", edit("NumberOfPolys=\"2688\"", "NumberOfPolys=\"0\""))}),
              HasSubstr("holds no polygon"));
}

/// Any byte may be wrong: a sentence, never a crash.
TEST(ReadLumen, DamagedBytesNeverCrash) {
  std::mt19937 engine(11);
  const auto tube = shapes::tube(0.01, 0.1, 8, 2);
  const auto stl = temporary("good.stl");
  write_stl(tube, stl);
  std::ifstream in(stl, std::ios::binary);
  const std::string binary((std::istreambuf_iterator<char>(in)), {});
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"d.stl", ascii(tube)}, {"b.stl", binary}, {"d.vtp", vtp(tube)}})
    for (int k = 0; k < 150; ++k) {
      auto damaged = text;
      for (int n = 0; n < 3; ++n) damaged[engine() % damaged.size()] = char(engine() % 256);
      if (k % 3 == 0) damaged.resize(engine() % damaged.size());
      EXPECT_NO_THROW(refusal({.file = write(name, damaged)}));
    }
}

}  // namespace
}  // namespace ostium::sph3d
