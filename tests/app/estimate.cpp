// How long a run will take: measured speed, counted steps; and the warning of a spacing that is too coarse.
#include "app/estimate.hpp"

#include <cmath>

#include "program.hpp"

namespace ostium::app {
namespace {

using test::Outcome;
using testing::HasSubstr;
using testing::Not;

class EstimateTest : public test::ProgramTest {
 protected:
  void SetUp() override {
    ASSERT_EQ(ostium("geometry tube --radius '1.6 mm' --length '20 mm'").code, 0);
    write("case.yaml", R"(vessel:
  surface: tube.stl
  length_unit: mm
  spacing: 0.4 mm
  openings: {in: {nearest: 0 0 0 mm}, out: {nearest: 0 0 20 mm}}
network:
  blocks:
    heart: {type: flow_source, flow: 1 mL/s, to: in}
    body: {type: windkessel, from: out, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}
time: {end: 0.1 s}
)");
  }

  Estimate estimated(const std::string& key, const std::string& value, const Calibration& speed) const {
    Overrides overrides;
    overrides.values.emplace_back(key, value);
    const Case study = read_case(folder() / "case.yaml", overrides);
    return estimate(study, set_up<3>(study), speed);
  }
};

TEST_F(EstimateTest, GrowsWithTheEndTime) {
  const Calibration speed{.modelling = 0, .filling = 0, .acoustic = 2e-7, .advection = 8e-7};
  const Estimate brief = estimated("time.end", "0.1 s", speed), lasting = estimated("time.end", "1 s", speed);
  EXPECT_GT(brief.wall, 0);
  EXPECT_NEAR(lasting.wall, 10 * brief.wall, 0.01 * lasting.wall);
  EXPECT_NEAR(lasting.steps, 10 * brief.steps, 10);
  EXPECT_GE(brief.steps, brief.advection_steps);
  EXPECT_LE(brief.steps, 8 * brief.advection_steps + 8);
  const Calibration filled{.modelling = 1e-3, .filling = 1e-4, .acoustic = 2e-7, .advection = 8e-7};
  EXPECT_GT(estimated("time.end", "0.1 s", filled).wall, brief.wall + 1e-4 * brief.particles);
}

TEST_F(EstimateTest, TheMachineIsMeasured) {
  for (const int threads : {1, 2}) {
    const Calibration space = calibrate<3>(threads), plane = calibrate<2>(threads);
    for (const double seconds :
         {space.filling, space.acoustic, space.advection, plane.filling, plane.acoustic, plane.advection}) {
      EXPECT_TRUE(std::isfinite(seconds));
      EXPECT_GT(seconds, 1e-10);
      EXPECT_LT(seconds, 1e-2);
    }
  }
}

TEST_F(EstimateTest, NeverNothing) {
  const Estimate e = estimated("network.blocks.heart.flow", "1e-9 mL/s", nominal_speed(2));
  EXPECT_TRUE(std::isfinite(e.wall));
  EXPECT_GT(e.wall, 0);
  EXPECT_GE(e.steps, 1);
  for (const double seconds : {0.0, 1e-6, 0.3, 5.0, 50.0}) EXPECT_THAT(duration_text(seconds), Not("0 s"));
  EXPECT_EQ(duration_text(1e-6), "0.1 s");
  EXPECT_EQ(duration_text(4.2), "4 s");
  EXPECT_EQ(duration_text(600), "10 min");
}

TEST_F(EstimateTest, EightParticlesAcrossAreEnough) {
  EXPECT_THAT(ostium("check case.yaml").text, Not(HasSubstr("fit across")));
  EXPECT_THAT(ostium("check case.yaml --set 'vessel.spacing=0.41 mm'").text,
              HasSubstr("8 or more for good flow are needed; choose 0.4 mm or less"));
}

}  // namespace
}  // namespace ostium::app
