// A run tells at its end that the flow beside the wall is not resolved, once; a finer one is silent.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "program.hpp"

namespace ostium::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// Flow that swings in a channel 1 mm wide: the layer sqrt(2 nu/omega) is 0.16 mm thick.
std::string swinging(int across) {
  return fmt::format(R"(vessel:
  dimension: 2
  outline: [[0 mm, 0 mm], [4 mm, 0 mm], [4 mm, 1 mm], [0 mm, 1 mm]]
  spacing: {} mm
  openings: {{inlet: {{edge: 3}}, outlet: {{edge: 1}}}}
fluid: {{density: 1000 kg/m3, viscosity: 4 mPa.s, sound_speed: 1.5 m/s}}
network:
  blocks:
    heart:
      type: pressure_source
      to: inlet
      pressure: {{fourier: {{mean: 100, cos: [0], sin: [25]}}, unit: Pa, period: 20 ms}}
    rest: {{type: pressure_source, from: outlet, pressure: 100 Pa}}
time: {{period: 20 ms, cycles: 2}}
output: {{fields_every: 20 ms}}
)",
                     1.0 / across);
}

class UnresolvedWalls : public ProgramTest {
 protected:
  /// How often the terminal, the log and the summary tell it.
  std::array<int, 3> told(const std::string& terminal) const {
    const std::string sentence = "the flow beside the wall is not resolved";
    const auto times = [&](const std::string& text) {
      int n = 0;
      for (auto at = text.find(sentence); at != text.npos; at = text.find(sentence, at + 1)) ++n;
      return n;
    };
    const auto summary = nlohmann::json::parse(content("results/summary.json"));
    return {times(terminal), times(content("results/log.txt")), times(summary.at("warnings").dump())};
  }
};

TEST_F(UnresolvedWalls, AreToldOnceWithShareSpotAndRemedy) {
  write("case.yaml", swinging(8));
  const Outcome outcome = ostium("run case.yaml -o results");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_EQ(told(outcome.text), (std::array{1, 1, 1})) << outcome.text;
  EXPECT_THAT(outcome.text,
              testing::ContainsRegex("on 9[0-9] % of the wall its shear stress by the forces differs by more "
                                     "than a tenth from that by the velocity gradient, most at \\("));
  EXPECT_THAT(outcome.text,
              AllOf(HasSubstr(" Pa; for wall shear stress set vessel.spacing to 0.062 mm or less")));
}

TEST_F(UnresolvedWalls, AreNotToldWithTheSpacingProposed) {
  write("case.yaml", swinging(16));
  const Outcome outcome = ostium("run case.yaml -o results");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_EQ(told(outcome.text), (std::array{0, 0, 0})) << outcome.text;
}

}  // namespace
}  // namespace ostium::test
