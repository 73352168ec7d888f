// Outlets given by an impedance, in a network.
#include "lumped/tree_impedance.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

using Complex = std::complex<double>;

TEST(FittedOutlets, NetworkHasTheTreesImpedance) {
  Network n(model("t: {type: structured_tree, from: A, r_root: 2 mm, r_min: 0.1 mm, Pd: 20 mmHg}\n"),
            {{.opening = "A", .area = 1.25e-5}});
  const lumped::Tree tree{.r_root = 2e-3, .r_min = 1e-4};
  for (const double f : {0.05, 1.0, 2.0, 3.0, 5.0, 8.0, 12.0, 20.0}) {
    const Complex exact = lumped::impedance(tree, 2 * pi * f), made = n.impedance(0, 2 * pi * f);
    EXPECT_LT(std::abs(made - exact), 0.03 * std::abs(exact)) << f << " Hz";
  }
}

/// Mean and oscillation of a flow with three harmonics, in the time domain, against the tree's own impedance.
TEST(FittedOutlets, PulsatileFlowIntoATree) {
  Network n(model(
      "heart: {type: flow_source, to: A, flow: {fourier: {mean: 3, cos: [2, -1, 0.5], sin: [1, 1, -0.5]}, "
      "unit: mL/s, period: 1 s}}\n"
      "t: {type: structured_tree, from: A, r_root: 2 mm, r_min: 0.1 mm, Pd: 20 mmHg}\n"));
  const lumped::Tree tree{.r_root = 2e-3, .r_min = 1e-4};
  const double a[] = {2e-6, -1e-6, 0.5e-6}, b[] = {1e-6, 1e-6, -0.5e-6};
  double worst = 0, swing = 0;
  for (int i = 0; i < 50; ++i) {
    const double t = 20 + 0.02 * i;
    run_to(n, t);
    double p = 20 * 133.322387415 + 3e-6 * lumped::impedance(tree, 0).real(), wave = 0;
    for (int k = 1; k <= 3; ++k)
      wave += (lumped::impedance(tree, 2 * pi * k) * Complex(a[k - 1], -b[k - 1]) *
               std::polar(1.0, 2 * pi * k * t))
                  .real();
    worst = std::max(worst, std::abs(series(n, "p:A_Pa") - p - wave)),
    swing = std::max(swing, std::abs(wave));
  }
  EXPECT_LT(worst, 0.02 * swing);
  RecordProperty("largest_error_over_swing", std::to_string(worst / swing));
}

/// The table of a Windkessel is met by that Windkessel.
TEST(FittedOutlets, TableOfAWindkessel) {
  const double Rp = 1e7, C = 1e-8, Rd = 1.5e8;
  std::string f, m, p;
  for (int k = 0; k <= 20; ++k) {
    const Complex Z = Rp + Rd / (1.0 + Complex(0, 2 * pi * k * Rd * C));
    f += std::to_string(k) + " ", m += std::to_string(std::abs(Z)) + " ",
        p += std::to_string(std::arg(Z)) + " ";
  }
  Network n(model("z: {type: impedance, from: A, frequency: " + f + "Hz, modulus: " + m +
                  "Pa.s/m3, phase: " + p + "rad}\n"),
            {{.opening = "A", .area = 1e-4}});
  EXPECT_TRUE(n.linear());
  for (const double hz : {0.0, 1.0, 2.5, 7.3, 20.0}) {
    const Complex exact = Rp + Rd / (1.0 + Complex(0, 2 * pi * hz * Rd * C));
    EXPECT_LT(std::abs(n.impedance(0, 2 * pi * hz) - exact), 0.005 * std::abs(exact)) << hz;
  }
}

}  // namespace
}  // namespace ostium::network
