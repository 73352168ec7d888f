#include "lumped/element.hpp"
#include "lumped/two_terminal.hpp"
#include "network/periodic.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

using lumped::In, lumped::Out, lumped::Quantity, lumped::Unknown;

/// Stenosis, 0 = p_from - p_to - R q - K q |q|: a block that no other part of the program has ever seen.
struct Stenosis : lumped::TwoTerminal {
  double R = 0, K = 0;
  static constexpr const char* type = "stenosis";
  static constexpr auto nature = lumped::Nature::resistive;
  static constexpr bool linear = false;
  static constexpr std::array unknowns{Unknown{"q", Quantity::flow, false}};

  template <class T>
  void equations(const In<Stenosis, T>& x, Out<Stenosis, T>& f) const {
    using std::abs;
    const T& q = x.y[0];
    f.own[0] = x.p[From] - x.p[To] - R * q - K * q * abs(q);
    f.into = {q, -q};
  }
  std::vector<lumped::Terminal> terminals() const { return lumped::two_ends(*this, std::nullopt); }
};
void declare(config::Fields<Stenosis>&) {}

constexpr double R = 1e7, K = 5e11, C = 1e-9, Rd = 1e8;

Model with_stenosis(const std::string& rest) {
  Stenosis s;
  s.from = "A", s.to = "B", s.R = R, s.K = K;
  Model m = model(rest);
  m.entries.push_back({"stenosis", "case.yaml:9:1", std::make_shared<lumped::BlockOf<Stenosis>>(s)});
  return m;
}

const std::string bed = "bed: {type: windkessel, from: B, Rp: 0 Pa.s/m3, C: 1e-9 m3/Pa, Rd: 1e8 Pa.s/m3}\n";

TEST(Nonlinear, SteadyFlowThroughAStenosis) {
  Network n(with_stenosis("in: {type: pressure_source, to: A, pressure: 10000 Pa}\n" + bed));
  EXPECT_FALSE(n.linear());
  run_to(n, 5.0);
  const double a = K, b = R + Rd, q = (-b + std::sqrt(b * b + 4 * a * 1e4)) / (2 * a);
  EXPECT_NEAR(series(n, "q:stenosis_m3_s"), q, 1e-7 * q);
}

/// C du/dt = q(P - u) - u/Rd against a fine Runge-Kutta solution.
TEST(Nonlinear, FillingThroughAStenosis) {
  Network n(with_stenosis("in: {type: pressure_source, to: A, pressure: 10000 Pa}\n" + bed));
  const auto rate = [](double u) {
    const double q = (-R + std::sqrt(R * R + 4 * K * (1e4 - u))) / (2 * K);
    return (q - u / Rd) / C;
  };
  double u = 0;
  const double h = 1e-5;
  for (int i = 0; i < 5000; ++i) {
    const double k1 = rate(u), k2 = rate(u + h / 2 * k1), k3 = rate(u + h / 2 * k2), k4 = rate(u + h * k3);
    u += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  run_to(n, 0.05);
  EXPECT_NEAR(series(n, "p:bed.Pc_Pa"), u, 1e-6 * u);
}

TEST(Nonlinear, PortResistanceIsThatOfThePresentFlow) {
  Network n(with_stenosis(bed), {{"A", 1e-4}});
  for (double q : {2e-5, -4e-5}) {
    const double flow[] = {q};
    n.advance(1e-3, flow, flow);
    EXPECT_NEAR(n.instant_resistance()(0, 0), R + 2 * K * std::abs(q), 1e-9 * R);
  }
}

TEST(Nonlinear, PeriodicStateByShooting) {
  const Model m = with_stenosis(bed +
                                "in: {type: pressure_source, to: A, pressure: {fourier: {mean: 90, cos: "
                                "[-30]}, unit: mmHg, period: 1 s}}\n");
  const Start s = periodic_start(m, {}, 1.0);
  Network n(m);
  n.load(s.state);
  n.advance(1.0, {}, {});
  for (size_t i = 0; i < s.state.y.size(); ++i)
    EXPECT_NEAR(n.save().y[i], s.state.y[i], 1e-6 * std::abs(s.state.y[i])) << n.series_names()[i];
}

}  // namespace
}  // namespace ostium::network
