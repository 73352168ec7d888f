// `ostium import openbf`: what the program makes of openBF's networks.
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/import/openbf_walls.hpp"
#include "core/csv.hpp"
#include "program.hpp"

namespace ostium::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
namespace openbf = app::openbf;

class ImportOpenbf : public ProgramTest {
 protected:
  static std::filesystem::path data(const std::string& name) {
    return std::filesystem::path(OSTIUM_DATA_DIR) / "networks/openbf_boileau2015" / name;
  }
  void model(const std::string& vessels) const {
    write("m.yaml",
          "project_name: m\ninlet_file: m.dat\nblood: {rho: 1060, mu: 0.004}\nnetwork:\n" + vessels);
    write("m.dat", "0 1e-5\n0.5 3e-5\n1 1e-5\n");
  }
  json summary(const std::string& name) const {
    return json::parse(content("results/" + name + "/summary.json"));
  }
};

const std::string tube = "  - {label: tube, sn: 1, tn: 2, L: 0.1, R0: 0.01, E: 4e5, h0: 1e-3, Pext: 9000, ";

TEST(OpenbfWalls, StraightVesselAtItsOwnPressure) {
  openbf::VesselData v;
  v.label = "v", v.L = 0.2, v.E = 5e5, v.Pext = 8000, v.gamma_profile = 9, v.R0 = 6e-3, v.h0 = 8e-4;
  const double pi = std::numbers::pi, A = pi * 36e-6;
  const auto all = openbf::lumped(v, {1060, 0.004}, 8000, 0, 1);
  EXPECT_NEAR(all.R, 22 * pi * 0.004 * 0.2 / (A * A), 1e-10 * all.R);
  EXPECT_NEAR(all.L, 1060 * 0.2 / A, 1e-10 * all.L);
  EXPECT_NEAR(all.C, 1.5 * pi * 216e-9 * 0.2 / (5e5 * 8e-4), 1e-10 * all.C);
  // Moens & Korteweg, Poisson's ratio 1/2: c^2 = E h/(2 rho r (1 - 1/4))
  const double c = std::sqrt(5e5 * 8e-4 / (2 * 1060 * 6e-3 * 0.75));
  EXPECT_NEAR(openbf::wave_impedance(v, {1060, 0.004}, 8000), 1060 * c / A, 1e-8 * 1060 * c / A);
}

/// A cone: int dx/r^4 = l (1/r1^3 - 1/r2^3)/(3 (r2 - r1)); halves add up to the whole.
TEST(OpenbfWalls, TaperedVessel) {
  openbf::VesselData v;
  v.label = "v", v.L = 0.2, v.E = 5e5, v.Rp = 6e-3, v.Rd = 4e-3, v.h0 = 8e-4;
  const openbf::BloodData blood{1060, 0.004};
  const auto all = openbf::lumped(v, blood, 0, 0, 1), a = openbf::lumped(v, blood, 0, 0, 0.5),
             b = openbf::lumped(v, blood, 0, 0.5, 1);
  const double exact =
      8 * 0.004 / std::numbers::pi * 0.2 * (std::pow(6e-3, -3) - std::pow(4e-3, -3)) / (3 * -2e-3);
  EXPECT_NEAR(all.R, exact, 1e-5 * exact);
  EXPECT_NEAR(a.R + b.R, all.R, 1e-5 * all.R);
  EXPECT_NEAR(a.C + b.C, all.C, 1e-6 * all.C);
  EXPECT_LT(a.R, b.R);
}

/// The mean pressure of a single vessel follows from its resistances; more pieces change nothing of it.
TEST_F(ImportOpenbf, OneVesselInPieces) {
  model(tube + "R1: 1e8, R2: 9e8, Cc: 1e-9}\n");
  for (const std::string pieces : {"1", "5"}) {
    const Outcome made = ostium("import openbf m.yaml -o case.yaml --force --segments " + pieces);
    ASSERT_EQ(made.code, 0) << made.text;
    EXPECT_THAT(made.text, HasSubstr("1 vessels as " + std::to_string(std::stoi(pieces) + 2) + " blocks"));
    ASSERT_EQ(ostium("run case.yaml -o results/m --force").code, 0);
    const double p =
        summary("m")["derived"]["pressures"]["n2"]["mean"]["value"].get<double>() * 133.322387415;
    EXPECT_NEAR(p, 2e-5 * 1e9, 1e-3 * 2e4) << pieces;
  }
}

