#include "network/sensitivities.hpp"

#include <map>

#include "lumped/registry.hpp"
#include "tests/network/closed_loop.hpp"

namespace ostium::network {
namespace {

using testing::HasSubstr;
using Texts = std::vector<std::string>;

std::vector<Index> indices(const Model& m, const Texts& texts) {
  const Network n(m);
  std::vector<Index> all;
  for (const auto& t : texts) all.push_back(read_index(t, n.series_names(), "case.yaml:1:1"));
  return all;
}

std::vector<Parameter> named(const Model& m, const Texts& names) {
  std::vector<Parameter> all;
  for (const auto& n : names) all.push_back(parameter(m, n, "case.yaml:1:1"));
  return all;
}

double size_of(const Index& i) {
  const std::map<std::string, double> sizes{{"Pa", 1.3e4}, {"m3", 1e-4}, {"m3/s", 1e-4}, {"1", 1}};
  return sizes.at(i.unit);
}

/// The model with one value changed.
Model changed(const Model& m, const Parameter& p, double value) {
  Model other = m;
  const lumped::Change change{p.number, value};
  other.entries[p.entry].block = m.entries[p.entry].block->with({&change, 1});
  return other;
}

/// Against differences of whole runs at four places, 0.5 % and 1 % of the parameter to either side. Their own error: a tenth of what the
/// outer two places change, and what the integrator's tolerance makes of the results (some 1e-7) over the step.
void expect_differences(const Model& m, const Texts& of, const std::vector<Parameter>& to,
                        const SensitivityRun& run, double relative = 1e-3, double noise = 1e-4) {
  const auto which = indices(m, of);
  const auto s = sensitivities(m, which, to, run);
  for (size_t p = 0; p < to.size(); ++p) {
    const double h = 5e-3;
    const auto at = [&](double steps) {
      return sensitivities(changed(m, to[p], to[p].value + steps * h * to[p].size), which, {}, run).values;
    };
    const auto up = at(1), down = at(-1), further_up = at(2), further_down = at(-2);
    for (size_t i = 0; i < which.size(); ++i) {
      const double difference = (8 * (up[i] - down[i]) - (further_up[i] - further_down[i])) / (12 * h);
      const double correction = difference - (up[i] - down[i]) / (2 * h);
      const double ours = s.gradients(i, p) * to[p].size;
      EXPECT_NEAR(ours / size_of(which[i]), difference / size_of(which[i]),
                  (relative * std::abs(difference) + 0.1 * std::abs(correction)) / size_of(which[i]) + noise)
          << of[i] << " to " << to[p].name;
    }
  }
}

struct Example {
  std::string yaml;
  Texts of;
};

const std::string source =
    "s: {type: flow_source, to: A, flow: {fourier: {mean: 80, cos: [-60], sin: [10]}, unit: mL/s, period: "
    "0.8 s}}\n";
const std::string store = "c: {type: capacitor, from: A, C: 1e-8 m3/Pa, initial_pressure: 60 mmHg}\n";
const std::string bed = "r: {type: resistor, from: B, ground: 3 mmHg, R: 1.3e8 Pa.s/m3}\n";

/// A chamber between a vein and an artery, with the valves given.
std::string ventricle(const std::string& chamber, const std::string& mitral, const std::string& aortic) {
  return "vein: {type: pressure_source, to: LA, pressure: 10 mmHg}\n" + mitral + chamber + aortic +
         "bed: {type: windkessel, from: Ao, Rp: 5e6 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1.3e8 Pa.s/m3, "
         "initial_pressure: 80 "
         "mmHg}\n";
}
const std::string mitral = "mitral: {type: valve, from: LA, to: LV, R: 1e6 Pa.s/m3}\n";
const std::string aortic = "aortic: {type: valve, from: LV, to: Ao, R: 2e6 Pa.s/m3, L: 4e4 Pa.s2/m3}\n";
const std::string muscle =
    "lv: {type: elastance_chamber, from: LV, Emin: 1e7 Pa/m3, Emax: 3e8 Pa/m3, V0: 10 mL, initial_volume: "
    "100 mL, " +
    twitch + "}\n";
const Texts heart = {"mean p:Ao", "max p:Ao", "min p:bed.Pc", "mean q:aortic", "max q:aortic"};

/// One or more networks per type of block, the block under test named `b`.
const std::multimap<std::string, Example>& examples() {
  static const std::multimap<std::string, Example> all{
      {"resistor",
       {source + store + "b: {type: resistor, from: A, ground: 5 mmHg, R: 1.3e8 Pa.s/m3}\n",
        {"mean q:b", "max p:A", "min p:A", "pulse p:A"}}},
      {"capacitor",
       {source + "b: {type: capacitor, from: A, C: 1e-8 m3/Pa, initial_pressure: 60 mmHg}\n"
                 "r: {type: resistor, from: A, ground: 3 mmHg, R: 1.3e8 Pa.s/m3}\n",
        {"mean p:A", "max p:A", "min q:b"}}},
      {"inductor",
       {source + store + "b: {type: inductor, from: A, to: B, L: 3e6 Pa.s2/m3, initial_flow: 20 mL/s}\n" +
            bed,
        {"mean q:b", "max p:B", "pulse p:A"}}},
      {"vessel",
       {source + store +
            "b: {type: vessel, from: A, to: B, R: 2e7 Pa.s/m3, C: 2e-9 m3/Pa, L: 1e5 Pa.s2/m3, K: 3e11 "
            "Pa.s2/m6, "
            "initial_pressure: 50 mmHg, initial_flow: 10 mL/s}\n" +
            bed,
        {"mean q:b", "max p:A", "pulse p:B", "flow_split q:b / q:s"}}},
      {"rc",
       {source + "b: {type: rc, from: A, to: B, R: 2e7 Pa.s/m3, C: 1e-8 m3/Pa, initial_pressure: 60 mmHg}\n" +
            bed,
        {"mean p:A", "max p:B", "pulse q:b.q_out"}}},
      {"windkessel",
       {source +
            "b: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1.2e8 Pa.s/m3, Pd: 5 mmHg, "
            "initial_pressure: 60 mmHg}\n",
        {"mean p:A", "max p:A", "min p:b.Pc"}}},
      {"coronary",
       {"p: {type: pressure_source, to: A, pressure: {fourier: {mean: 100, sin: [20]}, unit: mmHg, period: "
        "0.8 s}}\n"
        "b: {type: coronary, from: A, Ra: 1.3e9 Pa.s/m3, Ram: 2.1e9 Pa.s/m3, Ram_max: 4e9 Pa.s/m3, Rv: 4.4e9 "
        "Pa.s/m3, Ca: 4e-12 m3/Pa, Cim: 3e-11 m3/Pa, Pd: 5 mmHg, initial_pressure: 80 mmHg, initial_volume: "
        "0.2 mL, "
        "Pim: {fourier: {mean: 40, cos: [-30]}, unit: mmHg, period: 0.8 s}, " +
            twitch + "}\n",
        {"mean p:b.Pa", "max p:b.Pa", "pulse v:b.V"}}},
      {"elastance_chamber",
       {ventricle("b: {type: elastance_chamber, from: LV, Emin: 1e7 Pa/m3, Emax: 3e8 Pa/m3, V0: 10 mL, "
                  "V0_systole: 8 "
                  "mL, initial_volume: 100 mL, " +
                      twitch + "}\n",
                  mitral, aortic),
        {"mean p:Ao", "max p:Ao", "ejection_fraction v:b.V", "stroke_volume v:b.V",
         "stroke_volume q:aortic"}}},
      {"elastance_chamber",
       {ventricle("b: {type: elastance_chamber, from: LV, to: O, L: 1e5 Pa.s2/m3, Emin: 1e7 Pa/m3, Emax: 3e8 "
                  "Pa/m3, "
                  "initial_volume: 100 mL, activation: {type: double_hill, start: 0.1 s, tau_1: 0.2 s, "
                  "tau_2: 0.33 s, "
                  "m1: 1.5, m2: 20, period: 0.8 s}}\n",
                  mitral,
                  "aortic: {type: smooth_valve, from: O, to: Ao, Rmin: 2e6 Pa.s/m3, Rmax: 1e10 Pa.s/m3, k: "
                  "0.01 1/Pa}\n"),
        {"mean p:Ao", "max p:Ao", "ejection_fraction v:b.V"}}},
      {"exponential_chamber",
       {ventricle(
            "b: {type: exponential_chamber, from: LV, Emax: 2e8 Pa/m3, P0: 600 Pa, k: 9000 1/m3, V0: 10 mL, "
            "initial_volume: 110 mL, activation: {type: piecewise_cosine, contract_start: 0.1 s, "
            "contract_duration: 0.25 s, relax_start: 0.35 s, relax_duration: 0.2 s, period: 0.8 s}}\n",
            mitral, aortic),
        {"mean p:Ao", "max p:Ao", "ejection_fraction v:b.V"}}},
      {"sphere_chamber",
       {ventricle(
            "b: {type: sphere_chamber, from: LV, rho: 1000 kg/m3, d0: 10 mm, r0: 30 mm, W1: 1 kPa, W2: 40 "
            "Pa, "
            "eta: 10 Pa.s, sigma_max: 100 kPa, alpha_max: 30 1/s, alpha_min: -30 1/s, t_systole: 0.1 s, "
            "t_diastole: 0.4 s, steepness: 0.01 s, period: 0.8 s, initial_active_stress: 10 Pa, "
            "initial_velocity: 1 mm/s, initial_displacement: 0.1 mm, initial_volume: 110 mL}\n",
            "mitral: {type: valve, from: LA, to: LV, R: 1e6 Pa.s/m3, R_closed: 1e9 Pa.s/m3}\n",
            "aortic: {type: valve, from: LV, to: Ao, R: 2e6 Pa.s/m3, R_closed: 1e9 Pa.s/m3}\n"),
        {"mean p:Ao", "max p:Ao", "stroke_volume v:b.V"}}},
      {"valve",
       {ventricle(
            muscle, mitral,
            "b: {type: valve, from: LV, to: Ao, R: 2e6 Pa.s/m3, L: 4e4 Pa.s2/m3, R_closed: 1e9 Pa.s/m3}\n"),
        {"mean p:Ao", "max p:Ao", "mean q:b", "max q:b", "ejection_fraction v:lv.V"}}},
      {"structured_tree",
       {source + "b: {type: structured_tree, from: A, r_root: 2 mm, r_min: 0.03 mm, xi: 2.7, eta: 0.45, Pd: "
                 "5 mmHg}\n",
        {"mean p:A", "max p:A"}}},
      {"impedance",
       {source +
            "b: {type: impedance, from: A, frequency: [0 Hz, 1.25 Hz, 2.5 Hz, 5 Hz, 10 Hz], modulus: [1.4e8 "
            "Pa.s/m3, 2.5e7 Pa.s/m3, 1.5e7 Pa.s/m3, 1.1e7 Pa.s/m3, 1e7 Pa.s/m3], phase: [0 rad, -1.1 rad, "
            "-0.9 "
            "rad, -0.5 rad, -0.3 rad], Pd: 5 mmHg}\n",
        {"mean p:A", "max p:A"}}},
      {"valve",
       {ventricle(muscle, "b: {type: valve, from: LA, to: LV, R: 1e6 Pa.s/m3}\n", aortic),
        {"mean p:Ao", "mean q:b", "ejection_fraction v:lv.V"}}},
      {"smooth_valve",
       {ventricle(muscle, mitral,
                  "b: {type: smooth_valve, from: LV, to: Ao, Rmin: 2e6 Pa.s/m3, Rmax: 1e9 Pa.s/m3, k: 0.005 "
                  "1/Pa}\n"),
        {"mean p:Ao", "max p:Ao", "mean q:b"}}},
      {"orifice_valve",
       {ventricle(muscle, mitral,
                  "b: {type: orifice_valve, from: LV, to: Ao, A_open: 4 cm2, A_closed: 1e-3 cm2, l: 2 cm, "
                  "K_open: 0.05 "
                  "1/(Pa.s), K_close: 0.05 1/(Pa.s), R: 1e6 Pa.s/m3, initial_opening: 0.01}\n"),
        {"mean p:Ao", "max p:Ao", "max q:b"}}},
      {"flow_source",
       {"b: {type: flow_source, to: A, flow: {fourier: {mean: 80, cos: [-60, 5], sin: [10, 20]}, unit: mL/s, "
        "period: "
        "0.8 s}}\nw: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1.2e8 Pa.s/m3}\n",
        {"mean p:A", "max p:A", "stroke_volume q:b"}}},
      {"flow_source",
       {"b: {type: flow_source, to: A, flow: {times: [0, 0.15, 0.4, 0.8], time_unit: s, values: [0, 300, 20, "
        "0], unit: "
        "mL/s, period: 0.8 s}}\nw: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1.2e8 "
        "Pa.s/m3}\n",
        {"mean p:A", "max p:A", "max q:b", "min p:w.Pc"}}},
      {"pressure_source",
       {"b: {type: pressure_source, to: A, pressure: {fourier: {mean: 90, cos: [-20]}, unit: mmHg, period: "
        "0.8 s}}\n"
        "v: {type: vessel, from: A, to: B, R: 2e7 Pa.s/m3, C: 2e-9 m3/Pa, L: 1e5 Pa.s2/m3}\n" +
            bed,
        {"mean p:B", "max q:v", "pulse p:B"}}},
  };
  return all;
}

/// An inertance of 0 is no element; a flow or an opening at its bound 0 has a derivative on one side only. What acts through
/// a fit has none.
bool left_out(const Model& m, const Parameter& p) {
  const auto& block = *m.entries[p.entry].block;
  if (!block.smooth_in(block.parameters()[p.number].key)) return true;
  return p.value == 0 && (p.name == "b.L" || p.name.starts_with("b.initial_"));
}

/// Every parameter of every type of block that exists. A new block needs an example above.
TEST(Sensitivities, OfEveryBlockAgainstDifferences) {
  for (const auto& type : lumped::block_types()) {
    const auto [begin, end] = examples().equal_range(type.name);
    if (begin == end) ADD_FAILURE() << "no example of the block " << type.name << " in examples()";
    for (auto e = begin; e != end; ++e) {
      SCOPED_TRACE(type.name);
      const Model m = model(e->second.yaml);
      std::vector<Parameter> to;
      for (const auto& p : parameters(m))
        if (p.name.starts_with("b.") && !left_out(m, p)) to.push_back(p);
      expect_differences(m, e->second.of, to, {.end = 1.6, .period = 0.8});
    }
  }
}

/// From the periodic state: derivatives of what the circulation settles to, the blood it holds included.
TEST(Sensitivities, OfThePeriodicStateOfAClosedLoop) {
  const Model m = model(closed_loop);
  expect_differences(m,
                     {"mean p:Ao", "max p:Ao", "ejection_fraction v:lv.V", "stroke_volume q:aortic",
                      "flow_split q:lca / q:aortic", "min v:rv.V"},
                     named(m, {"lv.Emax", "body.Rd", "body.C", "veins.C", "veins.initial_pressure",
                               "mitral.R", "aortic.L", "rca.share", "la.k"}),
                     {.end = 0.8, .period = 0.8, .initial = Initial::periodic});
}

TEST(Sensitivities, PeriodicMeansInClosedForm) {
  const Model m = model(
      "in: {type: flow_source, to: A, flow: {fourier: {mean: 90, cos: [-60]}, unit: mL/s, period: 1 s}}\n"
      "left: {type: windkessel, from: A, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 2e8 Pa.s/m3}\n"
      "right: {type: windkessel, from: A, Rp: 2e7 Pa.s/m3, C: 5e-9 m3/Pa, Rd: 4e8 Pa.s/m3}\n");
  const auto s = sensitivities(m, indices(m, {"mean p:A", "flow_split q:left / q:in"}),
                               named(m, {"left.Rd", "right.Rp", "left.C", "in.flow.factor"}),
                               {.end = 1, .period = 1, .initial = Initial::periodic});
  const double a = 2.1e8, b = 4.2e8, q = 90e-6, sum = a + b;
  EXPECT_NEAR(s.values[0], q * a * b / sum, 1e-6 * q * a);
  EXPECT_NEAR(s.values[1], b / sum, 1e-6);
  const double exact[2][4] = {{q * b * b / (sum * sum), q * a * a / (sum * sum), 0, q * a * b / sum},
                              {-b / (sum * sum), a / (sum * sum), 0, 0}};
  const double sizes[] = {2e8, 2e7, 1e-8, 1};
  for (int p = 0; p < 4; ++p) {
    EXPECT_NEAR(s.gradients(0, p) * sizes[p], exact[0][p] * sizes[p], 1e-5 * q * a) << p;
    EXPECT_NEAR(s.gradients(1, p) * sizes[p], exact[1][p] * sizes[p], 1e-5) << p;
  }
}

/// An inertance behind a leaking switch: open until tau, where q(tau) = 0, then L dq/dt + R_closed q = P sin(w t). What
/// follows depends on R only through tau.
TEST(Sensitivities, JumpWhereAValveCloses) {
  const double w = 2 * pi, P = 1000, R = 1e7, L = 5e6, Rc = 9e7;
  const auto driven = [&](double r, double t) {
    return P / (r * r + w * w * L * L) * (r * std::sin(w * t) - w * L * std::cos(w * t));
  };
  const auto open = [&](double r, double t) {
    return driven(r, t) + (1e-6 - driven(r, 0)) * std::exp(-r / L * t);
  };
  const auto closing = [&](double r) {
    double a = 0.5, b = 0.99;
    for (int i = 0; i < 200; ++i) (open(r, 0.5 * (a + b)) > 0 ? a : b) = 0.5 * (a + b);
    return 0.5 * (a + b);
  };
  const auto least = [&](double r) {  // of the flow while it leaks
    const double tau = closing(r);
    const auto leak = [&](double t) {
      return driven(Rc, t) - driven(Rc, tau) * std::exp(-Rc / L * (t - tau));
    };
    double low = 0;
    for (int i = 0; i <= 400000; ++i) low = std::min(low, leak(tau + (1.0 - tau) * i / 400000));
    return low;
  };
  const Model m = model(
      "s: {type: pressure_source, to: A, pressure: {fourier: {mean: 0, sin: [1000]}, unit: Pa, period: 1 "
      "s}}\n"
      "v: {type: valve, from: A, ground: 0 Pa, R: 1e7 Pa.s/m3, L: 5e6 Pa.s2/m3, R_closed: 9e7 Pa.s/m3, "
      "initial_flow: 1 mL/s}\n");
  const auto s =
      sensitivities(m, indices(m, {"min q:v", "max q:v"}), named(m, {"v.R", "v.R_closed"}), {.end = 1});
  EXPECT_NEAR(s.values[0], least(R), 1e-5 * P / R);
  const double exact = (least(1.001 * R) - least(0.999 * R)) / (0.002 * R);
  EXPECT_NEAR(s.gradients(0, 0), exact, 1e-3 * std::abs(exact) + 1e-14);
  EXPECT_NEAR(s.gradients(1, 1), 0, 1e-12 / R);  // the maximum comes before
}

std::string refusal(const std::string& index) {
  try {
    indices(model(closed_loop), {index});
  } catch (const UserError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Sensitivities, BadIndices) {
  EXPECT_THAT(refusal("meen p:Ao"),
              HasSubstr("case.yaml:1:1: there is no index \"meen\"; did you mean \"mean\"?"));
  EXPECT_THAT(refusal("mean p:Aa"), HasSubstr("there is no series \"p:Aa\""));
  EXPECT_THAT(refusal("ejection_fraction p:Ao"),
              HasSubstr("ejection_fraction is taken of a volume (v:..), and \"p:Ao_Pa\" is none"));
  EXPECT_THAT(
      refusal("flow_split q:lca"),
      HasSubstr(
          "\"flow_split q:lca\" is no index; write for example \"flow_split q:left_m3_s / q:heart_m3_s\""));
  EXPECT_THAT(refusal("mean"), HasSubstr("is no index; write for example \"mean p:Ao_Pa\""));
}

TEST(Sensitivities, WhatHasNoneIsRefused) {
  const auto text = [](const std::string& yaml, const std::string& to, Initial initial) -> std::string {
    try {
      const Model m = model(yaml);
      sensitivities(m, {}, named(m, {to}), {.end = 0.8, .period = 0.8, .initial = initial});
    } catch (const UserError& e) {
      return e.what();
    }
    return "no error";
  };
  EXPECT_THAT(text(closed_loop, "lv.activation.period", Initial::periodic),
              HasSubstr("a periodic state has no derivative with respect to it"));
  const std::string sphere =
      "vein: {type: pressure_source, to: LA, pressure: 8 mmHg}\n"
      "mitral: {type: valve, from: LA, to: LV, R: 2e6 Pa.s/m3, R_closed: 1e9 Pa.s/m3}\n"
      "b: {type: sphere_chamber, from: LV, rho: 1000 kg/m3, d0: 10 mm, r0: 30 mm, W1: 1 kPa, W2: 40 Pa, eta: "
      "10 "
      "Pa.s, sigma_max: 100 kPa, alpha_max: 30 1/s, alpha_min: -30 1/s, t_systole: 0.1 s, t_diastole: 0.4 s, "
      "steepness: 0.01 s, period: 0.8 s}\n"
      "aortic: {type: valve, from: LV, to: Ao, R: 2e6 Pa.s/m3, R_closed: 1e9 Pa.s/m3}\n"
      "bed: {type: windkessel, from: Ao, Rp: 5e6 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1.3e8 Pa.s/m3, "
      "initial_pressure: 80 "
      "mmHg}\n";
  EXPECT_THAT(text(examples().find("structured_tree")->second.yaml, "b.eta", Initial::rest),
              HasSubstr("b.eta acts through a fit, whose terms come and go as it changes"));
  EXPECT_THAT(text(sphere, "b.W1", Initial::periodic),
              HasSubstr("as a sphere_chamber keeps its volume at a radius; derivatives of its periodic state "
                        "are not known"));
  EXPECT_THAT(
      text(source + "b: {type: vessel, from: A, ground: 0 Pa, R: 1e8 Pa.s/m3}\n", "b.C", Initial::rest),
      HasSubstr("b.C is 0 m3/Pa, and a change of it leaves an element of the block out or adds one"));
}

}  // namespace
}  // namespace ostium::network
