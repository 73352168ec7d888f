#include "tests/coupling/acoustic_pipe.hpp"
#include "tests/coupling/support.hpp"

namespace ostium::coupling {
namespace {

/// A plane channel of 6.35 x 31.75 mm (per metre of depth), c = 10 m/s: Zc = 1.575e6, transit 3.2 ms.
constexpr double Zc = 1000 * 10 / 6.35e-3;
const OneMinusCosine inflow{.mean = 0.75e-3};
Rcr windkessel(double Rp_over_Zc) { return {.Rp = Rp_over_Zc * Zc, .C = 1.96e-7, .Rd = 6.85e6}; }

struct Outcome {
  double error = 0;  // largest pressure error of the second half, over the largest exact pressure
  bool stopped_early = false;
};

Outcome run(SchemeKind kind, double Rp_over_Zc, double window, std::optional<double> filter_time = {},
            double bias = 1) {
  const Rcr w = windkessel(Rp_over_Zc);
  auto network = network_of(w.yaml(), {{"A", 6.35e-3}});
  auto scheme = make_scheme(kind, network);
  PipeSetup setup{
      .inflow = [](double t) { return inflow.flow(t); }, .window = window, .filter_time = filter_time};
  setup.bias = bias;
  double worst = 0, top = 0;
  const auto samples = AcousticPipe(setup, network, *scheme).run(1e9);
  for (const auto& s : samples) {
    const double exact = inflow.pressure(w, s.time);
    if (s.time > 0.3) worst = std::max(worst, std::abs(s.pressure - exact));
    top = std::max(top, std::abs(exact));
  }
  return {worst / top, samples.back().time < 0.55};
}

bool blows_up(const Outcome& o) { return o.stopped_early || o.error > 10; }

const std::vector<double> resistances{0.1, 0.2, 0.9, 1.1, 3, 10};
const std::vector<double> windows{0, 1e-3, 3e-3, 20e-3};

/// What is left is the storage of the fluid itself, C_f, which grows with Rp and not with the window.
TEST(Schemes, LinearisedIsStableForEveryResistanceAndWindow) {
  for (double r : resistances)
    for (double w : windows)
      EXPECT_LT(run(SchemeKind::linearised, r, w).error, 0.01 + 0.011 * r) << r << " " << w;
}

TEST(Schemes, LinearisedWithFilterIsStableForEveryResistanceAndWindow) {
  for (double r : resistances)
    for (double w : windows) {
      const double filter = std::max(0.01, 5 * w);
      EXPECT_LT(run(SchemeKind::linearised, r, w, filter).error, 0.04 + 0.012 * r) << r << " " << w;
    }
}

TEST(Schemes, TheFilterTakesTheBiasOutOfTheConjugateFlow) {
  const double without = run(SchemeKind::linearised, 3, 1e-3, {}, 0.77).error;
  const double with = run(SchemeKind::linearised, 3, 1e-3, 0.02, 0.77).error;
  EXPECT_LT(with, 0.05);
  EXPECT_GT(without, 2 * with);
}

/// Rows: Rp/Zc; columns: every step, 1 ms, 3 ms, 20 ms.
TEST(Schemes, HeldBlowsUpWhereTheTheorySaysSo) {
  const std::vector<std::vector<bool>> grows{{false, false, false, false}, {false, false, false, false},
                                             {false, true, true, false},   {false, true, true, false},
                                             {false, true, true, true},    {true, true, true, true}};
  for (size_t i = 0; i < resistances.size(); ++i)
    for (size_t j = 0; j < windows.size(); ++j)
      EXPECT_EQ(blows_up(run(SchemeKind::held, resistances[i], windows[j])), grows[i][j])
          << resistances[i] << " " << windows[j];
}

TEST(Schemes, HeldGrowsSlowlyAtAFifthOfTheImpedance) {
  EXPECT_GT(run(SchemeKind::held, 0.2, 1e-3).error, 0.5);
  EXPECT_LT(run(SchemeKind::held, 0.1, 1e-3).error, 0.02);
}

TEST(Schemes, ExtrapolatedIsBetterInPhaseAndWorseInStability) {
  EXPECT_LT(run(SchemeKind::extrapolated, 0.1, 20e-3).error, 0.3 * run(SchemeKind::held, 0.1, 20e-3).error);
  EXPECT_TRUE(blows_up(run(SchemeKind::extrapolated, 1.1, 20e-3)));
  EXPECT_FALSE(blows_up(run(SchemeKind::held, 1.1, 20e-3)));
}

TEST(Schemes, ModifiedEulerIsStableWhereItWasPublished) {
  EXPECT_LT(run(SchemeKind::modified_euler, 0.965, 20e-3).error, 0.1);
  EXPECT_TRUE(blows_up(run(SchemeKind::modified_euler, 0.965, 1e-3)));
}

/// One step by hand, from P = 100 + Pd with Q going from 0 to 2e-6 in 20 ms.
TEST(Schemes, ModifiedEulerTakesHeunsStep) {
  auto network = network_of(
      "w: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 1e-9 m3/Pa, Rd: 1e8 Pa.s/m3, Pd: 30 Pa, "
      "initial_pressure: 130 Pa}\n",
      {{"A", 1e-4}});
  auto scheme = make_scheme(SchemeKind::modified_euler, network);
  EXPECT_NEAR(scheme->start(network, 0.02)[0].p_star, 130, 1e-9);
  const double Q[] = {2e-6}, tau = 0.02, T = 0.1;
  const auto rate = [&](double P) { return -P / T + 1.1e8 / T * 2e-6 + 1e7 * 2e-6 / tau; };
  const double k1 = rate(100), k2 = rate(100 + tau * k1);
  EXPECT_NEAR(scheme->exchange(network, tau, Q)[0].p_star, 30 + 100 + 0.5 * tau * (k1 + k2), 1e-9);
}

TEST(Schemes, ModifiedEulerRefusesWhatIsNoWindkessel) {
  auto network = network_of("out: {type: resistor, from: A, ground: 0 Pa, R: 1 Pa.s/m3}\n", {{"A", 1e-4}});
  try {
    make_scheme(SchemeKind::modified_euler, network);
    FAIL();
  } catch (const UserError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("knows only openings with a single windkessel"));
    EXPECT_THAT(e.what(), testing::HasSubstr("use `scheme: linearised`"));
  }
}

TEST(Schemes, LawOfAWindkessel) {
  const Rcr w{.Rp = 1e7, .C = 1e-9, .Rd = 1e8, .start = 500};
  auto network = network_of(w.yaml(), {{"A", 1e-4}});
  auto scheme = make_scheme(SchemeKind::linearised, network);
  scheme->start(network, 1e-3);
  const double Q[] = {8e-6};
  const auto law = scheme->exchange(network, 1e-3, Q)[0];
  EXPECT_NEAR(law.p_star, network.pressure(0), 1e-12);
  EXPECT_NEAR(law.slope, (8e-6 - (law.p_star - 80) / 1e8) / 1e-9, 1e-6 * std::abs(law.slope));
  EXPECT_NEAR(law.resistance, 1e7 - 1e8 * std::expm1(-0.01), 1);
  EXPECT_EQ(law.q_star, 8e-6);
}

/// Ports that see each other at once: the law of each must dominate what its neighbours do a window late.
TEST(Schemes, LinearisedSumsTheRowOfNeighbours) {
  auto network = network_of(
      "a: {type: resistor, from: A, to: V, R: 1e7 Pa.s/m3}\nb: {type: resistor, from: B, to: V, R: 2e7 "
      "Pa.s/m3}\nv: {type: resistor, from: V, ground: 0 Pa, R: 5e7 Pa.s/m3}\n",
      {{"A", 1e-4}, {"B", 1e-4}});
  const auto laws = make_scheme(SchemeKind::linearised, network)->start(network, 1e-3);
  EXPECT_NEAR(laws[0].resistance, 6e7 + 5e7, 1);
  EXPECT_NEAR(laws[1].resistance, 7e7 + 5e7, 1);
}

/// Three long lines (Q = Q_wave - P/Zc) into one network whose shared resistor makes every port answer the others.
/// With the diagonal of R alone each exchange would multiply a common disturbance by -2 * 10/(1 + 10.1).
TEST(Schemes, NeighboursWithOneSharedResistorConverge) {
  const double r = 0.1 * Zc, shared = 10 * Zc, wave = 1e-5;
  std::string yaml = fmt::format("v: {{type: resistor, from: V, ground: 0 Pa, R: {} Pa.s/m3}}\n", shared);
  for (char port : {'A', 'B', 'D'})
    yaml += fmt::format("{0}_r: {{type: resistor, from: {0}, to: V, R: {1} Pa.s/m3}}\n", port, r);
  auto network = network_of(yaml, {{"A", 1e-3}, {"B", 1e-3}, {"D", 1e-3}});
  auto scheme = make_scheme(SchemeKind::linearised, network);
  auto laws = scheme->start(network, 1e-3);
  const double waves[] = {wave, 2 * wave, -0.5 * wave};
  std::vector<double> Q(3);
  for (int i = 0; i < 2000; ++i) {
    for (int k = 0; k < 3; ++k)
      Q[k] = (waves[k] - (laws[k].p_star - laws[k].resistance * laws[k].q_star) / Zc) /
             (1 + laws[k].resistance / Zc);
    laws = scheme->exchange(network, 1e-3, Q);
  }
  const double sum = 2.5 * wave / (1 + 0.1 + 30);  // Q_k (1 + 0.1) + 10 sum = wave_k
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(Q[k], (waves[k] - 10 * sum) / 1.1, 1e-9 * wave);
}

TEST(Schemes, SaveAndLoadGoOnExactly) {
  for (auto kind :
       {SchemeKind::held, SchemeKind::extrapolated, SchemeKind::linearised, SchemeKind::modified_euler}) {
    const Rcr w{.Rp = 1e7, .C = 1e-9, .Rd = 1e8};
    auto network = network_of(w.yaml(), {{"A", 1e-4}});
    auto scheme = make_scheme(kind, network);
    scheme->start(network, 1e-3);
    const double Q[] = {8e-6}, Q2[] = {5e-6};
    scheme->exchange(network, 1e-3, Q);
    const auto state = network.save();
    const auto memory = scheme->save();
    const auto first = scheme->exchange(network, 1e-3, Q2)[0];
    network.load(state);
    auto again = make_scheme(kind, network);
    again->load(memory);
    const auto second = again->exchange(network, 1e-3, Q2)[0];
    EXPECT_EQ(first.p_star, second.p_star) << name(kind);
    EXPECT_EQ(first.slope, second.slope) << name(kind);
  }
}

}  // namespace
}  // namespace ostium::coupling
