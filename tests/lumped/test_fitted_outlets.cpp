#include <gmock/gmock.h>

#include <complex>
#include <numbers>

#include "lumped/impedance_fit.hpp"
#include "lumped/nonnegative.hpp"
#include "lumped/tree_impedance.hpp"
#include "support.hpp"

namespace ostium::lumped {
namespace {

using Complex = std::complex<double>;
using testing::HasSubstr;
constexpr double pi = std::numbers::pi;

/// Poiseuille resistance of all vessels, generation by generation: sums instead of the recursion.
double resistance_by_hand(const Tree& t, double r) {
  const double own = 8 * t.mu * t.length_ratio / (pi * r * r * r);
  if (r < t.r_min) return own;
  return own + 1 / (1 / resistance_by_hand(t, t.alpha() * r) + 1 / resistance_by_hand(t, t.beta() * r));
}

TEST(Tree, RadiiObeyThePowerLawAndTheAsymmetry) {
  const Tree t;
  EXPECT_NEAR(std::pow(t.alpha(), t.xi) + std::pow(t.beta(), t.xi), 1, 1e-14);
  EXPECT_NEAR(std::pow(t.beta() / t.alpha(), 2), t.eta, 1e-14);
  EXPECT_NEAR(t.alpha(), 0.9, 0.02);  // the values of the literature
  EXPECT_NEAR(t.beta(), 0.6, 0.03);
}

TEST(Tree, AtRestItIsItsPoiseuilleResistances) {
  const Tree t{.r_root = 2e-3, .r_min = 3e-4};
  const double R = resistance_by_hand(t, t.r_root);
  EXPECT_NEAR(impedance(t, 0).real(), R, 1e-12 * R);
  EXPECT_NEAR(impedance(t, 1e-4).real(), R, 1e-5 * R);  // the wave equations tend to it
  EXPECT_NEAR(impedance(t, 1e-4).imag(), 0, 1e-3 * R);
}

/// A single vessel, short for its waves: viscous inertia as Womersley 1955 has it, 4/3 rho l/A at low frequency.
TEST(Tree, SingleVesselIsPoiseuilleAndFourThirdsOfItsInertia) {
  const Tree t{.r_root = 2e-3, .r_min = 3e-3, .length_ratio = 1, .k1 = 0, .k3 = 1e12};
  const double A = pi * 4e-6, l = 2e-3, omega = 0.05;
  const Complex Z = impedance(t, omega);
  EXPECT_NEAR(Z.real(), 8 * pi * t.mu * l / (A * A), 1e-4 * Z.real());
  EXPECT_NEAR(Z.imag(), 4.0 / 3 * omega * t.rho * l / A, 1e-3 * Z.imag());
}

/// At high frequency friction lets nothing come back, and the root alone answers with the impedance of its wave.
TEST(Tree, TendsToTheWaveImpedanceOfItsRoot) {
  const Tree t{.r_root = 6e-3, .r_min = 1e-3};
  const double A = pi * 36e-6, C = 1.5 * A / (t.k1 * std::exp(t.k2 * 6e-3) + t.k3), omega = 2 * pi * 1e4;
  const double w = 6e-3 * std::sqrt(omega * t.rho / t.mu);
  const Complex F = 2.0 / (std::polar(1.0, 0.75 * pi) * w) * Complex(0, 1);  // J1/J0 -> i above the real axis
  const Complex wave = std::sqrt(t.rho / (C * A * (1.0 - F)));
  EXPECT_LT(std::abs(impedance(t, omega) - wave), 0.01 * std::abs(wave));
}

TEST(NonnegativeLeastSquares, FindsTheOptimum) {
  Eigen::MatrixXd A(4, 3);
  A << 1, 2, 0, 0, 1, -1, 3, 0, 1, 1, 1, 1;
  const Eigen::Vector4d b(1, -2, 0.5, 3);
  const Eigen::VectorXd x = nonnegative_least_squares(A, b), g = A.transpose() * (A * x - b);
  for (int i = 0; i < 3; ++i) {  // Kuhn & Tucker
    EXPECT_GE(x[i], 0);
    EXPECT_GE(g[i], -1e-9);
    EXPECT_NEAR(x[i] * g[i], 0, 1e-9);
  }
}

/// Z = 3 + 5/(1 + 0.2 s) + 2 (0.01 s)/(1 + 0.01 s): between its corners it must come back.
TEST(ImpedanceFit, FindsWhatIsOfItsKind) {
  std::vector<ImpedanceSample> samples{{0, 8}};
  const auto Z = [](double w) {
    return 3.0 + 5.0 / (1.0 + Complex(0, 0.2 * w)) +
           2.0 * Complex(0, 0.01 * w) / (1.0 + Complex(0, 0.01 * w));
  };
  for (double w = 0.1; w < 1000; w *= 1.3) samples.push_back({w, Z(w)});
  const auto fit = fit_impedance(samples, 12);
  EXPECT_LT(fit.error, 2e-4);
  EXPECT_NEAR(fit(0).real(), 8, 1e-9);
  EXPECT_LT(std::abs(fit(33.3) - Z(33.3)), 1e-3 * std::abs(Z(33.3)));
}

/// Whatever the table says, also nonsense: the real part is nowhere negative and all poles lie left.
TEST(ImpedanceFit, IsPassiveWhateverTheSamples) {
  std::vector<ImpedanceSample> samples;
  unsigned random = 7;
  const auto next = [&] { return (random = random * 1664525u + 1013904223u) / 4294967296.0; };
  for (double w = 0.5; w < 300; w *= 1.4)
    samples.push_back({w, std::polar(1 + 5 * next(), pi * (next() - 0.5))});
  const auto fit = fit_impedance(samples, 12);
  EXPECT_GE(fit.D, 0);
  for (const auto& term : fit.terms) EXPECT_TRUE(term.tau > 0 && term.damping >= 0);
  for (double w = 1e-4; w < 1e6; w *= 1.05) EXPECT_GE(fit(w).real(), -1e-12) << w;
}

TEST(ImpedanceFit, MeetsStructuredTrees) {
  for (const double r : {0.5e-3, 1e-3, 2e-3, 3e-3}) {
    const Tree t{.r_root = r, .r_min = 1e-4};
    std::vector<ImpedanceSample> samples{{0, impedance(t, 0)}};
    for (int k = 0; k <= 30; ++k) {
      const double w = 2 * pi * 0.02 * std::pow(10, 0.1 * k);
      samples.push_back({w, impedance(t, w)});
    }
    const auto fit = fit_impedance(samples, 12);
    EXPECT_LT(fit.error, 0.015) << r;
    int states = 0;
    for (const auto& term : fit.terms) states += term.damping > 0 ? 2 : 1;
    EXPECT_LE(states, 12);
    EXPECT_NEAR(fit(0).real(), samples[0].Z.real(), 1e-12 * samples[0].Z.real());
    for (const double f : {0.37, 1.1, 2.3, 4.7, 9.1, 14.0})  // between the samples
      EXPECT_LT(std::abs(fit(2 * pi * f) - impedance(t, 2 * pi * f)),
                0.05 * std::abs(impedance(t, 2 * pi * f)))
          << r << " at " << f;
    RecordProperty("rms_error_" + std::to_string(static_cast<int>(1e4 * r)), std::to_string(fit.error));
  }
}

TEST(FittedOutlets, RefuseBadInput) {
  EXPECT_THAT(error_of("{type: structured_tree, from: a, r_root: 1 mm, r_min: 2 mm}"),
              HasSubstr("a tree needs r_min < r_root"));
  EXPECT_THAT(error_of("{type: structured_tree, from: a, r_root: 10 mm, r_min: 1e-3 um, xi: 4, eta: 0.01}"),
              HasSubstr("generations, at most 200 are allowed"));
  EXPECT_THAT(error_of("{type: structured_tree, r_root: 2 mm, r_min: 1 mm}"), HasSubstr("has no `from`"));
  const auto table = [](const std::string& f, const std::string& m, const std::string& p) {
    return error_of("{type: impedance, from: a, frequency: " + f + ", modulus: " + m + ", phase: " + p + "}");
  };
  EXPECT_THAT(table("0 1 2 Hz", "3 2 Pa.s/m3", "0 0 rad"),
              HasSubstr("\"frequency\" has 3 values, \"modulus\" 2"));
  EXPECT_THAT(table("0 2 1 Hz", "3 2 1 Pa.s/m3", "0 0 0 rad"), HasSubstr("the 3. \"frequency\" is 1 Hz"));
  EXPECT_THAT(table("0 1 Hz", "3 -2 Pa.s/m3", "0 0 rad"), HasSubstr("the 2. \"modulus\" is -2"));
  EXPECT_THAT(table("0 1 Hz", "3 2 Pa.s/m3", "0 -100 deg"), HasSubstr("takes energy up at every frequency"));
  EXPECT_THAT(table("0 1 m", "3 2 Pa.s/m3", "0 0 rad"), HasSubstr("wrong dimension"));
}

}  // namespace
}  // namespace ostium::lumped
