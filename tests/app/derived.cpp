// Derived results against signals computed by hand.
#include "app/results/derived.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "program.hpp"

namespace ostium::test {
namespace {

using app::CycleStatistics;
using app::CycleSums;
using app::Derived;
using app::Element;
using nlohmann::json;
constexpr double pi = std::numbers::pi, mmHg = 133.322387415;

/// Rows of a made-up run: p and V of a chamber on an ellipse, two branches behind a node.
struct Signals {
  std::vector<std::string> names{"p:LV_Pa",       "p:Ao_Pa",    "v:lv.V_m3",  "q:lv_m3_s",
                                 "q:aortic_m3_s", "q:arm_m3_s", "q:leg_m3_s", "q:pump_m3_s"};
  std::vector<Element> elements{{"lv", "elastance_chamber", "LV", ""},
                                {"aortic", "valve", "LV", "Ao"},
                                {"arm", "resistor", "Ao", ""},
                                {"leg", "resistor", "Ao", ""},
                                {"pump", "flow_source", "", "LV"}};
  static std::vector<double> at(double t) {
    const double w = 2 * pi / 0.8;
    return {8000 + 6000 * std::sin(w * t),
            12000 + 3000 * std::cos(w * t),
            90e-6 + 40e-6 * std::cos(w * t),
            0,
            8e-5,
            6e-5,
            2e-5,
            8e-5 * (1 + std::sin(w * t))};
  }
};

json results(double end, int rows_per_cycle) {
  const Signals s;
  Derived derived(s.elements, {}, s.names, 0.8);
  std::vector<CycleStatistics> statistics(s.names.size(), CycleStatistics(0.8));
  for (int i = 0; i <= static_cast<int>(std::lround(end / 0.8 * rows_per_cycle)); ++i) {
    const double t = 0.8 * i / rows_per_cycle;
    const auto row = Signals::at(t);
    derived.row(t, row);
    for (std::size_t k = 0; k < row.size(); ++k) statistics[k].add(t, row[k]);
  }
  return derived.results([&](const std::string& name) -> std::optional<app::CycleValues> {
    for (std::size_t k = 0; k < s.names.size(); ++k)
      if (s.names[k] == name) {
        const auto cycles = statistics[k].cycles();
        const bool cut = cycles.size() > 1 && cycles.back().duration < 0.79;
        return cut ? cycles[cycles.size() - 2] : cycles.back();
      }
    return {};
  });
}

TEST(Derived, PressuresOfNodes) {
  const json p = results(2.4, 400)["pressures"];
  EXPECT_EQ(p.size(), 2u);
  EXPECT_NEAR(p["Ao"]["systolic"]["value"].get<double>(), 15000 / mmHg, 1e-6);
  EXPECT_NEAR(p["Ao"]["diastolic"]["value"].get<double>(), 9000 / mmHg, 1e-6);
  EXPECT_NEAR(p["Ao"]["mean"]["value"].get<double>(), 12000 / mmHg, 1e-6);
  EXPECT_NEAR(p["Ao"]["pulse"]["value"].get<double>(), 6000 / mmHg, 1e-6);
  EXPECT_EQ(p["Ao"]["mean"]["unit"], "mmHg");
}

/// The area of the ellipse is pi a b; trapezoids miss it by the square of the step.
TEST(Derived, ChamberWithAnEllipticLoop) {
  const auto work = [](int rows) {
    return results(2.4, rows)["chambers"]["lv"]["stroke_work"]["value"].get<double>();
  };
  const double exact = pi * 6000 * 40e-6;
  EXPECT_NEAR(work(400), exact, 1e-4 * exact);
  EXPECT_NEAR((exact - work(50)) / (exact - work(100)), 4, 0.05);
  const json lv = results(2.4, 400)["chambers"]["lv"];
  EXPECT_NEAR(lv["end_diastolic_volume"]["value"].get<double>(), 130, 1e-9);
  EXPECT_NEAR(lv["end_systolic_volume"]["value"].get<double>(), 50, 1e-9);
  EXPECT_NEAR(lv["stroke_volume"]["value"].get<double>(), 80, 1e-9);
  EXPECT_NEAR(lv["ejection_fraction"]["value"].get<double>(), 80.0 / 130, 1e-12);
  EXPECT_NEAR(lv["cardiac_output"]["value"].get<double>(), 8e-5 * 6e4, 1e-9);
}

TEST(Derived, SplitsOutletsAndSources) {
  const json all = results(2.4, 400);
  EXPECT_NEAR(all["flow_splits"]["Ao"]["arm"]["value"].get<double>(), 0.75, 1e-12);
  EXPECT_NEAR(all["flow_splits"]["Ao"]["leg"]["value"].get<double>(), 0.25, 1e-12);
  EXPECT_NEAR(all["outlets"]["leg"]["share"]["value"].get<double>(), 0.25, 1e-12);
  EXPECT_NEAR(all["outlets"]["leg"]["mean_flow"]["value"].get<double>(), 20, 1e-9);
  EXPECT_NEAR(all["sources"]["pump"]["cardiac_output"]["value"].get<double>(), 4.8, 1e-6);
  EXPECT_NEAR(all["sources"]["pump"]["stroke_volume"]["value"].get<double>(), 64, 1e-5);
}

/// A run that ends within a cycle shows the last whole one; rows need not meet the ends of cycles.
TEST(Derived, CycleThatWasCutShortDoesNotCount) {
  const double exact = pi * 6000 * 40e-6;
  EXPECT_NEAR(results(2.0, 400)["chambers"]["lv"]["stroke_work"]["value"].get<double>(), exact, 1e-4 * exact);
  CycleSums sums(1);
  sums.add(0.9, 1.3, 4);  // a quarter before the end of the first cycle
  EXPECT_NEAR(sums.last_complete(1.3), 1, 1e-12);
  EXPECT_NEAR(sums.last_complete(2), 3, 1e-12);
}

class DerivedRun : public ProgramTest {};

/// Two resistances behind a source: split and means by hand; a resumed run has the same results as one in one go.
TEST_F(DerivedRun, SummaryOfAStudy) {
  write("split.yaml",
        "network:\n  blocks:\n"
        "    heart: {type: flow_source, to: A, flow: {fourier: {mean: 6, sin: [3]}, unit: L/min, period: 1 "
        "s}}\n"
        "    one: {type: resistor, from: A, ground: 0 Pa, R: 1e8 Pa.s/m3}\n"
        "    two: {type: windkessel, from: A, Rp: 1e8 Pa.s/m3, C: 1e-9 m3/Pa, Rd: 2e8 Pa.s/m3}\n"
        "time: {period: 1 s, cycles: 2}\n");
  const Outcome outcome = ostium("run split.yaml");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  const json derived = json::parse(content("results/split/summary.json"))["derived"];
  EXPECT_NEAR(derived["flow_splits"]["A"]["one"]["value"].get<double>(), 0.75, 1e-6);
  EXPECT_NEAR(derived["outlets"]["two"]["share"]["value"].get<double>(), 0.25, 1e-6);
  EXPECT_NEAR(derived["sources"]["heart"]["stroke_volume"]["value"].get<double>(), 100, 1e-3);
  EXPECT_NEAR(derived["pressures"]["A"]["mean"]["value"].get<double>(), 7500 / mmHg, 1e-4);
}

/// A case with a subnetwork of its own, and the effective case without it.
TEST_F(DerivedRun, CaseWithASubnetwork) {
  write("own.yaml",
        "network:\n  subnetworks:\n    pair:\n      ports: [in]\n      parameters: {R: {unit: Pa.s/m3}}\n"
        "      blocks:\n        a: {type: resistor, from: in, to: m, R: 0.5 * $R}\n"
        "        b: {type: resistor, from: m, ground: 0 Pa, R: 0.5 * $R}\n"
        "  blocks:\n    heart: {type: flow_source, to: A, flow: 6 L/min}\n    bed: {type: pair, in: A, R: "
        "1e8 Pa.s/m3}\n"
        "time: {end: 0.1 s}\n");
  ASSERT_EQ(ostium("run own.yaml").code, 0);
  EXPECT_THAT(content("results/own/network.csv"), testing::HasSubstr("q:bed.a_m3_s"));
  ASSERT_EQ(ostium("run results/own/case.effective.yaml -o again").code, 0);
  EXPECT_EQ(content("again/network.csv"), content("results/own/network.csv"));
  EXPECT_THAT(ostium("run own.yaml --force --set 'network.blocks.bed.R=-1 Pa.s/m3'").text,
              testing::HasSubstr("network.blocks.bed.a.R"));
}

}  // namespace
}  // namespace ostium::test
