/// Real vessels measured by others: areas, centres and volumes of public surfaces (reference data needed).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "sph3d/geometry/read.hpp"
#include "sph3d/geometry/repair.hpp"
#include "sph3d/geometry/self_intersection.hpp"
#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/geometry/write_stl.hpp"

namespace ostium::sph3d {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
const fs::path vessels = fs::path(OSTIUM_DATA_DIR) / "vessels";

struct Vessel {
  const char *file, *expected;
  double unit;
};

void PrintTo(const Vessel& v, std::ostream* out) { *out << v.file; }

nlohmann::json expected_caps(const fs::path& file) {
  auto caps = nlohmann::json::parse(std::ifstream(file)).at("caps");
  std::sort(caps.begin(), caps.end(), [](auto& a, auto& b) {
    return a["area"].template get<double>() > b["area"].template get<double>();
  });
  return caps;
}

Vec3 vector(const nlohmann::json& j) { return {double(j[0]), double(j[1]), double(j[2])}; }

class Vessels : public testing::TestWithParam<Vessel> {};

TEST_P(Vessels, OpeningsAsMeasuredByOthers) {
  const auto [file, expected, unit] = GetParam();
  if (!fs::exists(vessels / file)) GTEST_SKIP() << "needs the reference data at " << vessels;
  const auto lumen = read_lumen({.file = vessels / file, .length_unit = unit});
  const auto caps = expected_caps(vessels / expected);
  ASSERT_EQ(lumen.openings.size(), caps.size()) << describe(lumen);
  for (std::size_t k = 0; k < caps.size(); ++k) {
    const auto& o = lumen.openings[k];
    const double size = std::sqrt(o.area);
    EXPECT_NEAR(o.area, double(caps[k]["area"]) * unit * unit, 0.01 * o.area) << o.name;
    EXPECT_LT((o.centre - unit * vector(caps[k]["centre"])).norm(), 0.05 * size) << o.name;
    EXPECT_GT(std::abs(o.normal.dot(vector(caps[k]["normal_as_stored"]).normalized())), 0.999) << o.name;
    const SignedDistance<3> distance(lumen.surface);
    EXPECT_GT(distance(o.centre + 0.1 * size * o.normal).phi, 0) << "the normal points out of the vessel";
    EXPECT_LT(distance(o.centre - 0.1 * size * o.normal).phi, 0);
    EXPECT_TRUE(inside_outline(o, o.centre));
    EXPECT_THAT(lumen.repairs, testing::Not(testing::Contains(HasSubstr("cut one another"))));
    EXPECT_LE(width(o), std::sqrt(4 * o.area / pi));
    EXPECT_GT(width(o), 0.7 * std::sqrt(4 * o.area / pi));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Public, Vessels,
    testing::Values(
        Vessel{"aorta_vmr0024/aorta_vmr0024.stl", "aorta_vmr0024/expected_aorta_vmr0024.json", 1e-2},
        Vessel{"carotid_bifurcation/carotid_m.vtp", "carotid_bifurcation/expected_carotid_m.json", 1},
        Vessel{"carotid_bifurcation/bif_artery_mm.stl", "carotid_bifurcation/expected_bif_artery_mm.json",
               1e-3},
        Vessel{"iliac_sv_demo/demo.vtp", "iliac_sv_demo/expected_demo.json", 1e-2},
        Vessel{"pulmonary_rpa_su201/SU201_2005_RPA1_exterior.vtp",
               "pulmonary_rpa_su201/expected_SU201_2005_RPA1_exterior.json", 1e-3},
        Vessel{"aorta_patient1/merged_ModelFaceID.vtp", "aorta_patient1/expected_merged_ModelFaceID.json",
               1e-3},
        Vessel{"tjunction_sv/two-cyls.vtp", "tjunction_sv/expected_two-cyls.json", 1e-2},
        Vessel{"bifurcation_sv_simple/bifurcation.vtp", "bifurcation_sv_simple/expected_bifurcation.json",
               1e-3},
        Vessel{"abdominal_openlb/aorta3d.stl", "abdominal_openlb/expected_aorta3d.json", 1e-3},
        Vessel{"pipe_rcr/pipe_exterior.vtp", "pipe_rcr/expected_pipe_exterior.json", 1e-2},
        Vessel{"pipe_rcr_deformable/pipe_exterior.vtp", "pipe_rcr_deformable/expected_pipe_exterior.json",
               1e-2},
        Vessel{"cylinder_sv/cylinder.vtp", "cylinder_sv/expected_cylinder.json", 1e-2}));

class UnlabelledVessels : public testing::TestWithParam<Vessel> {};

/// The labels thrown away (written as STL): the shape alone must show the same openings.
TEST_P(UnlabelledVessels, ShapeAloneShowsTheSameOpenings) {
  const auto [file, expected, unit] = GetParam();
  if (!fs::exists(vessels / file)) GTEST_SKIP() << "needs the reference data at " << vessels;
  const auto labelled = read_lumen({.file = vessels / file, .length_unit = unit});
  const auto stl =
      fs::temp_directory_path() / ("ostium_unlabelled_" + fs::path(file).stem().string() + ".stl");
  write_stl(labelled.surface, stl);
  const auto bare = read_lumen({.file = stl, .length_unit = 1e-3});
  ASSERT_EQ(bare.openings.size(), labelled.openings.size()) << describe(bare);
  for (std::size_t k = 0; k < bare.openings.size(); ++k)
    EXPECT_NEAR(bare.openings[k].area, labelled.openings[k].area, 0.01 * labelled.openings[k].area);
}

INSTANTIATE_TEST_SUITE_P(Public, UnlabelledVessels,
                         testing::Values(Vessel{"iliac_sv_demo/demo.vtp", "", 1e-2},
                                         Vessel{"pulmonary_rpa_su201/SU201_2005_RPA1_exterior.vtp", "", 1e-3},
                                         Vessel{"aorta_patient1/merged_ModelFaceID.vtp", "", 1e-3},
                                         Vessel{"tjunction_sv/two-cyls.vtp", "", 1e-2},
                                         Vessel{"bifurcation_sv_simple/bifurcation.vtp", "", 1e-3},
                                         Vessel{"pipe_rcr/pipe_exterior.vtp", "", 1e-2},
                                         Vessel{"cylinder_sv/cylinder.vtp", "", 1e-2}));

TEST(RealVessels, CarotidFromBothFilesIsTheSame) {
  if (!fs::exists(vessels)) GTEST_SKIP() << "needs the reference data at " << vessels;
  const auto vtp = read_lumen({.file = vessels / "carotid_bifurcation/carotid_m.vtp", .length_unit = 1});
  const auto stl =
      read_lumen({.file = vessels / "carotid_bifurcation/bif_artery_mm.stl", .length_unit = 1e-3});
  EXPECT_NEAR(vtp.volume, stl.volume, 0.002 * stl.volume);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(vtp.openings[k].area, stl.openings[k].area, 0.01 * stl.openings[k].area);
    EXPECT_LT((vtp.openings[k].centre - stl.openings[k].centre).norm(), 2e-5);
    EXPECT_GT(vtp.openings[k].normal.dot(stl.openings[k].normal), 0.9999);
  }
}

TEST(RealVessels, AortaInMetresTurnedAndInsideOut) {
  const auto file = vessels / "aorta_vmr0024/aorta_vmr0024.stl";
  if (!fs::exists(file)) GTEST_SKIP() << "needs the reference data at " << vessels;
  const auto plain = read_lumen({.file = file, .length_unit = 1e-2});
  auto surface = plain.surface;
  const Eigen::AngleAxisd turn(2.1, Vec3(-1, 0.4, 0.7).normalized());
  for (auto& x : surface.points) x = turn * x;
  for (auto& f : surface.facets) std::swap(f[0], f[1]);
  const auto stl = fs::temp_directory_path() / "ostium_aorta_turned.stl";
  write_stl(surface, stl, 1.0);
  const auto turned = read_lumen({.file = stl, .length_unit = 1});
  ASSERT_EQ(turned.openings.size(), 6u);
  EXPECT_NEAR(turned.volume, plain.volume, 1e-5 * plain.volume);
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(turned.openings[k].area, plain.openings[k].area, 1e-4 * plain.openings[k].area);
    EXPECT_LT((turned.openings[k].centre - turn * plain.openings[k].centre).norm(), 1e-6);
    EXPECT_GT(turned.openings[k].normal.dot(turn * plain.openings[k].normal), 1 - 1e-6);
  }
}