/// Means and extremes of openBF's own nonlinear solution of Boileau's common carotid artery.
TEST_F(ImportOpenbf, CommonCarotidArtery) {
  if (!std::filesystem::exists(data("cca/cca.yaml"))) GTEST_SKIP() << "needs the reference data (networks)";
  ASSERT_EQ(ostium("import openbf " + data("cca/cca.yaml").string() + " -o cca.yaml --segments 8").code, 0);
  ASSERT_EQ(ostium("run cca.yaml").code, 0);
  const Table reference = read_table(data("cca/openbf_ref_common_carotid_artery.csv"));
  const auto& t = reference.columns[0];
  const auto& P = reference.columns[1];
  double mean = 0;
  for (std::size_t i = 1; i < t.size(); ++i)
    mean += (t[i] - t[i - 1]) * (P[i] + P[i - 1]) / 2 / (t.back() - t[0]);
  const auto [low, high] = std::minmax_element(P.begin(), P.end());
  const json p = summary("cca")["series"]["p:n1_Pa"];
  EXPECT_NEAR(p["mean"].get<double>(), mean, 0.005 * mean);
  EXPECT_NEAR(p["min"].get<double>(), *low, 0.01 * *low);
  EXPECT_NEAR(p["max"].get<double>(), *high, 0.01 * *high);
}

TEST_F(ImportOpenbf, BadModels) {
  const auto error = [&](const std::string& vessels) {
    model(vessels);
    const Outcome outcome = ostium("import openbf m.yaml -o case.yaml --force");
    EXPECT_EQ(outcome.code, 2);
    return outcome.text;
  };
  EXPECT_THAT(error(tube + "R1: 1e8, R2: 9e8}\n"),
              HasSubstr("m.yaml:5:5: network.1: R1 needs the compliance Cc"));
  EXPECT_THAT(error(tube + "r1: 1e8}\n"), HasSubstr("unknown key \"r1\"; did you mean \"R1\"?"));
  EXPECT_THAT(error(tube + "}\n"), HasSubstr("the vessel \"tube\" is a last one and has no outlet"));
  EXPECT_THAT(error("  - {label: a, sn: 1, tn: 2, L: -1, R0: 1e-2, E: 4e5, Rt: 0}\n"),
              HasSubstr("network.1.L: -1 is not allowed"));
  EXPECT_THAT(error("  - {label: a, sn: 1, tn: 2, L: 1, E: 4e5, Rt: 0}\n"),
              HasSubstr("the radius is missing"));
  EXPECT_THAT(error("  - {label: a, sn: 2, tn: 2, L: 1, R0: 1e-2, E: 4e5, Rt: 0}\n"),
              HasSubstr("begins and ends at the node 2"));
  const std::string two =
      "  - {label: a, sn: 1, tn: 2, L: 0.1, R0: 1e-2, E: 4e5}\n  - {label: a, sn: 2, tn: 3, L: 0.1, R0: "
      "1e-2, E: 4e5, Rt: 0}\n";
  EXPECT_THAT(error(two), HasSubstr("there are two vessels labelled \"a\""));
  EXPECT_THAT(error("  - {label: a, sn: 1, tn: 2, L: 0.1, R0: 1e-2, E: 4e5, Rt: 0}\n  - {label: b, sn: 3, "
                    "tn: 4, L: 0.1, R0: "
                    "1e-2, E: 4e5, Rt: 0}\n"),
              HasSubstr("2 nodes begin vessels and end none"));
  EXPECT_THAT(error(tube + "R1: 1e5, Cc: 1e-9}\n"), HasSubstr("less than the"));
  model(tube + "R1: 1e8, R2: 9e8, Cc: 1e-9}\n");
  write("m.dat", "0.1 1e-5\n1 2e-5\n");
  EXPECT_THAT(ostium("import openbf m.yaml -o case.yaml --force").text,
              HasSubstr("m.dat:1: the inflow begins at 0.1 s"));
  EXPECT_THAT(ostium("import openbf m.yaml").text, HasSubstr("this file exists"));
}

}  // namespace
}  // namespace ostium::test
