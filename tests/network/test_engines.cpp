#include "network/simulate.hpp"
#include "network/sparse_lu.hpp"
#include "network/state_space.hpp"
#include "network/tableau.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

/// The conditions of order, to fourth order for four (Hairer, Norsett & Wanner, table II.2.1).
TEST(Tableau, ConditionsOfOrder) {
  for (const Tableau* t : {&third_order(), &fourth_order()}) {
    const auto& b = t->a[t->stages - 1];
    const auto apply = [&](const std::array<double, 6>& x) {
      std::array<double, 6> y{};
      for (int i = 0; i < t->stages; ++i)
        for (int j = 0; j < t->stages; ++j) y[i] += t->a[i][j] * x[j];
      return y;
    };
    const auto mean = [&](const std::array<double, 6>& x, const std::array<double, 6>& weights) {
      double sum = 0;
      for (int j = 0; j < t->stages; ++j) sum += weights[j] * x[j];
      return sum;
    };
    std::array<double, 6> one, c2, c3, cAc, lower = b;
    one.fill(1);
    const auto Ac = apply(t->c);
    for (int j = 0; j < 6; ++j) {
      c2[j] = t->c[j] * t->c[j], c3[j] = c2[j] * t->c[j], cAc[j] = t->c[j] * Ac[j];
      lower[j] -= t->error[j];
      EXPECT_NEAR(apply(one)[j], j < t->stages ? t->c[j] : 0, 1e-14);
      if (j < t->stages) {
        EXPECT_NEAR(Ac[j], c2[j] / 2, 1e-14) << "stage order 2";
      }
    }
    EXPECT_NEAR(mean(one, b), 1, 1e-14);
    EXPECT_NEAR(mean(t->c, b), 1.0 / 2, 1e-14);
    EXPECT_NEAR(mean(c2, b), 1.0 / 3, 1e-14);
    EXPECT_NEAR(mean(Ac, b), 1.0 / 6, 1e-14);
    EXPECT_NEAR(mean(one, lower), 1, 1e-14);
    EXPECT_NEAR(mean(t->c, lower), 1.0 / 2, 1e-14);
    if (t->order < 4) continue;
    EXPECT_NEAR(mean(c3, b), 1.0 / 4, 1e-14);
    EXPECT_NEAR(mean(cAc, b), 1.0 / 8, 1e-14);
    EXPECT_NEAR(mean(apply(c2), b), 1.0 / 12, 1e-14);
    EXPECT_NEAR(mean(apply(Ac), b), 1.0 / 24, 1e-14);
    EXPECT_NEAR(mean(c2, lower), 1.0 / 3, 1e-14);
    EXPECT_NEAR(mean(Ac, lower), 1.0 / 6, 1e-14);
  }
}

TEST(PhiFunctions, ScalarsAndANilpotentMatrix) {
  for (double z : {-30.0, -1.0, -1e-3, 0.7, 3.0}) {
    const auto phi = phi_functions(Eigen::MatrixXd::Constant(1, 1, z));
    const double series[] = {1, 1, 1.0 / 2, 1.0 / 6, 1.0 / 24};
    EXPECT_NEAR(phi[0](0, 0), std::exp(z), 1e-13 * std::exp(z)) << z;
    for (int k = 1; k <= 4; ++k)  // phi_k = z phi_(k+1) + 1/k!
      EXPECT_NEAR(phi[k - 1](0, 0), z * phi[k](0, 0) + series[k - 1], 1e-12) << z << " " << k;
    EXPECT_NEAR(phi[1](0, 0), std::expm1(z) / z, 1e-13 * std::max(1.0, std::exp(z))) << z;
  }
  Eigen::Matrix2d n;
  n << 0, 8, 0, 0;
  const auto phi = phi_functions(n);
  EXPECT_NEAR(phi[0](0, 1), 8, 1e-13);
  EXPECT_NEAR(phi[1](0, 1), 4, 1e-13);
  EXPECT_NEAR(phi[4](0, 1), 8.0 / 120, 1e-14);
  EXPECT_NEAR(phi[4](0, 0), 1.0 / 24, 1e-15);
}

TEST(SparseLu, SolvesBothWaysAndFindsNewPivots) {
  const int start[] = {0, 2, 4, 7}, row[] = {0, 1, 0, 1, 0, 1, 2};
  const double first[] = {4, 1, 1, 3, 0, 2, 5}, second[] = {0, 1, 1, 0, 0, 2, 5},
               none[] = {1, 1, 1, 1, 0, 0, 5};
  SparseLu lu(3, start, row);
  for (const double* a : {first, second}) {
    ASSERT_TRUE(lu.refactor(a));
    std::vector<double> b{1, 2, 3}, x = b, w = b;
    lu.solve(x), lu.solve_transposed(w);
    EXPECT_NEAR(a[0] * x[0] + a[2] * x[1] + a[4] * x[2], 1, 1e-14);
    EXPECT_NEAR(a[1] * x[0] + a[3] * x[1] + a[5] * x[2], 2, 1e-14);
    EXPECT_NEAR(a[4] * w[0] + a[5] * w[1] + a[6] * w[2], 3, 1e-14);
  }
  EXPECT_FALSE(lu.refactor(none));
}

