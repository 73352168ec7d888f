// Surfaces that are open: refused, or capped on request.
#include <gmock/gmock.h>

#include "surface_files.hpp"

namespace ostium::sph3d {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

Surface<3> open_tube() {
  auto tube = shapes::tube(0.01, 0.1);
  std::vector<std::array<int, 3>> kept;
  for (std::size_t f = 0; f < tube.facets.size(); ++f)
    if (tube.label[f] != 1) kept.push_back(tube.facets[f]);
  tube.facets = kept;
  return tube;
}

TEST(ReadLumen, OpenEndsAreRefusedWithPlaceAndSize) {
  const auto text = refusal({.file = write("open.stl", ascii(open_tube()))});
  EXPECT_THAT(
      text, AllOf(HasSubstr("open.stl: the surface is open: 1 open end (at (0, 0, 100) mm, 20 mm across, 64 "
                            "edges)"),
                  HasSubstr("cap_open_ends: true")));
}

TEST(ReadLumen, OpenEndsAreCappedOnRequest) {
  const auto lumen = read_lumen({.file = write("open.stl", ascii(open_tube())), .cap_open_ends = true});
  expect_tube(lumen, 0.01, 0.1);
  EXPECT_THAT(lumen.repairs, Contains(HasSubstr("20 mm across, was capped")));
}

TEST(ReadLumen, SmallHolesBecomeWallWhenEndsAreCapped) {
  auto tube = open_tube();
  tube.facets.erase(tube.facets.begin() + 500);
  const auto lumen = read_lumen({.file = write("open.stl", ascii(tube)), .cap_open_ends = true});
  expect_tube(lumen, 0.01, 0.1);
  EXPECT_THAT(lumen.repairs, Contains(HasSubstr("1 small holes were closed with wall")));
}

TEST(ReadLumen, RoundedSeamsAreJoinedWhenEndsAreCapped) {
  const auto tube = shapes::tube(0.01, 0.1);
  auto lower = tube, upper = tube;
  lower.facets.clear(), upper.facets.clear();
  for (const auto& f : tube.facets) {
    const bool low = tube.points[f[0]].z() + tube.points[f[1]].z() + tube.points[f[2]].z() < 0.15 - 1e-9;
    (low ? lower : upper).facets.push_back(f);
  }
  for (auto& x : upper.points) x.x() += 1e-9;
  auto both = ascii(lower) + ascii(upper);
  const auto file = write("seam.stl", both);
  EXPECT_THAT(refusal({.file = file}), HasSubstr("2 open ends"));
  const auto lumen = read_lumen({.file = file, .cap_open_ends = true});
  expect_tube(lumen, 0.01, 0.1);
  EXPECT_THAT(lumen.repairs, Contains(HasSubstr("64 corners of open edges joined")));
}

}  // namespace
}  // namespace ostium::sph3d
