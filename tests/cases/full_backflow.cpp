// Flow that reverses: through both openings of a channel, in a branch that fills from its outlet, at the inlet alone.
#include <cmath>

#include "case_run.hpp"

namespace ostium::test {
namespace {

class FullBackflow : public CaseRun {
 protected:
  /// Volume inside at the end over that at the start, minus one.
  double gain() const { return inside().value.back() / inside().value.front() - 1; }

  /// Largest over smallest of the mean volumes inside of the periods of half a second, minus one.
  double drift(int periods) const {
    std::vector<double> mean;
    for (int k = 0; k < periods; ++k) mean.push_back(inside().between(0.5 * k, 0.5 * k + 0.5).mean());
    const auto [least, most] = std::minmax_element(mean.begin(), mean.end());
    return noted("drift of the content", *most / *least - 1);
  }

  /// Largest density deviation of any particle of the vessel after the first period.
  double density_error() const {
    const Signal error = balance("max_density_error");
    return noted("largest density deviation", error.between(0.5, error.time.back()).max());
  }

  static double pressure_error(const PortSignals& outlet, const Table& exact) {
    return rms_difference(outlet.pressure, column(exact, "outlet_pressure_Pa"), 0.5);
  }

 private:
  Signal balance(const char* name) const { return column(folder() / "results/balance.csv", name); }
  Signal inside() const { return balance("volume_inside_m3"); }
};

const std::string often = "--threads 1 --set 'output.every=0.5 ms'";  // some ten steps

TEST_F(FullBackflow, Channel) {
  run("backflow_channel", often);
  const PortSignals outlet = ports().at("outlet");
  const Table exact = reference("backflow_channel");
  const double amplitude = 2843.6;  // Pa
  EXPECT_LT(noted("outlet pressure, rms over the amplitude", pressure_error(outlet, exact) / amplitude),
            0.03);
  for (int period = 0; period < 5; ++period)
    EXPECT_NEAR(outlet.pressure.between(0.5 * period, 0.5 * period + 0.5).mean(), 6000, 0.01 * 6000);
  EXPECT_LT(std::abs(gain()), 0.005);
  EXPECT_LT(drift(5), 0.005);
  EXPECT_LT(density_error(), 0.02);
  EXPECT_LE(summary()["mass_balance_relative_to_inflow"].get<double>(), 1e-10);
}

TEST_F(FullBackflow, Branch) {
  run("backflow_branch", often);
  const auto all = ports();
  const Table exact = reference("backflow_branch");
  const Signal branch = all.at("branch").flow_out.between(0.5, 1.5),
               lossless = column(exact, "side_flow_m3_s");
  EXPECT_NEAR(branch.mean(), lossless.mean(), 0.05e-3);  // 50 Pa of stagnation pressure over R
  const double range = lossless.max() - lossless.min();
  EXPECT_NEAR(branch.min(), lossless.min(), 0.1 * range);
  EXPECT_NEAR(branch.max(), lossless.max(), 0.1 * range);
  EXPECT_NEAR(all.at("outlet").flow_out.between(0.5, 1.5).mean(), 1.4e-3, 0.05e-3);
  EXPECT_NEAR(all.at("outlet").pressure.between(0.5, 1.5).mean(), 8100, 0.01 * 8100);
  EXPECT_LT(std::abs(gain()), 0.005);
  EXPECT_LT(density_error(), 0.02);
}

TEST_F(FullBackflow, Inlet) {
  run("backflow_inlet", often);
  const auto all = ports();
  const PortSignals& outlet = all.at("outlet");
  const Table exact = reference("backflow_inlet");
  const double amplitude = 2869.4;  // Pa
  EXPECT_LT(noted("outlet pressure, rms over the amplitude", pressure_error(outlet, exact) / amplitude),
            0.03);
  EXPECT_LT(rms_difference(outlet.flow_out, column(exact, "outlet_flow_m3_s"), 0.5), 0.05 * 2.136e-3);
  for (int period = 0; period < 5; ++period)
    EXPECT_NEAR(outlet.pressure.between(0.5 * period, 0.5 * period + 0.5).mean(), 11250, 0.01 * 11250);
  EXPECT_GT(all.at("inlet").flow_out.max(), 0.9e-3);  // the inlet lets out, the outlet never lets in
  EXPECT_GT(outlet.flow_out.between(0.01, 2.5).min(), 0);
  EXPECT_LT(std::abs(gain()), 0.005);
  EXPECT_LT(drift(5), 0.005);
  EXPECT_LT(density_error(), 0.02);
  EXPECT_LE(summary()["mass_balance_relative_to_inflow"].get<double>(), 1e-10);
}

}  // namespace
}  // namespace ostium::test
