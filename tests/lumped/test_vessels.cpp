#include "tests/lumped/support.hpp"

namespace ostium::lumped {
namespace {

const std::string rclk =
    "{type: vessel, from: A, to: B, R: 2 Pa.s/m3, C: 3 m3/Pa, L: 5 Pa.s2/m3, K: 7 Pa.s2/m6";

TEST(Vessel, EquationsWithTheLossFirst) {
  const auto b = block(rclk + "}");
  // p_from, p_to | q, q_out, u | their rates
  EXPECT_EQ(
      answer(*b, {100, 4, -2, 3, 60, 0, 0.5, 0.25}),
      (std::vector<double>{100 - 60 + (2 + 7 * 2) * 2, 5 * 0.5 - (60 - 4), 3 * 0.25 - (-2 - 3), -2, -3}));
  expect_exact_jacobian(*b, {100, 4, -2, 3, 60, 0.1, 0.5, 0.25});
  EXPECT_EQ(b->branches()[0].nature, Nature::resistive);
  EXPECT_EQ(b->branches()[1].nature, Nature::inductive);
}

TEST(Vessel, EquationsWithTheComplianceFirst) {
  const auto b = block(rclk + ", order: CRL}");
  EXPECT_EQ(
      answer(*b, {100, 4, -2, 3, 60, 0, 0.5, 0.25}),
      (std::vector<double>{100 - 60, 5 * 0.5 - (60 - 4 - (2 + 7 * 3) * 3), 3 * 0.25 - (-2 - 3), -2, -3}));
  expect_exact_jacobian(*b, {100, 4, -2, 3, 60, 0.1, 0.5, 0.25});
  EXPECT_EQ(b->branches()[0].nature, Nature::capacitive);
}

TEST(Vessel, ElementsThatAreZeroAreLeftOut) {
  const auto natures = [](const std::string& rest) {
    std::vector<Nature> all;
    for (const auto& b : block("{type: vessel, from: A, to: B, " + rest + "}")->branches())
      all.push_back(b.nature);
    return all;
  };
  using N = std::vector<Nature>;
  EXPECT_EQ(natures("R: 1 Pa.s/m3"), N{Nature::resistive});
  EXPECT_EQ(natures("R: 1 Pa.s/m3, L: 1 Pa.s2/m3"), N{Nature::inductive});
  EXPECT_EQ(natures("R: 0 Pa.s/m3"), N{Nature::pressure});
  EXPECT_EQ(natures("R: 1 Pa.s/m3, C: 1 m3/Pa"), (N{Nature::resistive, Nature::capacitive}));
  EXPECT_EQ(natures("R: 0 Pa.s/m3, C: 1 m3/Pa, L: 1 Pa.s2/m3"), (N{Nature::capacitive, Nature::inductive}));
  EXPECT_TRUE(block("{type: vessel, from: A, to: B, R: 1 Pa.s/m3}")->linear());
  EXPECT_FALSE(block(rclk + "}")->linear());
}

TEST(Rc, StoresBloodOrOnlyPressure) {
  const std::string rc = "{type: rc, from: A, to: B, R: 2 Pa.s/m3, C: 3 m3/Pa";
  EXPECT_EQ(answer(*block(rc + "}"), {60, 4, 7, 5, 60, 0, 0, 0.5}),
            (std::vector<double>{0, 5 - 56 / 2, 3 * 0.5 - (7 - 56 / 2), 7, -5}));
  EXPECT_EQ(answer(*block(rc + ", stores: false}"), {60, 4, 7, 5, 60, 0, 0, 0.5}),
            (std::vector<double>{0, 5 - 7, 3 * 0.5 - (7 - 56 / 2), 7, -5}));
  expect_exact_jacobian(*block(rc + "}"), {60, 4, 7, 5, 60, 0.1, 0.1, 0.5});
}

TEST(Coronary, Equations) {
  const auto b = block(
      "{type: coronary, from: A, to: V, ventricle: LV, share: 0.5, Ra: 2 Pa.s/m3, Ram: 4 Pa.s/m3, Rv: 8 "
      "Pa.s/m3, "
      "Ca: 3 m3/Pa, Cim: 16 m3/Pa, Pim: 10 Pa}");
  // p_from, p_to, p_ventricle | q, q_out, Pa, V | their rates
  const double p_m = 10 + 0.5 * 20 + 32.0 / 16, q_m = (90 - p_m) / 4;
  EXPECT_EQ(answer(*b, {100, 6, 20, 5, 2, 90, 32, 0, 0, 0.5, 0.25}),
            (std::vector<double>{100 - 90 - 2 * 5, 8 * 2 - (p_m - 6), 3 * 0.5 - (5 - q_m), 0.25 - (q_m - 2),
                                 5, -2, 0}));
  expect_exact_jacobian(*b, {100, 6, 20, 5, 2, 90, 32, 0.1, 0.1, 0.5, 0.25});
  EXPECT_TRUE(b->linear());
}

TEST(Coronary, StartsWithItsVeinsInBalance) {
  double y[4];
  block(
      "{type: coronary, from: A, Pd: 5 Pa, Ra: 2 Pa.s/m3, Ram: 4 Pa.s/m3, Rv: 8 Pa.s/m3, Ca: 3 m3/Pa, Cim: "
      "16 m3/Pa, "
      "Pim: 30 Pa}")
      ->initial(y);
  EXPECT_EQ(y[2], 5);
  EXPECT_EQ(y[3], 16 * (5 - 30));
}

TEST(Coronary, ArteriolesAreThrottledInSystole) {
  const auto b = block(
      "{type: coronary, from: A, Ra: 0 Pa.s/m3, Ram: 4 Pa.s/m3, Ram_max: 16 Pa.s/m3, Rv: 8 Pa.s/m3, Ca: 3 "
      "m3/Pa, "
      "Cim: 16 m3/Pa, activation: {type: piecewise_cosine, contract_start: 0 s, contract_duration: 0.3 s, "
      "relax_start: 0.3 s, relax_duration: 0.4 s, period: 1 s}}");
  EXPECT_FALSE(b->linear());
  const auto q_m = [&](double t) { return -answer(*b, {0, 0, 0, 0, 0, 90, 0, 0, 0, 0, 0}, t)[3]; };
  EXPECT_DOUBLE_EQ(q_m(0), 90.0 / 4);
  EXPECT_DOUBLE_EQ(q_m(0.15), 90.0 / 9);  // (2 + (4 - 2)/2)^2
  EXPECT_DOUBLE_EQ(q_m(0.3), 90.0 / 16);
  EXPECT_DOUBLE_EQ(q_m(0.5), 90.0 / 9);
  EXPECT_DOUBLE_EQ(q_m(0.8), 90.0 / 4);
}

}  // namespace
}  // namespace ostium::lumped
