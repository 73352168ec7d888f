// The shipped hearts and loops: against an integration of their own equations by other means, and what must be kept.
#include <array>
#include <functional>

#include "network/subnetwork.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

constexpr double mmHg = 133.322387415, mL = 1e-6;

/// The closed loop of Regazzoni et al. in mmHg, mL and s, by Runge & Kutta with small steps: valves are the larger of
/// zero and dp/R, nothing is switched.
struct Loop {
  // V_ra V_rv V_la V_lv, p and q of the systemic arteries and veins, of the pulmonary ones
  using State = std::array<double, 12>;
  State y{65, 145, 65, 120, 80, 0, 30, 0, 15, 0, 11, 0};
  double t = 0;

  static double twitch(double t, double start, double rise, double fall) {
    const double s = t - start - std::floor(t - start);
    if (s < rise) return 0.5 * (1 - std::cos(pi * s / rise));
    return s < rise + fall ? 0.5 * (1 + std::cos(pi * (s - rise) / fall)) : 0;
  }
  struct Pressures {
    double ra, rv, la, lv;
  };
  static Pressures pressures(double t, const State& y) {
    const double a = twitch(t, 0.80, 0.17, 0.17), v = twitch(t, 0, 0.34, 0.17);
    return {(0.07 + 0.06 * a) * (y[0] - 4), (0.05 + 0.55 * v) * (y[1] - 10), (0.09 + 0.07 * a) * (y[2] - 4),
            (0.08 + 2.75 * v) * (y[3] - 5)};
  }
  static State rates(double t, const State& y) {
    const auto p = pressures(t, y);
    const auto valve = [](double up, double down) { return std::max(0.0, up - down) / 0.0075; };
    const double tricuspid = valve(p.ra, p.rv), pulmonary = valve(p.rv, y[8]), mitral = valve(p.la, p.lv),
                 aortic = valve(p.lv, y[4]);
    return {y[7] - tricuspid,        tricuspid - pulmonary,
            y[11] - mitral,          mitral - aortic,
            (aortic - y[5]) / 1.2,   (y[4] - y[6] - 0.8 * y[5]) / 5e-3,
            (y[5] - y[7]) / 60,      (y[6] - p.ra - 0.26 * y[7]) / 5e-4,
            (pulmonary - y[9]) / 10, (y[8] - y[10] - 0.0321 * y[9]) / 5e-4,
            (y[9] - y[11]) / 16,     (y[10] - p.la - 0.0357 * y[11]) / 5e-4};
  }
  void step(double h) {
    const auto moved = [&](const State& k, double s) {
      State z = y;
      for (std::size_t i = 0; i < z.size(); ++i) z[i] += s * k[i];
      return z;
    };
    const State a = rates(t, y), b = rates(t + h / 2, moved(a, h / 2)), c = rates(t + h / 2, moved(b, h / 2)),
                d = rates(t + h, moved(c, h));
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    t += h;
  }
};

TEST(Shipped, ClosedLoopAgainstRungeKutta) {
  Network n(model("c: {type: closed_loop}\n"));
  Loop loop;
  double worst_p = 0, worst_V = 0;
  for (int i = 1; i <= 300; ++i) {  // three beats from the start values
    for (int k = 0; k < 500; ++k) loop.step(2e-5);
    run_to(n, 0.01 * i);
    worst_V = std::max({worst_V, std::abs(series(n, "v:c.heart.lv.V_m3") / mL - loop.y[3]),
                        std::abs(series(n, "v:c.heart.rv.V_m3") / mL - loop.y[1]),
                        std::abs(series(n, "v:c.heart.la.V_m3") / mL - loop.y[2]),
                        std::abs(series(n, "v:c.heart.ra.V_m3") / mL - loop.y[0])});
    worst_p = std::max({worst_p, std::abs(series(n, "p:c.Ao_Pa") / mmHg - loop.y[4]),
                        std::abs(series(n, "p:c.PA_Pa") / mmHg - loop.y[8]),
                        std::abs(series(n, "p:c.body.mid_Pa") / mmHg - loop.y[6]),
                        std::abs(series(n, "p:c.heart.LV_Pa") / mmHg - Loop::pressures(loop.t, loop.y).lv)});
  }
  EXPECT_LT(worst_V, 0.02);  // mL of some 100
  EXPECT_LT(worst_p, 0.02);  // mmHg of some 100
  RecordProperty("largest_error_mL", std::to_string(worst_V));
  RecordProperty("largest_error_mmHg", std::to_string(worst_p));
}

