// A vessel full of particles before a Windkessel: the coupled run against the closed form.
#include "coupling/run.hpp"

#include <omp.h>

#include <algorithm>

#include "sph3d/geometry/polygon.hpp"
#include "tests/coupling/support.hpp"

namespace ostium::coupling {
namespace {

constexpr double width = 6.35e-3, length = 3 * width, speed = 0.5, rho = 1000, c = 10, period = 0.2;
constexpr double Zc = rho * c / width;
const OneMinusCosine inflow{.mean = 0.5 * speed * width, .period = period};

/// The compliance is large beside what the fluid stores, length width / (rho c^2) = 1.2e-9 m3/Pa.
Rcr windkessel(double Rp_over_Zc) {
  Rcr w{.Rp = Rp_over_Zc * Zc, .C = 5e-8, .Rd = 4 * Zc};
  w.start = inflow.periodic_start(w);
  return w;
}

sph3d::Lumen<2> channel() {
  const std::vector<Vec2> points{{0, 0}, {length, 0}, {length, width}, {0, width}};
  const std::vector<sph3d::OutlineOpening> openings{{"I", 3}, {"O", 1}};
  return sph3d::polygon_lumen(points, openings);
}

CoupledRun<2> coupled(double Rp_over_Zc, const CoupledOptions& options, int across = 8) {
  const auto lumen = channel();
  std::vector<network::Port> ports;
  for (const auto& o : lumen.openings) ports.push_back({o.name, o.area});
  const std::string heart = fmt::format(
      "heart: {{type: flow_source, to: I, flow: {{fourier: {{mean: {0}, cos: [{1}]}}, unit: m3/s, period: "
      "{2} s}}}}\n",
      inflow.mean, -inflow.mean, period);
  return CoupledRun<2>(lumen,
                       {.dp = width / across,
                        .density = rho,
                        .viscosity = 4e-6,
                        .sound_speed = c,
                        .reference_speed = speed,
                        .density_relaxation = 0.2},
                       {sph3d::Profile::plug, sph3d::Profile::plug},
                       network_of(windkessel(Rp_over_Zc).yaml('O') + heart, ports), {}, options);
}

int port_named(const CoupledRun<2>& run, const std::string& name) {
  for (int k = 0; k < run.port_count(); ++k)
    if (run.network().port(k).opening == name) return k;
  return -1;
}

struct Outcome {
  double error = 0;        // rms of the outlet's pressure over the swing of the exact one
  double discrepancy = 0;  // of the volumes, over what has flowed in
  double drift = 0;        // of the mean pressure, over the swing
  double speed = 0;        // largest, m/s
};

/// The last two of three periods.
Outcome follow(CoupledRun<2>& run, double Rp_over_Zc) {
  const Rcr w = windkessel(Rp_over_Zc);
  const int in = port_named(run, "I"), out = port_named(run, "O");
  const double volume = run.volume_inside();
  Outcome o;
  double time = 0, low = 1e30, high = -1e30;
  while (run.time() < 3 * period * (1 - 1e-12)) {
    const auto report = run.step(3 * period);
    const double balance = run.volume_inside() - volume + run.port(in).volume_out + run.port(out).volume_out;
    o.discrepancy = std::max(o.discrepancy, std::abs(balance));
    o.speed = std::max(o.speed, report.max_speed);
    if (run.time() < period) continue;
    const double exact = inflow.pressure(w, run.time()), e = run.port(out).pressure - exact;
    o.error += report.dt * e * e, o.drift += report.dt * e, time += report.dt;
    low = std::min(low, exact), high = std::max(high, exact);
  }
  o.error = std::sqrt(o.error / time) / (high - low);
  o.drift /= time * (high - low);
  o.discrepancy /= -run.port(in).volume_out;
  return o;
}

Outcome outcome(double Rp_over_Zc, const CoupledOptions& options) {
  auto run = coupled(Rp_over_Zc, options);
  return follow(run, Rp_over_Zc);
}

/// The background keeps the fluid under pressure while the datum follows the steepest change of the ports' pressure.
CoupledOptions with(SchemeKind scheme, double Rp_over_Zc, double exchange = 0) {
  const double datum_time = 2e-3;
  const double rate =
      inflow.omega() * std::abs(windkessel(Rp_over_Zc).impedance(inflow.omega())) * inflow.mean;
  return {.scheme = scheme,
          .exchange = exchange,
          .datum_time = datum_time,
          .period = period,
          .background = 300 + datum_time * rate};
}

TEST(CoupledRun, FollowsTheClosedFormOfTheWindkessel) {
  const auto o = outcome(0.5, with(SchemeKind::linearised, 0.5));
  EXPECT_LT(o.error, 0.03);
  EXPECT_LT(o.discrepancy, 1e-10);
  RecordProperty("error", std::to_string(o.error));
}

TEST(CoupledRun, IsStableFarBeyondTheImpedance) {
  const auto o = outcome(5, with(SchemeKind::linearised, 5));
  EXPECT_LT(o.error, 0.03);
  EXPECT_LT(o.speed, 3 * speed);
  RecordProperty("error", std::to_string(o.error));
}

TEST(CoupledRun, ExplicitSchemesRunInTheirStableRange) {
  for (const auto kind : {SchemeKind::held, SchemeKind::extrapolated, SchemeKind::modified_euler}) {
    const auto o = outcome(0.02, with(kind, 0.02, 2e-3));
    EXPECT_LT(o.error, 0.05) << name(kind);
    EXPECT_LT(o.speed, 3 * speed) << name(kind);
  }
}

TEST(CoupledRun, AnUnstableChoiceIsRefusedUnlessForced) {
  auto options = with(SchemeKind::held, 5);
  try {
    coupled(5, options);
    FAIL() << "accepted";
  } catch (const UserError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("the coupling scheme held would be unstable"));
    EXPECT_THAT(e.what(), testing::HasSubstr("`force: true`"));
  }
  options.force = true;
  EXPECT_THAT(coupled(5, options).warnings(), testing::ElementsAre(testing::HasSubstr("may be unstable")));
}

TEST(CoupledRun, SameBitsForOneAndTwoThreads) {
  const int before = omp_get_max_threads();
  std::vector<sph3d::FluidState<2>> states;
  for (const int threads : {1, 2}) {
    omp_set_num_threads(threads);
    auto run = coupled(0.5, with(SchemeKind::linearised, 0.5));
    while (run.time() < 0.004 * (1 - 1e-9)) run.step(0.004);
    states.push_back(run.vessel().state().fluid);
  }
  omp_set_num_threads(before);
  ASSERT_EQ(states[0].position, states[1].position);
  for (std::size_t i = 0; i < states[0].places(); ++i) {
    ASSERT_EQ(states[0].velocity(i), states[1].velocity(i));
    ASSERT_EQ(states[0].psi(i), states[1].psi(i));
  }
}

}  // namespace
}  // namespace ostium::coupling
