// Every case in a short and coarse form: it runs, finishes, keeps its mass and writes its files.
#include <cmath>

#include "case_run.hpp"

namespace ostium::test {
namespace {

class ShortCase : public CaseRun {};

TEST_F(ShortCase, RcrFourierIsExact) {
  run("rcr_fourier", "");
  const Table network = read_table(folder() / "results/network.csv");
  const Signal pressure = column(network, "p:root_Pa"),
               exact = column(reference("rcr_fourier"), "pressure_Pa");
  EXPECT_EQ(pressure.time.size(), 161u);
  for (std::size_t i = 0; i < pressure.time.size(); ++i)  // both are sampled every 10 ms
    EXPECT_NEAR(pressure.value[i], exact.value[i % 80], 1e-6 * exact.value[i % 80]) << pressure.time[i];
}

/// Indices within their intervals of the exact ones: those hold them in 95 % of all seeds, and here.
TEST_F(ShortCase, RcrSweepHasTheExactIndices) {
  const Outcome outcome = ostium("sweep '" + case_file("rcr_sweep").string() +
                                 "' -q -o results --set sweep.count=400 --set sweep.seed=3");
  ASSERT_EQ(outcome.code, 0) << outcome.text;
  std::istringstream found(content("results/sobol.csv"));
  std::ifstream exact(case_file("rcr_sweep").parent_path() / "reference.csv");
  const auto next = [](std::istream& stream) {
    std::string line, cell;
    std::vector<std::string> cells;
    std::getline(stream, line);
    for (std::istringstream rest(line); std::getline(rest, cell, ',');) cells.push_back(cell);
    return cells;
  };
  next(found), next(exact);
  for (int i = 0; i < 9; ++i) {
    const auto f = next(found), e = next(exact);
    ASSERT_EQ(f.size(), 6u);
    EXPECT_EQ(f[0] + f[1], e[0] + e[1]);
    EXPECT_NEAR(std::stod(f[2]), std::stod(e[2]), 1.5 * std::stod(f[3]) + 1e-9) << f[0] << " " << f[1];
    EXPECT_NEAR(std::stod(f[4]), std::stod(e[3]), 1.5 * std::stod(f[5]) + 1e-9) << f[0] << " " << f[1];
  }
  const auto mean = summary()["results"][0];
  EXPECT_NEAR(mean["mean"].get<double>(), 11000, 4 * 1963 / std::sqrt(800));
}

TEST_F(ShortCase, ClosedLoopIsThatOfAnotherIntegrator) {
  run("closed_loop", "");
  const Table network = read_table(folder() / "results/network.csv"), exact = reference("closed_loop");
  const auto expect_same = [&](const std::string& series, const std::string& name, double allowed) {
    const Signal made = column(network, series), wanted = column(exact, name);
    for (std::size_t i = 0; i < wanted.time.size(); ++i)
      EXPECT_NEAR(made.value[900 + i], wanted.value[i], allowed) << series << " at " << wanted.time[i];
  };
  expect_same("p:aorta_Pa", "aorta_Pa", 1.3);
  expect_same("p:central.heart.LV_Pa", "lv_Pa", 1.3);
  expect_same("v:central.heart.lv.V_m3", "lv_m3", 1e-8);
  expect_same("p:central.PA_Pa", "pulmonary_artery_Pa", 1.3);
  expect_same("p:central.PV_Pa", "left_atrium_Pa", 1.3);
  const auto derived = summary()["derived"];
  EXPECT_NEAR(derived["flow_splits"]["aorta"]["organs.upper"]["value"].get<double>(), 0.3, 1e-6);
  EXPECT_NEAR(derived["chambers"]["central.heart.lv"]["ejection_fraction"]["value"].get<double>(), 0.646,
              0.005);
}

TEST_F(ShortCase, Poiseuille2d) {
  run("poiseuille_2d", "--threads 1 --set 'vessel.spacing=0.1 mm' --set 'time.end=0.15 s'");
  EXPECT_TRUE(exists("results/fields/fluid.pvd"));
  EXPECT_TRUE(exists("results/fields/wall.pvd"));
  const auto all = ports();
  EXPECT_NEAR(all.at("inlet").flow_out.value.back(), -8.3333e-6, 0.05 * 8.3333e-6);
  EXPECT_NEAR(all.at("outlet").pressure.value.back(), 0.1, 1e-6);
}

TEST_F(ShortCase, Poiseuille3d) {
  const auto tube = geometry("tube --radius '0.5 mm' --length '2 mm'");
  run("poiseuille_3d",
      "--threads 1 --surface '" + tube.string() + "' --set 'vessel.spacing=0.1 mm' --set 'time.end=80 ms'");
  EXPECT_NEAR(ports().at("inlet").flow_out.value.back(), -4.9087e-9, 0.05 * 4.9087e-9);
}

const char* coarse_pipe =
    " --threads 1 --set 'vessel.spacing=5 mm' --set 'time={period: 1 s, end: 20 ms}' "
    "--set 'coupling.filter_time=100 ms'";

TEST_F(ShortCase, PipeRcr) {
  const auto surface = data("pipe_rcr/pipe_exterior.vtp");
  if (!surface) GTEST_SKIP() << "needs the reference data (vessels/pipe_rcr)";
  run("pipe_rcr", "--surface '" + surface->string() + "'" + coarse_pipe);
  const double closed_form = column(reference("pipe_rcr"), "outlet_pressure_Pa").at(0.02);
  EXPECT_NEAR(ports().at("outlet").pressure.value.back(), closed_form,
              555);  // a tenth of its amplitude: the blood has started from rest
}

TEST_F(ShortCase, PipeRcrSmallCompliance) {
  const auto surface = data("pipe_rcr/pipe_exterior.vtp");
  if (!surface) GTEST_SKIP() << "needs the reference data (vessels/pipe_rcr)";
  run("pipe_rcr_small_compliance", "--surface '" + surface->string() + "'" + coarse_pipe);
}

TEST_F(ShortCase, AortaArch) {
  const auto arch = geometry("arch --edge '1.5 mm' --branch-radii '4 4 4 4 4 mm'");
  run("aorta_arch", "--threads 1 --surface '" + arch.string() +
                        "' --set 'vessel.spacing=1.95 mm' --set 'time={period: 0.8 s, end: 20 ms}' "
                        "--set 'output.fields_every=10 ms'");
  EXPECT_EQ(ports().size(), 7u);
  EXPECT_TRUE(exists("results/fields/fluid_00001.vtp"));
}

TEST_F(ShortCase, AortaVmr0024) {
  const auto surface = data("aorta_vmr0024/aorta_vmr0024.stl");
  const auto inflow = data("aorta_vmr0024/0154_0001_inflow.txt");
  if (!surface || !inflow) GTEST_SKIP() << "needs the reference data (vessels/aorta_vmr0024)";
  run("aorta_vmr0024", "--threads 1 --surface '" + surface->string() +
                           "' --set 'network.blocks.heart.flow.file=" + inflow->string() +
                           "' --set 'vessel.spacing=1.25 mm' --set 'time={period: 0.66 s, end: 5 ms}'");
  EXPECT_EQ(ports().size(), 6u);
}

TEST_F(ShortCase, BackflowChannel) {
  run("backflow_channel", "--threads 1 --set time.cycles=1");
  const auto outlet = ports().at("outlet");
  const Table exact = reference("backflow_channel");
  const double amplitude = 2843.6;  // Pa
  EXPECT_LT(rms_difference(outlet.pressure, column(exact, "outlet_pressure_Pa"), 0.5), 0.05 * amplitude);
  EXPECT_LT(rms_difference(outlet.flow_out, column(exact, "outlet_flow_m3_s"), 0.5), 0.1 * 6.35e-3);
}

TEST_F(ShortCase, BackflowBranch) {
  run("backflow_branch", "--threads 1 --set 'vessel.spacing=0.5 mm' --set time.cycles=1");
  const auto branch = ports().at("branch");
  EXPECT_LT(branch.flow_out.min(), 0);  // it fills from its outlet, and drains
  EXPECT_GT(branch.flow_out.max(), 0);
  EXPECT_NEAR(branch.flow_out.between(0.1, 0.5).mean(),
              column(reference("backflow_branch"), "side_flow_m3_s").between(0.1, 0.5).mean(), 0.1e-3);
}

TEST_F(ShortCase, BackflowInlet) {
  run("backflow_inlet", "--threads 1 --set 'vessel.spacing=0.4 mm' --set time.cycles=1");
  const auto all = ports();
  const Table exact = reference("backflow_inlet");
  EXPECT_GT(all.at("inlet").flow_out.max(), 0.9e-3);
  EXPECT_GT(all.at("outlet").flow_out.between(0.02, 0.5).min(), 0);
  EXPECT_LT(rms_difference(all.at("outlet").pressure, column(exact, "outlet_pressure_Pa"), 0.5),
            0.05 * 2869.4);
}

}  // namespace
}  // namespace ostium::test
