// Public vessels through `check` and `preview`: the openings others measured, one picture each (reference data needed).
#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>

#include "program.hpp"

namespace ostium::test {
namespace {

const std::filesystem::path vessels = std::filesystem::path(OSTIUM_DATA_DIR) / "vessels";

struct PublicVessel {
  const char *surface, *expected, *unit;
  double square;        // mm2 per square of the unit
  const char* spacing;  // five particles or more across the narrowest opening
};

const PublicVessel all[] = {
    {"carotid_bifurcation/carotid_m.vtp", "carotid_bifurcation/expected_carotid_m.json", "m", 1e6, "0.52 mm"},
    {"carotid_bifurcation/bif_artery_mm.stl", "carotid_bifurcation/expected_bif_artery_mm.json", "mm", 1,
     "0.52 mm"},
    {"iliac_sv_demo/demo.vtp", "iliac_sv_demo/expected_demo.json", "cm", 100, "1.7 mm"},
    {"pulmonary_rpa_su201/SU201_2005_RPA1_exterior.vtp",
     "pulmonary_rpa_su201/expected_SU201_2005_RPA1_exterior.json", "mm", 1, "0.23 mm"},
    {"aorta_patient1/merged_ModelFaceID.vtp", "aorta_patient1/expected_merged_ModelFaceID.json", "mm", 1,
     "0.6 mm"},
    {"tjunction_sv/two-cyls.vtp", "tjunction_sv/expected_two-cyls.json", "cm", 100, "1.7 mm"},
    {"bifurcation_sv_simple/bifurcation.vtp", "bifurcation_sv_simple/expected_bifurcation.json", "mm", 1,
     "1.2 mm"},
    {"abdominal_openlb/aorta3d.stl", "abdominal_openlb/expected_aorta3d.json", "mm", 1, "1.7 mm"}};

class PublicVessels : public ProgramTest {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(vessels)) GTEST_SKIP() << "needs the reference data at " << vessels;
  }

  /// Areas measured by others, mm2, falling.
  static std::vector<double> areas(const PublicVessel& vessel) {
    std::vector<double> areas;
    const auto measured = nlohmann::json::parse(std::ifstream(vessels / vessel.expected));
    for (const auto& cap : measured.at("caps")) areas.push_back(cap["area"].get<double>() * vessel.square);
    std::sort(areas.rbegin(), areas.rend());
    return areas;
  }

  /// A flow into the widest opening, resistances at the others.
  void write_case(const PublicVessel& vessel) const {
    std::ostringstream text;
    text << "title: A public vessel\nvessel:\n  surface: " << (vessels / vessel.surface).string()
         << "\n  length_unit: " << vessel.unit << "\n  spacing: " << vessel.spacing
         << "\nfluid: {density: 1060 kg/m3, viscosity: 4 mPa.s}\nnetwork:\n  blocks:\n"
         << "    heart: {type: flow_source, to: opening1, flow: 1 mL/s}\n";
    for (std::size_t k = 2; k <= areas(vessel).size(); ++k)
      text << "    bed" << k << ": {type: resistor, from: opening" << k
           << ", R: 1e9 Pa.s/m3, ground: 0 mmHg}\n";
    text << "time: {end: 0.1 s}\n";
    write("case.yaml", text.str());
  }
};

/// The areas in the table of openings, in its order, mm2.
std::vector<double> areas_in(const std::string& text) {
  const std::regex row("opening[0-9]+ +([0-9.e+]+) ");
  std::vector<double> areas;
  for (std::sregex_iterator it(text.begin(), text.end(), row), end; it != end; ++it)
    areas.push_back(std::stod((*it)[1]));
  return areas;
}

TEST_F(PublicVessels, Check) {
  for (const auto& vessel : all) {
    SCOPED_TRACE(vessel.surface);
    write_case(vessel);
    const Outcome outcome = ostium("check case.yaml");
    ASSERT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_THAT(outcome.text, testing::HasSubstr("area mm2"));
    const auto found = areas_in(outcome.text), expected = areas(vessel);
    ASSERT_EQ(found.size(), expected.size()) << outcome.text;
    for (std::size_t k = 0; k < found.size(); ++k)
      EXPECT_NEAR(found[k], expected[k], 0.01 * expected[k]) << "opening" << k + 1;
  }
}

TEST_F(PublicVessels, Preview) {
  for (const auto& vessel : all) {
    SCOPED_TRACE(vessel.surface);
    write_case(vessel);
    const Outcome outcome = ostium("preview case.yaml -o picture.png");
    if (outcome.code == 2 && outcome.text.find("Xvfb") != std::string::npos)
      GTEST_SKIP() << "no display: " << outcome.text;
    ASSERT_EQ(outcome.code, 0) << outcome.text;
    EXPECT_EQ(content("picture.png").substr(1, 3), "PNG");
    EXPECT_GT(content("picture.png").size(), 40000u) << "an empty picture is smaller";
  }
}

}  // namespace
}  // namespace ostium::test
