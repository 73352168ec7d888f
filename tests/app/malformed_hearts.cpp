// Chambers, activations and valves.
#include "malformed.hpp"

namespace ostium::test {
namespace {

class MalformedHeart : public MalformedCase {};
TEST_P(MalformedHeart, IsRefused) { refuse(); }

const std::string filling = "p: {type: pressure_source, to: V, pressure: 8 mmHg}";
const std::string mitral = "m: {type: valve, from: V, to: LV, R: 1e6 Pa.s/m3}";
const std::string aortic = "a: {type: valve, from: LV, to: A, R: 1e6 Pa.s/m3}";

/// A chamber in line 7.
Malformed chamber(const std::string& name, const std::string& block, const std::string& key,
                  const std::string& says) {
  return {name,
          network_of({filling, mitral, aortic, bed, "h: {" + block + "}"}),
          {"case.yaml:7:", "network.blocks.h" + key, says}};
}

const std::string elastance = "type: elastance_chamber, from: LV, Emin: 1e7 Pa/m3, Emax: 3e8 Pa/m3, ";
const std::string exponential =
    "type: exponential_chamber, from: LV, Emax: 3e8 Pa/m3, P0: 10 Pa, k: 2e4 1/m3, V0: 10 mL, ";
const std::string sphere =
    "type: sphere_chamber, from: LV, rho: 1000 kg/m3, d0: 10 mm, r0: 50 mm, W1: 10 kPa, W2: 40 Pa, eta: 10 "
    "Pa.s, "
    "sigma_max: 185 kPa, alpha_max: 30 1/s, alpha_min: -30 1/s, t_systole: 0.2 s, t_diastole: 0.4 s, "
    "steepness: 5 ms, ";
const std::string beat = "activation: {type: half_cosine, start: 0 s, duration: 0.3 s, period: 0.8 s}";

Malformed beating(const std::string& name, const std::string& activation, const std::string& key,
                  const std::string& says) {
  return chamber(name, elastance + "activation: " + activation, key, says);
}

INSTANTIATE_TEST_SUITE_P(
    Chambers, MalformedHeart,
    testing::Values(
        chamber("ElastanceThatFallsInSystole",
                "type: elastance_chamber, from: LV, Emin: 3e8 Pa/m3, Emax: 1e7 Pa/m3, " + beat, ": ",
                "\"Emin\" is 3e+08 Pa/m3 and must be smaller than \"Emax\" = 1e+07 Pa/m3"),
        chamber("ElastanceOfZero",
                "type: elastance_chamber, from: LV, Emin: 0 Pa/m3, Emax: 1e7 Pa/m3, " + beat,
                ".Emin: ", "> 0 Pa/m3"),
        chamber("ExponentialOfNegativeVolume", exponential + "initial_volume: -5 Pa, " + beat,
                ".initial_volume: ", "converts to m3"),
        chamber("ExponentialWithoutActivation",
                "type: exponential_chamber, from: LV, Emax: 3e8 Pa/m3, P0: 10 Pa, k: 2e4 "
                "1/m3, V0: 10 mL",
                ": ", "the key \"activation\" is missing"),
        chamber("SphereThatNeverRelaxes", sphere + "period: 0.4 s", ": ", "must grow in this order"),
        chamber("SphereWithoutPeriod", sphere + "perod: 0.8 s", ".perod: ", "did you mean \"period\"?"),
        chamber("ChamberWithInertanceIntoNothing", elastance + "L: 1e4 Pa.s2/m3, " + beat, ": ",
                "has an inertance `L` but no node `to`")),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Activations, MalformedHeart,
    testing::Values(
        beating("HalfCosineLongerThanTheBeat",
                "{type: half_cosine, start: 0 s, duration: 3 s, period: 0.8 s}",
                ".activation: ", "\"duration\" is 3 s, longer than the period of 0.8 s"),
        beating("HalfCosineOfAMisspeltStart",
                "{type: half_cosine, strat: 0 s, duration: 0.3 s, period: 0.8 s}",
                ".activation.strat: ", "did you mean \"start\"?"),
        beating("HalfCosineEveryNanosecond",
                "{type: half_cosine, start: 0 s, duration: 1e-10 s, period: 1e-9 s}",
                ".activation.period: ", "at most 1e+06 times are allowed; look at its unit"),
        beating("HalfCosineBesideTheBeat", "{type: half_cosine, start: 0 s, duration: 0.3 s, period: 0.7 s}",
                ".activation.period: ", "0.7 s does not divide the period of the beat, 0.8 s (time.period)"),
        beating("PiecewiseTooLong",
                "{type: piecewise_cosine, contract_start: 0 s, contract_duration: 0.5 s, relax_start: "
                "0.2 s, relax_duration: 0.5 s, period: 0.8 s}",
                ".activation: ", "longer than the period"),
        beating("PiecewiseWithoutFall",
                "{type: piecewise_cosine, contract_start: 0 s, contract_duration: 0.5 s, period: "
                "0.8 s}",
                ".activation: ", "needs \"relax_start\""),
        beating("HillOfAnInstant",
                "{type: double_hill, start: 0 s, tau_1: 1e-29 s, tau_2: 1e-29 s, m1: 20, m2: 20, "
                "period: 0.8 s}",
                ": ", "has a double_hill activation that never rises"),
        beating("HillOfNegativePower",
                "{type: double_hill, start: 0 s, tau_1: 0.2 s, tau_2: 0.4 s, m1: -1, m2: 20, "
                "period: 0.8 s}",
                ".activation.m1: ", "it must be > 0"),
        beating("WrappingWithoutEnd", "{type: wrapping_cosine, duration: 0.3 s, period: 0.8 s}",
                ".activation: ", "needs \"end\""),
        beating("WrappingWithStart",
                "{type: wrapping_cosine, start: 0 s, end: 0.1 s, duration: 0.3 s, period: 0.8 s}",
                ".activation: ", "has no key \"start\""),
        beating("FourierOfMillions", "{type: fourier, mean: 1e6, cos: [1], period: 0.8 s}", ": ",
                "it must run between 0 (at rest) and 1"),
        beating("FourierWithoutMean", "{type: fourier, cos: [1], period: 0.8 s}",
                ".activation: ", "needs \"mean\""),
        beating("TableOfPressures",
                "{type: table, table: {times: [0, 1], values: [1, 0], unit: Pa, time_unit: s}}",
                ".activation.table.values.1: ", "the unit \"Pa\" has the wrong dimension"),
        beating("TableThatStands",
                "{type: table, table: {times: [0, 0], values: [1, 0], unit: 1, time_unit: s}}",
                ".activation.table: ", "times must increase"),
        beating("AWord", "half_cosine", ".activation: ", "expected a mapping with the keys type, period")),
    name_of);

/// A valve in line 4.
Malformed valve(const std::string& name, const std::string& block, const std::string& key,
                const std::string& says) {
  return {name,
          network_of({filling, "v: {" + block + "}", bed}),
          {"case.yaml:4:", "network.blocks.v" + key, says}};
}

INSTANTIATE_TEST_SUITE_P(
    Valves, MalformedHeart,
    testing::Values(
        valve("IdealWithoutAnything", "type: valve, from: V, to: A, R: 0 Pa.s/m3", ": ",
              "an open valve needs a resistance \"R\" or an inertance \"L\" > 0"),
        valve("IdealThatLeaksMoreThanItPasses",
              "type: valve, from: V, to: A, R: 1e6 Pa.s/m3, R_closed: 1e5 Pa.s/m3", ": ",
              "must be larger than \"R\""),
        valve("SmoothThatIsOpenWhenClosed",
              "type: smooth_valve, from: V, to: A, Rmin: 1e11 Pa.s/m3, Rmax: 1e10 Pa.s/m3, "
              "k: 1 1/Pa",
              ": ", "\"Rmin\" is 1e+11 Pa.s/m3 and must be smaller than \"Rmax\""),
        valve("SmoothOfNegativeSteepness",
              "type: smooth_valve, from: V, to: A, Rmin: 1e6 Pa.s/m3, Rmax: 1e10 Pa.s/m3, "
              "k: -1 1/Pa",
              ".k: ", "> 0 1/Pa"),
        valve("OrificeOfALength",
              "type: orifice_valve, from: V, to: A, A_open: 4 cm, A_closed: 0.01 cm2, l: 1 cm, K_open: "
              "0.01 1/(Pa.s), K_close: 0.01 1/(Pa.s)",
              ".A_open: ", "converts to m2, such as cm2, mm2"),
        valve("OrificeMoreThanOpen",
              "type: orifice_valve, from: V, to: A, A_open: 4 cm2, A_closed: 0.01 cm2, l: 1 cm, "
              "K_open: 0.01 1/(Pa.s), K_close: 0.01 1/(Pa.s), initial_opening: 2",
              ".initial_opening: ", ">= 0 and <= 1")),
    name_of);

}  // namespace
}  // namespace ostium::test