TEST(RealVessels, LabelsNameOpenings) {
  const auto file = vessels / "bifurcation_sv_simple/bifurcation.vtp";
  if (!fs::exists(file)) GTEST_SKIP() << "needs the reference data at " << vessels;
  const auto lumen =
      read_lumen({.file = file,
                  .length_unit = 1e-3,
                  .openings = {{.name = "aorta", .label = "inflow"}, {.name = "left", .label = "3"}}});
  EXPECT_EQ(lumen.openings[0].name, "aorta");
  EXPECT_EQ(lumen.openings[1].name, "left");
  EXPECT_EQ(lumen.openings[1].face_name, "lt_iliac");
  EXPECT_EQ(lumen.openings[2].name, "opening3");
}

/// Counted by others, all pairs of edge and triangle: 73.
TEST(RealVessels, SelfIntersectionsOfTheCow) {
  if (!fs::exists(vessels)) GTEST_SKIP() << "needs the reference data at " << vessels;
  Soup soup = read_vtp(vessels / "dirty/cow.vtp");
  weld(soup);
  const auto pairs = self_intersections({.points = soup.points, .facets = soup.facets, .label = {}});
  EXPECT_NEAR(double(pairs.size()), 73, 3);  // quads were cut along another diagonal
}

std::string outcome(const fs::path& file, double unit, bool cap) {
  try {
    const auto lumen = read_lumen({.file = file, .length_unit = unit, .cap_open_ends = cap});
    return std::to_string(lumen.openings.size()) + " openings\n" + describe(lumen);
  } catch (const UserError& error) {
    return error.what();
  }
}