/// A ladder of thirty compliances that the exponential and the constant matrices must agree on.
TEST(LinearNetworks, StepsAgreeWithTheExponential) {
  std::string yaml =
      "in: {type: flow_source, to: n0, flow: {times: [0, 0.1, 0.3, 1], time_unit: s, values: [0, 100, 20, "
      "0], unit: "
      "mL/s, "
      "period: 1 s}}\n";
  for (int i = 0; i < 15; ++i)
    yaml += fmt::format(
        "c{0}: {{type: capacitor, from: n{0}, C: {2}e-10 m3/Pa}}\nv{0}: {{type: vessel, from: n{0}, to: "
        "n{1}, R: 3e6 "
        "Pa.s/m3, L: 1e5 Pa.s2/m3}}\n",
        i, i + 1, 1 + i % 3);
  yaml += "end: {type: resistor, from: n15, ground: 0 Pa, R: 2e7 Pa.s/m3}\n";
  Network exact(model(yaml), {}, with(Method::exact));
  Network steps(model(yaml), {}, {.method = Method::runge_kutta, .relative_tolerance = 1e-9});
  ASSERT_TRUE(steps.linear());
  for (int i = 1; i <= 20; ++i) {
    run_to(exact, 0.093 * i), run_to(steps, 0.093 * i);
    for (const char* name : {"p:n0_Pa", "p:n7_Pa", "q:v9_m3_s"}) {
      const double scale = name[0] == 'p' ? 13332 : 1e-4;
      EXPECT_NEAR(series(steps, name), series(exact, name), 1e-6 * scale) << name << " " << exact.time();
    }
  }
}

const std::string heart =
    "s: {type: pressure_source, to: A, pressure: {fourier: {mean: 20, sin: [100]}, unit: mmHg, period: 1 "
    "s}}\n"
    "v: {type: valve, from: A, to: B, R: 1e7 Pa.s/m3, L: 5e5 Pa.s2/m3}\n"
    "w: {type: windkessel, from: B, Rp: 1e7 Pa.s/m3, C: 1e-8 m3/Pa, Rd: 1e8 Pa.s/m3}\n";

std::vector<std::vector<double>> rows_of(const Model& m, const SimulateOptions& o, int stop_after,
                                         std::optional<State>* kept = nullptr) {
  std::vector<std::vector<double>> rows;
  simulate(m, o,
           {[](const auto&) {},
            [&](double t, std::span<const double> y) {
              rows.emplace_back(y.begin(), y.end());
              rows.back().push_back(t);
              return static_cast<int>(rows.size()) != stop_after;
            },
            [&](const State& s) {
              if (kept) *kept = s;
            }});
  return rows;
}

/// Wherever a run stops, what goes on from the state it keeps hands out the rows the whole run would have.
TEST(Simulate, GoesOnWithTheSameBits) {
  const Model m = model(heart);
  const SimulateOptions whole{.end = 3, .every = 0.004};
  const auto all = rows_of(m, whole, 0);
  ASSERT_EQ(all.size(), 751u);
  for (int stop : {1, 60, 511, 512, 513, 514, 600, 750}) {
    std::optional<State> kept;
    auto rows = rows_of(m, whole, stop, &kept);
    ASSERT_TRUE(kept) << stop;
    auto rest = whole;
    rest.from = kept, rest.handed_out = rows.back().back();
    const auto after = rows_of(m, rest, 0);
    rows.insert(rows.end(), after.begin(), after.end());
    EXPECT_EQ(rows, all) << stop;
  }
}

/// Rows between two steps come from the interpolant: against a run that is exact to 1e-10.
TEST(Simulate, RowsBetweenStepsAreAsGoodAsTheSteps) {
  const Model m = model(heart);
  SimulateOptions o{.end = 1, .every = 0.0005};
  const auto rows = rows_of(m, o, 0);
  o.relative_tolerance = 1e-10;
  const auto fine = rows_of(m, o, 0);
  ASSERT_EQ(rows.size(), fine.size());
  for (std::size_t j = 0; j < rows[0].size() - 1; ++j) {
    double square = 0, size = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
      square += std::pow(rows[i][j] - fine[i][j], 2), size += std::pow(fine[i][j], 2);
    EXPECT_LT(std::sqrt(square / size), 2e-4) << j;
  }
}

}  // namespace
}  // namespace ostium::network
