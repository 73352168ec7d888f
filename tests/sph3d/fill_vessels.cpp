/// Public vessels filled with particles: counts, places, density at the start, first steps (reference data needed).
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "filling.hpp"
#include "sph3d/geometry/read.hpp"

namespace ostium::sph3d {
namespace {

namespace fs = std::filesystem;
const fs::path vessels = fs::path(OSTIUM_DATA_DIR) / "vessels";

struct Case {
  const char* file;
  double unit;     // m
  double spacing;  // m: five particles or more across the narrowest opening
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.file; }

class FillVessel : public testing::TestWithParam<Case> {};

constexpr double pressure = 2000;  // Pa

Vessel<3> filled(const Lumen<3>& lumen, double spacing) {
  return {lumen,
          {.dp = spacing, .density = 1060, .viscosity = 4e-6, .sound_speed = 10, .reference_speed = 1},
          std::vector<OpeningRole>(lumen.openings.size()),
          pressure};
}

void expect_rest(Vessel<3>& vessel, std::size_t particles) {
  std::vector<Drive> drives(vessel.model().ducts.size());
  for (auto& drive : drives) drive.law.p_star = pressure;
  for (int step = 0; step < 10; ++step) vessel.advance(1, drives, 0.01);
  EXPECT_EQ(vessel.state().mirrored, 0) << "nobody is put back inside the wall";
  EXPECT_EQ(vessel.state().escaped, 0);
  EXPECT_NEAR(double(vessel.state().fluid.count()), double(particles), 0.005 * double(particles));
  EXPECT_LT(vessel.state().max_speed, 0.05 * vessel.model().options.sound_speed);
}

/// Not a test: prints where the density is off at the start (--gtest_also_run_disabled_tests).
TEST_P(FillVessel, DISABLED_Table) {
  const auto [file, unit, spacing] = GetParam();
  if (!fs::exists(vessels / file)) GTEST_SKIP() << "needs the reference data at " << vessels;
  const auto vessel = filled(read_lumen({.file = vessels / file, .length_unit = unit}), spacing);
  fmt::print("{}, spacing {} mm: {}", file, 1e3 * spacing, table(measure_filling(vessel)));
}

TEST_P(FillVessel, EvenlyAndAtRest) {
  const auto [file, unit, spacing] = GetParam();
  if (!fs::exists(vessels / file)) GTEST_SKIP() << "needs the reference data at " << vessels;
  auto vessel = filled(read_lumen({.file = vessels / file, .length_unit = unit}), spacing);
  const Filling filling = measure_filling(vessel);
  SCOPED_TRACE(table(filling));
  EXPECT_NEAR(double(filling.particles), filling.expected, 0.015 * filling.expected);
  EXPECT_EQ(filling.outside, 0u);
  EXPECT_LT(filling.all.rms(), 0.01);
  expect_rest(vessel, filling.particles);
}

INSTANTIATE_TEST_SUITE_P(Public, FillVessel,
                         testing::Values(Case{"carotid_bifurcation/carotid_m.vtp", 1, 0.52e-3},
                                         Case{"tjunction_sv/two-cyls.vtp", 1e-2, 1.7e-3},
                                         Case{"bifurcation_sv_simple/bifurcation.vtp", 1e-3, 1.2e-3},
                                         Case{"abdominal_openlb/aorta3d.stl", 1e-3, 1.7e-3}));
INSTANTIATE_TEST_SUITE_P(Full,
                         FillVessel,  // slow: narrow branches of wide vessels: 14 to 61 thousand particles
                         testing::Values(Case{"carotid_bifurcation/bif_artery_mm.stl", 1e-3, 0.52e-3},
                                         Case{"iliac_sv_demo/demo.vtp", 1e-2, 1.7e-3},
                                         Case{"pulmonary_rpa_su201/SU201_2005_RPA1_exterior.vtp", 1e-3,
                                              0.23e-3},
                                         Case{"aorta_patient1/merged_ModelFaceID.vtp", 1e-3, 0.6e-3}));

/// One artery, in metres with its normals inward and in millimetres: the same number of particles in every part.
TEST(FullFilling, CarotidFromBothFilesIsTheSame) {
  if (!fs::exists(vessels)) GTEST_SKIP() << "needs the reference data at " << vessels;
  const auto fill = [](const char* file, double unit) {
    return measure_filling(filled(read_lumen({.file = vessels / file, .length_unit = unit}), 0.52e-3));
  };
  const Filling vtp = fill("carotid_bifurcation/carotid_m.vtp", 1),
                stl = fill("carotid_bifurcation/bif_artery_mm.stl", 1e-3);
  EXPECT_NEAR(double(vtp.particles), double(stl.particles), 0.002 * double(stl.particles));
  for (std::size_t k = 0; k < vtp.parts.size(); ++k) {
    if (!vtp.parts[k].part.starts_with("branch")) continue;
    EXPECT_NEAR(double(vtp.parts[k].count), double(stl.parts[k].count), 0.01 * double(stl.parts[k].count))
        << vtp.parts[k].part;
  }
}

}  // namespace
}  // namespace ostium::sph3d
