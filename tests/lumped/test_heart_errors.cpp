#include <gmock/gmock.h>

#include "tests/lumped/support.hpp"

namespace ostium::lumped {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string beat = "activation: {type: half_cosine, start: 0 s, duration: 0.4 s, period: 0.8 s}";

TEST(HeartErrors, NegativeLossOfAVessel) {
  const auto text = error_of("{type: vessel, from: A, to: B, R: -2 Pa.s/m3}");
  EXPECT_THAT(text, StartsWith("case.yaml:1:"));
  EXPECT_THAT(text, HasSubstr("R is -2 Pa.s/m3, and a loss must be >= 0"));
  EXPECT_THAT(text, HasSubstr("fitted: true"));
  EXPECT_THAT(error_of("{type: vessel, from: A, to: B, R: 2 Pa.s/m3, K: -1 Pa.s2/m6}"),
              HasSubstr("K is -1 Pa.s2/m6"));
  EXPECT_EQ(error_of("{type: vessel, from: A, to: B, R: 2 Pa.s/m3, K: -1 Pa.s2/m6, fitted: true}"),
            "no error");
}

TEST(HeartErrors, UnknownOrder) {
  EXPECT_THAT(error_of("{type: vessel, from: A, to: B, R: 2 Pa.s/m3, order: LCR}"), HasSubstr("RCL"));
}

TEST(HeartErrors, ThrottlingWithoutActivation) {
  const std::string bed =
      "{type: coronary, from: A, Ra: 1 Pa.s/m3, Ram: 1 Pa.s/m3, Rv: 1 Pa.s/m3, Ca: 1 m3/Pa, Cim: 1 m3/Pa, ";
  EXPECT_THAT(error_of(bed + "Ram_max: 2 Pa.s/m3}"), HasSubstr("\"Ram_max\" needs an \"activation\""));
  EXPECT_THAT(error_of(bed + beat + "}"), HasSubstr("\"activation\" needs \"Ram_max\""));
  EXPECT_THAT(error_of(bed + "ventricle: \"\"}"), HasSubstr("the coronary has a ventricle without a name"));
  EXPECT_THAT(error_of(bed + "to: B, Pd: 1 Pa}"), HasSubstr("has `from`, `to` and `Pd`"));
}

TEST(HeartErrors, EndsOfAChamber) {
  const std::string chamber = "{type: elastance_chamber, Emin: 1 Pa/m3, Emax: 2 Pa/m3, " + beat;
  EXPECT_THAT(error_of(chamber + "}"), HasSubstr("the elastance_chamber has no `from`"));
  EXPECT_THAT(error_of(chamber + ", from: A, to: B}"), HasSubstr("has a `to` but no inertance `L`"));
  EXPECT_THAT(error_of(chamber + ", from: A, L: 1 Pa.s2/m3}"),
              HasSubstr("an inertance `L` but no node `to`"));
  EXPECT_THAT(error_of("{type: elastance_chamber, from: A, Emin: 1 Pa/m3, Emax: 2 Pa/m3}"),
              HasSubstr("activation"));
}

TEST(HeartErrors, TimesOfASphere) {
  const auto text = error_of(
      "{type: sphere_chamber, from: LV, rho: 1000 kg/m3, d0: 10 mm, r0: 50 mm, W1: 10 kPa, W2: 40 Pa, eta: "
      "10 Pa.s, "
      "sigma_max: 185 kPa, alpha_max: 30 1/s, alpha_min: -30 1/s, t_systole: 0.5 s, t_diastole: 0.4 s, "
      "steepness: 0.005 "
      "s, period: 1 s}");
  EXPECT_THAT(text,
              HasSubstr("t_systole = 0.5 s, t_diastole = 0.4 s and period = 1 s must grow in this order"));
}

TEST(HeartErrors, ValvesThatCannotBe) {
  EXPECT_THAT(error_of("{type: valve, from: A, to: B, R: 0 Pa.s/m3}"),
              HasSubstr("a resistance \"R\" or an inertance"));
  EXPECT_THAT(error_of("{type: valve, from: A, to: B, R: 5 Pa.s/m3, R_closed: 4 Pa.s/m3}"),
              HasSubstr("\"R_closed\" is 4 Pa.s/m3 and must be larger than \"R\" = 5 Pa.s/m3"));
  EXPECT_THAT(error_of("{type: valve, from: A, to: B, R: 5 Pa.s/m3, L: 1 Pa.s2/m3, initial_flow: -1 m3/s}"),
              HasSubstr("must be >= 0 m3/s"));
  EXPECT_THAT(
      error_of("{type: orifice_valve, from: A, to: B, A_open: 1 cm2, A_closed: 2 cm2, l: 1 cm, K_open: 1 "
               "1/(Pa.s), K_close: 1 1/(Pa.s)}"),
      HasSubstr("must be smaller than \"A_open\""));
}

}  // namespace
}  // namespace ostium::lumped
