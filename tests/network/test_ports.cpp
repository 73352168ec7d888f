#include <random>

#include "network/state_space.hpp"
#include "network/system.hpp"
#include "tests/network/support.hpp"

namespace ostium::network {
namespace {

constexpr double Rp = 9.8e6, C = 6.02e-9, Rd = 1.65e8;
const std::string rcr =
    "dao: {type: windkessel, from: DAo, Rp: 9.8e6 Pa.s/m3, C: 6.02e-9 m3/Pa, Rd: 1.65e8 Pa.s/m3}\n";
const std::string heart =
    "heart: {type: flow_source, to: AAo, flow: {fourier: {mean: 80, cos: [-30]}, unit: mL/s, period: 1 s}}\n";

TEST(Ports, FlowSourceAloneMakesAFlowPort) {
  Network n(model(heart + rcr), {{"AAo", 4e-4}, {"DAo", 3e-4}});
  EXPECT_EQ(n.kind(0), PortKind::flow);
  EXPECT_EQ(n.kind(1), PortKind::pressure);
  EXPECT_NEAR(n.flow_into_vessel(0, 0.5), 110e-6, 1e-18);
  EXPECT_EQ(n.flow_into_vessel(1, 0.5), 0);
  EXPECT_EQ(n.pressure(0), 0);
}

TEST(Ports, FlowSourceDrawingFromAnOpening) {
  Network n(model("pump: {type: flow_source, from: AAo, flow: 5 mL/s}\n" + rcr),
            {{"AAo", 4e-4}, {"DAo", 3e-4}});
  EXPECT_NEAR(n.flow_into_vessel(0, 0), -5e-6, 1e-20);
}

TEST(Ports, VelocityOfAnOpening) {
  Network n(model("heart: {type: flow_source, to: AAo, velocity: 0.5 m/s}\n" + rcr),
            {{"AAo", 4e-4}, {"DAo", 3e-4}});
  EXPECT_NEAR(n.flow_into_vessel(0, 0), 2e-4, 1e-18);
}

TEST(Ports, FlowSourceBesideAResistorLeavesAPressurePort) {
  Network n(model("heart: {type: flow_source, to: DAo, flow: 5 mL/s}\n" + rcr), {{"DAo", 3e-4}});
  EXPECT_EQ(n.kind(0), PortKind::pressure);
  const double none[] = {0.0};
  n.advance(100.0, none, none);
  EXPECT_NEAR(n.pressure(0), 5e-6 * (Rp + Rd), 1e-6 * 5e-6 * (Rp + Rd));
}

TEST(Ports, ResistanceOfAWindkessel) {
  Network n(model(rcr), {{"DAo", 3e-4}});
  for (double dt : {1e-5, 1e-3, 0.02, 0.5, 0.02})
    EXPECT_NEAR(n.port_resistance(dt)(0, 0), Rp - Rd * std::expm1(-dt / (Rd * C)), 1e-12 * Rp);
  EXPECT_NEAR(n.instant_resistance()(0, 0), Rp, 1e-12 * Rp);
  EXPECT_DOUBLE_EQ(n.total_compliance(), C);
}

TEST(Ports, ImpedanceOfAWindkessel) {
  Network n(model(rcr), {{"DAo", 3e-4}});
  for (double w : {0.0, 1.0, 2 * pi, 100.0}) {
    const auto Z = Rp + Rd / std::complex<double>(1, w * Rd * C);
    EXPECT_LT(std::abs(n.impedance(0, w) - Z), 1e-12 * std::abs(Z));
  }
}

const std::string joined = rcr +
                           "bca: {type: resistor, from: BCA, to: V, R: 3e7 Pa.s/m3}\n"
                           "lsa: {type: resistor, from: LSA, to: V, R: 5e7 Pa.s/m3}\n"
                           "v: {type: capacitor, from: V, C: 2e-9 m3/Pa}\n"
                           "w: {type: resistor, from: V, ground: 3 mmHg, R: 4e7 Pa.s/m3}\n";
const std::vector<Port> three{{"DAo", 3e-4}, {"BCA", 1e-4}, {"LSA", 1e-4}};

/// What the linearisation promises is what two runs, apart by a flow held over dt, show.
TEST(Ports, ResistanceOfANetworkIsWhatTwoRunsShow) {
  for (auto method : {Method::exact, Method::runge_kutta, Method::ida}) {
    Network n(model(joined), three, with(method));
    const State before = n.save();
    const double dt = 0.03, dq = 1e-5;
    const Eigen::MatrixXd R = n.port_resistance(dt);
    const std::vector<double> none(3, 0.0);
    n.advance(dt, none, none);
    const double P0[] = {n.pressure(0), n.pressure(1), n.pressure(2)};
    for (int l = 0; l < 3; ++l) {
      n.load(before);
      std::vector<double> q(3, 0.0);
      q[l] = dq;
      n.advance(dt, q, q);
      for (int k = 0; k < 3; ++k)
        EXPECT_NEAR((n.pressure(k) - P0[k]) / dq, R(k, l), 1e-5 * R(1, 1)) << k << l;
    }
    EXPECT_EQ(R(0, 1), 0);
    EXPECT_NEAR(R(1, 2), R(2, 1), 1e-9 * R(1, 2));
    EXPECT_GT(R(1, 2), 0);
  }
}

TEST(Ports, SlopeIsTheDriftForHeldFlow) {
  Network n(model(joined + "p: {type: pressure_source, to: U, pressure: {fourier: {mean: 5, sin: [3]}, unit: "
                           "mmHg, period: 1 s}}\n"
                           "u: {type: resistor, from: U, to: BCA, R: 2e7 Pa.s/m3}\n"),
            three);
  const std::vector<double> q{20e-6, 30e-6, -5e-6};
  n.advance(0.13, q, q);
  const double slope = n.pressure_slope(1), before = n.pressure(1), dt = 1e-4;
  n.advance(dt, q, q);
  EXPECT_NEAR((n.pressure(1) - before) / dt, slope, 2e-3 * std::abs(slope));
}

TEST(Ports, SaveAndLoadAreExact) {
  for (auto method : {Method::exact, Method::runge_kutta, Method::ida}) {
    const std::vector<double> a{20e-6, 30e-6, -5e-6}, b{-7e-6, 9e-6, 3e-6};
    Network n(model(joined), three, with(method));
    n.advance(0.011, a, b);
    const State middle = n.save();
    n.advance(0.013, b, a);
    n.advance(0.007, a, b);
    Network m(model(joined), three, with(method));
    m.load(middle);
    m.advance(0.013, b, a);
    m.advance(0.007, a, b);
    EXPECT_EQ(n.save().y, m.save().y);
    EXPECT_EQ(n.save().dy, m.save().dy);
    EXPECT_EQ(n.time(), m.time());
  }
}

TEST(Ports, StateOfAnotherNetworkIsRefused) {
  Network n(model(rcr), {{"DAo", 3e-4}}), m(model(joined), three);
  try {
    n.load(m.save());
    FAIL();
  } catch (const UserError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("belongs to another case"));
  }
}

/// The assembled Jacobian against differences of the assembled residual.
TEST(System, JacobianAgreesWithDifferences) {
  System s(
      model(
          heart + joined +
          "l: {type: inductor, from: V, to: W, L: 1e5 Pa.s2/m3}\nx: {type: resistor, from: W, ground: 0 Pa, "
          "R: 1e6 Pa.s/m3}\n"),
      {{"AAo", 4e-4}, three[0], three[1], three[2]});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> some(-1, 1);
  const std::vector<double> q(4, 1e-5);
  Eigen::VectorXd y(s.size()), dy(s.size()), up(s.size()), down(s.size());
  for (int i = 0; i < s.size(); ++i) y[i] = some(random) * s.scale()[i], dy[i] = some(random) * s.scale()[i];
  Eigen::SparseMatrix<double> Jy = s.pattern(), Jd = s.pattern();
  s.jacobian(0.1, y.data(), dy.data(), Jy.valuePtr(), Jd.valuePtr());
  for (auto* part : {&y, &dy})
    for (int j = 0; j < s.size(); ++j) {
      const double h = s.scale()[j], kept = (*part)[j];
      (*part)[j] = kept + h;
      s.residual(0.1, y.data(), dy.data(), q, up.data());
      (*part)[j] = kept - h;
      s.residual(0.1, y.data(), dy.data(), q, down.data());
      (*part)[j] = kept;
      const Eigen::VectorXd column = (part == &y ? Jy : Jd).col(j);
      EXPECT_LT(((up - down) / (2 * h) - column).norm(), 1e-9 * column.norm() + 1e-18) << s.names()[j];
    }
}

}  // namespace
}  // namespace ostium::network
