#include "network/design.hpp"

#include <algorithm>
#include <cmath>

#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Law = Variation::Law;

Variation varied(const std::string& name, Law law, double low, double high) {
  return {.parameter = {.name = name, .unit = "Pa"}, .law = law, .low = low, .high = high};
}
Variation listed(const std::string& name, std::vector<double> values) {
  Variation v = varied(name, Law::listed, 0, 0);
  v.values = std::move(values);
  return v;
}

std::vector<double> row(const Design& d, std::int64_t i) {
  std::vector<double> values(static_cast<std::size_t>(d.columns()));
  d.row(i, values);
  return values;
}
std::vector<double> column(const Design& d, std::size_t k) {
  std::vector<double> values;
  for (std::int64_t i = 0; i < d.rows(); ++i) values.push_back(row(d, i)[k]);
  return values;
}

TEST(Variation, NormalQuantile) {
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-15);
  EXPECT_NEAR(normal_quantile(0.25), -0.6744897501960817, 1e-15);
  EXPECT_NEAR(normal_quantile(1e-10), -6.361340902404056, 1e-14);
  EXPECT_NEAR(normal_quantile(0.5), 0, 1e-16);
}

TEST(Variation, Distributions) {
  const Variation log = varied("a", Law::log_uniform, 1e-3, 1e3);
  EXPECT_NEAR(log.at(0.5), 1, 1e-14);
  EXPECT_NEAR(log.at(0.25), std::pow(10, -1.5), 1e-14);
  EXPECT_EQ(varied("a", Law::uniform, 2, 6).at(0.25), 3);
  Variation normal{.parameter = {.name = "a", .unit = "Pa"}, .law = Law::normal, .mean = 5, .deviation = 2};
  EXPECT_NEAR(normal.at(0.975), 5 + 2 * 1.959963984540054, 1e-13);
  normal.low = 5;  // the upper half
  EXPECT_NEAR(normal.at(0.5), 5 + 2 * 0.6744897501960817, 1e-13);
  EXPECT_EQ(listed("a", {1, 2, 4}).at(0.5), 2);
  EXPECT_EQ(listed("a", {1, 2, 4}).at(0.999), 4);
  EXPECT_THAT(evenly(varied("a", Law::uniform, 1, 3), 5), ElementsAre(1, 1.5, 2, 2.5, 3));
  EXPECT_NEAR(evenly(varied("a", Law::log_uniform, 1, 100), 3)[1], 10, 1e-13);
}

TEST(Variation, Refusals) {
  EXPECT_THAT(refusal([] { check(varied("bed.Rd", Law::uniform, 3, 2)); }),
              HasSubstr("bed.Rd: low is 3 and high 2 Pa; low must be below high"));
  EXPECT_THAT(refusal([] { check(varied("bed.Rd", Law::log_uniform, 0, 2)); }),
              HasSubstr("a logarithmic scale needs low > 0; raise it, or choose `scale: linear`"));
  EXPECT_THAT(refusal([] { check(listed("bed.Rd", {})); }), HasSubstr("the list of values is empty"));
  Variation v = varied("bed.Rd", Law::uniform, -1, 2);
  v.parameter.range = {.low = 0};
  EXPECT_THAT(refusal([&] { check(v); }), HasSubstr("bed.Rd is -1 Pa, and must be >= 0"));
  v = varied("bed.Rd", Law::normal, 10, 11);
  EXPECT_THAT(refusal([&] { check(v); }), HasSubstr("the standard deviation is 0 Pa; it must be > 0"));
  v.deviation = 1;
  EXPECT_THAT(refusal([&] { check(v); }), HasSubstr("lies next to nothing of a normal distribution"));
}

TEST(Design, AGridInOrder) {
  const Design d({.sampling = Sampling::grid, .parameters = {listed("a", {1, 2}), listed("b", {5, 6, 7})}});
  ASSERT_EQ(d.rows(), 6);
  EXPECT_THAT(column(d, 0), ElementsAre(1, 1, 1, 2, 2, 2));
  EXPECT_THAT(column(d, 1), ElementsAre(5, 6, 7, 5, 6, 7));
}

TEST(Design, ALatinHypercubeHasOneDrawInEachSlice) {
  const int n = 500;
  const Design d({.sampling = Sampling::latin_hypercube,
                  .count = n,
                  .parameters = {varied("a", Law::uniform, 0, n), varied("b", Law::uniform, 0, n)}});
  double products = 0;
  for (std::size_t k = 0; k < 2; ++k) {
    auto values = column(d, k);
    std::sort(values.begin(), values.end());
    for (int i = 0; i < n; ++i) EXPECT_EQ(std::floor(values[static_cast<std::size_t>(i)]), i);
  }
  for (int i = 0; i < n; ++i) products += (row(d, i)[0] / n - 0.5) * (row(d, i)[1] / n - 0.5);
  EXPECT_NEAR(products / n, 0, 4 / 12.0 / std::sqrt(n));  // the two are shuffled independently
}

TEST(Design, SaltelliRows) {
  const std::vector<Variation> three{varied("a", Law::uniform, 0, 1), varied("b", Law::uniform, 0, 1),
                                     varied("c", Law::uniform, 0, 1)};
  const Design d({.sampling = Sampling::saltelli, .count = 4, .parameters = three});
  ASSERT_EQ(d.rows(), 4 * 5);
  for (int j = 0; j < 4; ++j) {
    const auto A = row(d, 5 * j), B = row(d, 5 * j + 1);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NE(A[k], B[k]);
      auto mixed = A;
      mixed[k] = B[k];
      EXPECT_EQ(row(d, 5 * j + 2 + static_cast<int>(k)), mixed);
    }
  }
}

TEST(Design, RowsDependOnTheSeedAlone) {
  const auto design = [](std::uint64_t seed, std::int64_t count) {
    return Design({.sampling = Sampling::random,
                   .count = count,
                   .seed = seed,
                   .parameters = {varied("a", Law::uniform, 0, 1)}});
  };
  EXPECT_EQ(row(design(1, 10), 9), row(design(1, 1000), 9));  // more samples begin with the same ones
  EXPECT_NE(row(design(1, 10), 9), row(design(2, 10), 9));
}

TEST(Design, Refusals) {
  const auto refused = [](DesignOptions o) { return refusal([&] { Design{o}; }); };
  EXPECT_THAT(refused({.count = 3, .parameters = {}}), HasSubstr("needs at least one parameter"));
  EXPECT_THAT(refused({.count = 0, .parameters = {listed("a", {1})}}), HasSubstr("found a count of 0"));
  EXPECT_THAT(refused({.count = 3, .parameters = {listed("a", {1}), listed("a", {1})}}),
              HasSubstr("the parameter a is given twice"));
  std::vector<Variation> many;
  for (int k = 0; k < 13; ++k) many.push_back(listed(fmt::format("p{}", k), std::vector<double>(10, 1.0)));
  EXPECT_THAT(refused({.sampling = Sampling::grid, .parameters = many}),
              HasSubstr("the sweep has 1e+13 samples (10 x 10 x"));
}

}  // namespace
}  // namespace ostium::network
