#include "network/vessel_fit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ostium::network {
namespace {

using Eigen::ArrayXd;

constexpr int n = 100;

/// Pressures and flows of a made-up beat that fulfil the vessel's equations to round-off.
EndsOfVessel ends_of(const VesselParameters& p, bool compliance_first) {
  const ArrayXd t = ArrayXd::LinSpaced(n, 0, 1);
  const ArrayXd q = 8e-5 + 6e-5 * (6.3 * t).sin() - 1.2e-4 * (12.6 * t).cos();
  const ArrayXd dq = 4e-4 * (6.3 * t).cos() + 1.5e-3 * (12.6 * t).sin();
  const ArrayXd pressure = 1.2e4 + 2e3 * (6.3 * t - 0.4).sin(), rate = 1.3e4 * (6.3 * t - 0.4).cos();
  EndsOfVessel e;
  e.compliance_first = compliance_first;
  e.q_in = q, e.dq_in = dq, e.p_in = pressure, e.dp_in = rate;
  e.dq_out = 0.8 * dq + 1e-4 * (31 * t).sin();
  const ArrayXd charging = compliance_first ? rate : ArrayXd(rate - (p.R + 2 * p.S * q.abs()) * dq);
  e.q_out = q - p.C * charging;
  const ArrayXd through = compliance_first ? e.q_out.array() : q;
  e.p_out = pressure - (p.R + p.S * through.abs()) * through - p.L * e.dq_out.array();
  return e;
}

void expect_same(const VesselParameters& found, const VesselParameters& p, double relative) {
  EXPECT_NEAR(found.R, p.R, relative * std::abs(p.R));
  EXPECT_NEAR(found.C, p.C, relative * p.C);
  EXPECT_NEAR(found.L, p.L, relative * p.L);
  EXPECT_NEAR(found.S, p.S, relative * std::abs(p.S));
}

TEST(VesselFit, FindsWhatTheBeatWasMadeWith) {
  for (const bool compliance_first : {false, true})
    for (const VesselParameters p :
         {VesselParameters{2e7, 3e-10, 4e5, 1e11}, {5e6, 2e-9, 1e5, -2e10}, {-3e5, 1e-9, 2e5, 5e9}}) {
      const auto fit = fit_vessel(ends_of(p, compliance_first), {}, {});
      expect_same(fit.parameters, p, 1e-8);
      EXPECT_LT(fit.residual, 1e-12);
      EXPECT_EQ(fit.undetermined, 0);
    }
}

/// The same beat in other units (mmHg, mL) with errors: the same vessel.
TEST(VesselFit, UnitsDoNotMatter) {
  auto e = ends_of({2e7, 3e-10, 4e5, 1e11}, false);
  for (int k = 0; k < n; ++k) e.p_out[k] += 50 * std::sin(17.0 * k), e.q_out[k] += 1e-6 * std::sin(13.0 * k);
  const auto si = fit_vessel(e, {}, {}).parameters;
  const double P = 1 / 133.322387415, Q = 1e6;
  for (auto* p : {&e.p_in, &e.p_out, &e.dp_in}) *p *= P;
  for (auto* q : {&e.q_in, &e.q_out, &e.dq_in, &e.dq_out}) *q *= Q;
  const auto other = fit_vessel(e, {}, {}).parameters;
  expect_same({other.R * Q / P, other.C * P / Q, other.L * Q / P, other.S * Q * Q / P}, si, 1e-6);
}

/// A steady flow shows neither compliance nor inertance, and one number of resistance and stenosis.
TEST(VesselFit, WhatTheDataDoNotSeeStays) {
  EndsOfVessel e;
  e.q_in = e.q_out = Eigen::VectorXd::Constant(n, 5), e.dq_in = e.dq_out = e.dp_in = Eigen::VectorXd::Zero(n);
  e.p_in = Eigen::VectorXd::Constant(n, 1100), e.p_out = Eigen::VectorXd::Constant(n, 600);
  const auto kept = fit_vessel(e, {100, 1e-4, 1, 0}, {});
  EXPECT_NEAR(kept.parameters.R, 100, 1e-10);
  EXPECT_NEAR(kept.parameters.S, 0, 1e-10);
  EXPECT_EQ(kept.parameters.C, 1e-4);
  EXPECT_EQ(kept.parameters.L, 1);
  EXPECT_EQ(kept.undetermined, 3);
  const auto found = fit_vessel(e, {}, {.stenosis = false}).parameters;
  EXPECT_NEAR(found.R, 100, 1e-10);
}

TEST(VesselFit, BoundsAndWhatIsLeftOut) {
  auto e = ends_of({2e7, 3e-10, 4e5, 0}, true);
  std::swap(e.q_in, e.q_out);  // stores blood where the pressure falls
  EXPECT_EQ(fit_vessel(e, {}, {}).parameters.C, 0);
  const auto none = fit_vessel(ends_of({2e7, 0, 4e5, 0}, true), {}, {.stenosis = false, .compliance = false});
  expect_same(none.parameters, {2e7, 0, 4e5, 0}, 1e-10);
}

}  // namespace
}  // namespace ostium::network