TEST(RealVessels, DirtyOnesAreRefusedOrCapped) {
  const auto dirty = vessels / "dirty";
  if (!fs::exists(dirty)) GTEST_SKIP() << "needs the reference data at " << vessels;
  const auto aorta = dirty / "aorta-surface-open-ends.stl", ica = dirty / "ica_artery_open.vtp",
             stenosed = dirty / "stenosed_two_shells_open.stl", cow = dirty / "cow.vtp";
  EXPECT_THAT(outcome(aorta, 1e-3, false), AllOf(HasSubstr("3 open ends"), HasSubstr("15.4 mm across")));
  EXPECT_THAT(outcome(ica, 1e-3, false), AllOf(HasSubstr("3 open ends"), HasSubstr("3.12 mm across")));
  EXPECT_THAT(outcome(aorta, 1e-3, true), AllOf(HasSubstr("3 openings"), HasSubstr("was capped")));
  EXPECT_THAT(outcome(ica, 1e-3, true), AllOf(HasSubstr("3 openings"), HasSubstr("was capped")));
  EXPECT_THAT(outcome(stenosed, 1e-3, false), AllOf(HasSubstr("11 open ends"), HasSubstr("a slit")));
  EXPECT_THAT(outcome(stenosed, 1e-3, true),
              AllOf(HasSubstr("2 openings"), HasSubstr("joined to a neighbour")));
  for (bool cap : {false, true}) EXPECT_THAT(outcome(cow, 1e-2, cap), HasSubstr("has no opening"));
}

}  // namespace
}  // namespace ostium::sph3d
