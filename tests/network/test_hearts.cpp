#include "lumped/activation.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

const std::string twitch = "activation: {type: half_cosine, start: 0.1 s, duration: 0.4 s, period: 0.8 s}";

double A(double t) {
  const double s = std::fmod(t, 0.8) - 0.1;
  return s > 0 && s < 0.4 ? 0.5 * (1 - std::cos(2 * pi * s / 0.4)) : 0.0;
}

/// Left heart between a venous pressure and an arterial Windkessel.
const std::string left_heart =
    "vein: {type: pressure_source, to: LA, pressure: 10 mmHg}\n"
    "mitral: {type: valve, from: LA, to: LV, R: 1e6 Pa.s/m3}\n"
    "lv: {type: elastance_chamber, from: LV, Emin: 1e7 Pa/m3, Emax: 3e8 Pa/m3, V0: 10 mL, initial_volume: "
    "100 mL, " +
    twitch +
    "}\n"
    "aortic: {type: valve, from: LV, to: Ao, R: 2e6 Pa.s/m3}\n"
    "bed: {type: windkessel, from: Ao, Rp: 5e6 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1.3e8 Pa.s/m3, initial_pressure: "
    "80 mmHg}\n";

TEST(Hearts, IsovolumicPhasesKeepTheVolume) {
  Network n(model(left_heart));
  double V = 0;
  int isovolumic = 0;
  bool was_closed = false;
  for (int i = 1; i <= 1600; ++i) {
    run_to(n, 0.001 * i);
    const bool closed = series(n, "x:mitral.open") == 0 && series(n, "x:aortic.open") == 0;
    if (closed && was_closed) {
      ++isovolumic;
      EXPECT_NEAR(series(n, "v:lv.V_m3"), V, 1e-9 * V) << n.time();
      EXPECT_EQ(series(n, "q:mitral_m3_s"), 0);
      EXPECT_EQ(series(n, "q:aortic_m3_s"), 0);
    }
    V = series(n, "v:lv.V_m3");
    was_closed = closed;
    EXPECT_NEAR(series(n, "p:LV_Pa"), (1e7 + 2.9e8 * A(n.time())) * (V - 1e-5), 1e-6 * 13332);
  }
  EXPECT_GT(isovolumic, 100);
}

TEST(Hearts, WhatIsEjectedPassesTheBed) {
  Network n(model(left_heart));
  run_to(n, 16);
  const double V = series(n, "v:lv.V_m3"), Pc = series(n, "p:bed.Pc_Pa");
  double in = 0, run_off = 0;
  const int m = 4000;
  for (int i = 1; i <= m; ++i) {
    run_to(n, 16 + 0.8 * i / m);
    in += series(n, "q:aortic_m3_s") * 0.8 / m;
    run_off += series(n, "p:bed.Pc_Pa") / 1.3e8 * 0.8 / m;
  }
  EXPECT_NEAR(series(n, "v:lv.V_m3"), V, 1e-6 * V);  // periodic after 20 beats
  EXPECT_NEAR(series(n, "p:bed.Pc_Pa"), Pc, 1e-6 * Pc);
  EXPECT_GT(in, 30e-6);
  EXPECT_NEAR(in, run_off, 1e-4 * in);
}

