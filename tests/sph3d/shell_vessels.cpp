/// Shells on public vessels: evenness, areas, ends (reference data needed).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "core/error.hpp"
#include "sph3d/geometry/read.hpp"
#include "wall_shells.hpp"

namespace ostium::sph3d {
namespace {

namespace fs = std::filesystem;
const fs::path vessels = fs::path(OSTIUM_DATA_DIR) / "vessels";

struct WallCase {
  const char* file;
  double unit, spacing, thickness;  // m
  double tightest_bend;             // thickness over radius, allowed
};

void PrintTo(const WallCase& c, std::ostream* out) { *out << c.file; }

class FullShellVessel : public testing::TestWithParam<WallCase> {};

/// Not passing yet: curvature is taken at single points, where a segmented surface is rough, so these walls are refused.
TEST_P(FullShellVessel, DISABLED_EvenAndHeldAtItsEnds) {
  const auto [file, unit, spacing, thickness, bend] = GetParam();
  if (!fs::exists(vessels / file)) GTEST_SKIP() << "needs the reference data at " << vessels;
  const auto lumen = read_lumen({.file = vessels / file, .length_unit = unit});
  const auto start = std::chrono::steady_clock::now();
  const auto shell = shell_of(
      lumen, {.spacing = spacing, .fluid_spacing = spacing, .thickness = thickness, .tightest_bend = bend});
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const Evenness e = evenness(shell, spacing);
  fmt::print("{}: {} particles in {:.1f} s; nearest {:.3f} +- {:.3f}, least {:.3f}; areas {:.3f}\n", file,
             shell.count(), took.count(), e.nearest, e.spread, e.least, e.areas);
  EXPECT_NEAR(sum_of(shell.contact_area), lumen.wall_area, 1e-12 * lumen.wall_area);
  EXPECT_LT(e.areas, 1.5);
  EXPECT_LT(e.spread, 0.08);
  for (int k = 0; k < int(lumen.openings.size()); ++k)
    EXPECT_GT(std::count(shell.opening.begin(), shell.opening.end(), k), 3 * 8) << lumen.openings[k].name;
}

INSTANTIATE_TEST_SUITE_P(
    Public, FullShellVessel,
    testing::Values(WallCase{"carotid_bifurcation/bif_artery_mm.stl", 1e-3, 0.3e-3, 0.6e-3, 0.5},
                    WallCase{"aorta_vmr0024/aorta_vmr0024.stl", 1e-2, 1e-3, 2.5e-3, 0.8}));

}  // namespace
}  // namespace ostium::sph3d