double blood(const Network& n) {
  double V = 0;
  for (const char* chamber : {"ra", "rv", "la", "lv"})
    V += series(n, std::string("v:c.heart.") + chamber + ".V_m3");
  const double C = mL / mmHg;
  return V + C * (1.2 * series(n, "p:c.body.arteries.u_Pa") + 60 * series(n, "p:c.body.veins.u_Pa") +
                  10 * series(n, "p:c.lungs.arteries.u_Pa") + 16 * series(n, "p:c.lungs.veins.u_Pa"));
}

/// Thirty beats: the blood is kept, and what a resting adult shows comes out.
TEST(Shipped, ClosedLoopIsAHealthyAdult) {
  Network n(model("c: {type: closed_loop}\n"));
  const double before = blood(n);
  run_to(n, 29);
  double EDV = 0, ESV = 1, systolic = 0, diastolic = 1e9, mean = 0, lungs = 0, output = 0, left_atrium = 0;
  constexpr int m = 1000;
  for (int i = 1; i <= m; ++i) {
    run_to(n, 29 + 1.0 * i / m);
    const double V = series(n, "v:c.heart.lv.V_m3") / mL, p = series(n, "p:c.Ao_Pa") / mmHg;
    EDV = std::max(EDV, V), ESV = i == 1 ? V : std::min(ESV, V);
    systolic = std::max(systolic, p), diastolic = std::min(diastolic, p), mean += p / m;
    lungs += series(n, "p:c.PA_Pa") / mmHg / m, left_atrium += series(n, "p:c.LA_Pa") / mmHg / m;
    output += series(n, "q:c.heart.aortic_m3_s") * 6e4 / m;
    for (const char* valve : {"mitral", "aortic", "tricuspid", "pulmonary"}) {
      const std::string name = std::string("c.heart.") + valve;
      if (series(n, "x:" + name + ".open") == 0) {
        EXPECT_EQ(series(n, "q:" + name + "_m3_s"), 0) << valve;
      }
    }
  }
  EXPECT_NEAR(blood(n), before, 1e-10 * before);
  // Ranges of healthy adults at rest: Lang et al. 2015 (volumes, EF), Kovacs et al. 2009 (lungs), textbook pressures.
  EXPECT_TRUE(EDV > 62 && EDV < 150) << EDV;
  EXPECT_TRUE((EDV - ESV) / EDV > 0.52 && (EDV - ESV) / EDV < 0.74) << (EDV - ESV) / EDV;
  EXPECT_TRUE(output > 4 && output < 8) << output;
  EXPECT_TRUE(systolic > 90 && systolic < 140) << systolic;
  EXPECT_TRUE(diastolic > 60 && diastolic < 90) << diastolic;
  EXPECT_TRUE(mean > 70 && mean < 105) << mean;
  EXPECT_TRUE(lungs > 8 && lungs < 20) << lungs;
  EXPECT_TRUE(left_atrium > 4 && left_atrium < 12) << left_atrium;
  RecordProperty("EDV_mL", std::to_string(EDV));
  RecordProperty("EF", std::to_string((EDV - ESV) / EDV));
  RecordProperty("output_L_min", std::to_string(output));
  RecordProperty("aorta_mmHg",
                 std::to_string(systolic) + "/" + std::to_string(diastolic) + " " + std::to_string(mean));
  RecordProperty("lungs_mmHg", std::to_string(lungs) + " left atrium " + std::to_string(left_atrium));
}

/// The heart with the lungs between a body of one's own gives what the whole loop gives.
TEST(Shipped, HeartAndLungsWithABodyOfItsOwn) {
  Network whole(model("c: {type: closed_loop}\n"));
  Network parts(model("hl: {type: heart_and_lungs, from: V, to: A}\nbody: {type: body, from: A, to: V}\n"));
  run_to(whole, 2), run_to(parts, 2);
  EXPECT_NEAR(series(parts, "p:A_Pa"), series(whole, "p:c.Ao_Pa"), 1e-4 * series(whole, "p:c.Ao_Pa"));
}

TEST(Shipped, EveryDefinitionSaysWhatItIs) {
  for (const auto& [name, definition] : shipped_subnetworks()) {
    EXPECT_NE(definition.doc, "") << name;
    EXPECT_NE(definition.source, "") << name;
    for (const auto& port : definition.port_names())
      EXPECT_NE(definition.port_doc(port), "") << name << "." << port;
    for (const auto& [key, p] : definition.parameters) EXPECT_NE(p.doc, "") << name << "." << key;
  }
}

}  // namespace
}  // namespace ostium::network