/// Both sides of the heart, lungs and body, inertances and a tight valve at each outlet.
const std::string loop =
    "lv: {type: elastance_chamber, from: LV, Emin: 1e7 Pa/m3, Emax: 3e8 Pa/m3, V0: 10 mL, initial_volume: "
    "110 mL, " +
    twitch +
    "}\n"
    "rv: {type: elastance_chamber, from: RV, Emin: 6e6 Pa/m3, Emax: 7e7 Pa/m3, V0: 20 mL, initial_volume: "
    "110 mL, " +
    twitch +
    "}\n"
    "la: {type: exponential_chamber, from: LA, Emax: 3e7 Pa/m3, P0: 1200 Pa, k: 8000 1/m3, V0: 9 mL, "
    "initial_volume: 70 "
    "mL, activation: {type: wrapping_cosine, end: 0.1 s, duration: 0.3 s, period: 0.8 s}}\n"
    "aortic: {type: valve, from: LV, to: Ao, R: 2e6 Pa.s/m3, L: 1.5e4 Pa.s2/m3}\n"
    "pulmonary: {type: valve, from: RV, to: PA, R: 1e6 Pa.s/m3, L: 1.5e4 Pa.s2/m3}\n"
    "mitral: {type: valve, from: LA, to: LV, R: 1e6 Pa.s/m3, L: 4e4 Pa.s2/m3}\n"
    "tricuspid: {type: valve, from: V, to: RV, R: 1e6 Pa.s/m3}\n"
    "aorta: {type: vessel, from: Ao, to: cap, R: 1e6 Pa.s/m3, C: 1e-8 m3/Pa, L: 1e5 Pa.s2/m3, order: CRL, "
    "initial_pressure: 80 mmHg}\n"
    "body: {type: windkessel, from: cap, to: V, Rp: 5e6 Pa.s/m3, C: 2e-9 m3/Pa, Rd: 1.2e8 Pa.s/m3, "
    "initial_pressure: 80 "
    "mmHg}\n"
    "veins: {type: capacitor, from: V, C: 4e-7 m3/Pa, initial_pressure: 8 mmHg}\n"
    "lungs: {type: rc, from: PA, to: LA, R: 1.3e7 Pa.s/m3, C: 3e-8 m3/Pa, initial_pressure: 15 mmHg}\n";

double blood(const Network& n) {
  return series(n, "v:lv.V_m3") + series(n, "v:rv.V_m3") + series(n, "v:la.V_m3") +
         1e-8 * series(n, "p:aorta.u_Pa") + 2e-9 * series(n, "p:body.Pc_Pa") +
         4e-7 * series(n, "p:veins.u_Pa") + 3e-8 * series(n, "p:lungs.u_Pa");
}

TEST(Hearts, ClosedLoopKeepsItsBlood) {
  Network n(model(loop));
  const double before = blood(n);
  run_to(n, 80);  // 100 beats
  RecordProperty("relative_drift", std::to_string(std::abs(blood(n) - before) / before));
  EXPECT_NEAR(blood(n), before, 1e-10 * before);
  EXPECT_GT(series(n, "p:Ao_Pa"), 5000);  // and it is alive
}

TEST(Hearts, BothSidesEjectTheSame) {
  Network n(model(loop));
  run_to(n, 40);
  double left = 0, right = 0;
  const int m = 4000;
  for (int i = 1; i <= m; ++i) {
    run_to(n, 40 + 0.8 * i / m);
    left += series(n, "q:aortic_m3_s") * 0.8 / m, right += series(n, "q:pulmonary_m3_s") * 0.8 / m;
    EXPECT_GE(series(n, "q:aortic_m3_s"), -1e-12);  // tight
  }
  EXPECT_GT(left, 30e-6);
  EXPECT_NEAR(left, right, 1e-4 * left);
}

/// The smooth valve tends to the switch as its steepness grows and its leak shrinks.
TEST(Hearts, SmoothValvesTendToSwitches) {
  const auto pressure = [](const std::string& mitral, const std::string& aortic) {
    Network n(
        model("mitral: {from: LA, to: LV, " + mitral + "}\naortic: {from: LV, to: Ao, " + aortic + "}\n" +
              left_heart.substr(0, left_heart.find("mitral")) +
              left_heart.substr(left_heart.find("lv:"), left_heart.find("aortic") - left_heart.find("lv:")) +
              left_heart.substr(left_heart.find("bed:"))));
    run_to(n, 0.33);
    return series(n, "p:Ao_Pa");
  };
  const double sharp = pressure("type: valve, R: 1e6 Pa.s/m3", "type: valve, R: 2e6 Pa.s/m3");
  const auto smooth = [&](const std::string& k, const std::string& Rmax) {
    const std::string rest = "Rmax: " + Rmax + " Pa.s/m3, k: " + k + " 1/Pa";
    return std::abs(pressure("type: smooth_valve, Rmin: 1e6 Pa.s/m3, " + rest,
                             "type: smooth_valve, Rmin: 2e6 Pa.s/m3, " + rest) -
                    sharp);
  };
  const double coarse = smooth("0.01", "1e9"), fine = smooth("0.1", "1e10");
  EXPECT_LT(fine, 0.3 * coarse);
  EXPECT_LT(fine, 0.01 * sharp);
}

/// Behind an inertance, which gives the flow, a steep valve is a switch: L dq/dt + R q = P sin(w t) from the rise of P on,
/// until the flow is spent, then the leak. The width of the tanh goes with 1/k.
TEST(Hearts, SteepSmoothValvesBehindAnInertanceSwitch) {
  const double w = 2 * pi, P = 5000, R = 7e5, L = 4e4, Z2 = R * R + w * w * L * L;
  const auto open = [&](double t) {
    return P / Z2 * (R * std::sin(w * t) - w * L * std::cos(w * t) + w * L * std::exp(-R / L * t));
  };
  double a = 0.4, b = 0.9;  // the zero of the flow, by bisection
  for (int i = 0; i < 100; ++i) (open(0.5 * (a + b)) > 0 ? a : b) = 0.5 * (a + b);
  for (const std::string k : {"1", "10", "75", "1000", "10000"}) {
    const double bar = (1e-6 + 1e-4 / std::stod(k)) * P / R;
    Network n(
        model("s: {type: pressure_source, to: A, pressure: {fourier: {mean: 0, sin: [5000]}, unit: Pa, "
              "period: 1 s}}\n"
              "l: {type: inductor, from: A, to: M, L: 4e4 Pa.s2/m3}\n"
              "v: {type: smooth_valve, from: M, ground: 0 Pa, Rmin: 7e5 Pa.s/m3, Rmax: 1.3e11 Pa.s/m3, k: " +
              k + " 1/Pa}\n"));
    for (int i = 1; i <= 100; ++i) {
      run_to(n, 0.0337 * i);
      const double t = n.time() - std::floor(n.time());
      EXPECT_NEAR(series(n, "q:v_m3_s"), t < a ? open(t) : P / 1.3e11 * std::sin(w * t), bar)
          << k << " at " << n.time();
    }
  }
}

TEST(Hearts, CoronaryAtSteadyState) {
  Network n(
      model("s: {type: pressure_source, to: A, pressure: 100 mmHg}\n"
            "c: {type: coronary, from: A, Pd: 5 mmHg, Ra: 1e9 Pa.s/m3, Ram: 2e9 Pa.s/m3, Rv: 4e9 Pa.s/m3, "
            "Ca: 1e-12 m3/Pa, Cim: 2e-11 m3/Pa, Pim: 40 mmHg}\n"));
  run_to(n, 3);
  const double q = 95 * 133.322387415 / 7e9;
  EXPECT_NEAR(series(n, "q:c_m3_s"), q, 1e-9 * q);
  EXPECT_NEAR(series(n, "q:c.q_out_m3_s"), q, 1e-9 * q);
  EXPECT_NEAR(series(n, "v:c.V_m3"), 2e-11 * (5 * 133.322387415 + 4e9 * q - 40 * 133.322387415), 1e-9 * 2e-7);
}

/// The muscle's pressure alone, as a sine: impedance of the bed seen from inside.
TEST(Hearts, CoronarySqueezedPeriodically) {
  Network n(model(
      "s: {type: pressure_source, to: A, pressure: 0 Pa}\n"
      "c: {type: coronary, from: A, Ra: 1e9 Pa.s/m3, Ram: 2e9 Pa.s/m3, Rv: 4e9 Pa.s/m3, Ca: 1e-12 m3/Pa, "
      "Cim: 2e-11 m3/Pa, Pim: {fourier: {mean: 0, sin: [5000]}, unit: Pa, period: 1 s}}\n"));
  const double w = 2 * pi;
  const std::complex<double> i(0, 1), Ya = i * w * 1e-12 + 1e-9,
                                      Z = 2e9 + 1.0 / Ya;  // from p_m back to the source
  const std::complex<double> p =
      5000.0 / (1.0 + (1.0 / Z + 1 / 4e9) / (i * w * 2e-11));  // p_m, Pim = 5000 sin
  for (double t : {4.0, 4.3, 4.8}) {
    run_to(n, t);
    const double q_out = (p / 4e9 * std::exp(i * w * t)).imag();
    EXPECT_NEAR(series(n, "q:c.q_out_m3_s"), q_out, 1e-7 * std::abs(p) / 4e9) << t;
  }
}

}  // namespace
}  // namespace ostium::network
