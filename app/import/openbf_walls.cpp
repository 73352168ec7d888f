#include "app/import/openbf_walls.hpp"

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <numbers>

namespace ostium::app::openbf {
namespace {

constexpr double pi = std::numbers::pi;

struct Section {
  double A0, beta, A;
};

Section section(const VesselData& v, double pressure, double x) {
  const double r = v.begin_radius() + x * (v.end_radius() - v.begin_radius());
  const double h = v.h0 ? *v.h0 : r * (0.2802 * std::exp(-505.3 * r) + 0.1324 * std::exp(-11.14 * r));
  const double A0 = pi * r * r, beta = v.E * h / (r * 0.75), root = 1 + (pressure - v.Pext) / beta;
  if (root <= 0)
    v.origin.error(
        "the vessel \"{}\" collapses: its mean pressure would be {:.4g} Pa, and below {:.4g} Pa nothing is "
        "left "
        "of its lumen; check the inflow and the outlets",
        v.label, pressure, v.Pext - beta);
  return {A0, beta, A0 * root * root};
}

double mean_inflow(const Source& s) {
  double sum = 0;
  for (std::size_t i = 1; i < s.times.size(); ++i)
    sum += (s.times[i] - s.times[i - 1]) * (s.flow[i] + s.flow[i - 1]) / 2;
  return sum / s.period();
}

/// One linear solution with the resistances at the given pressures.
Steady solve(const Source& s, const std::vector<double>& pressure) {
  std::map<int, int> index;
  for (const auto& v : s.vessels)
    for (const int node : {v.sn, v.tn}) index.emplace(node, static_cast<int>(index.size()));
  const auto n = static_cast<Eigen::Index>(index.size());
  Eigen::MatrixXd G = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(n);
  q[index[s.inlet]] = mean_inflow(s);
  std::vector<double> R;
  for (std::size_t i = 0; i < s.vessels.size(); ++i) {
    const auto& v = s.vessels[i];
    const int a = index[v.sn], b = index[v.tn];
    R.push_back(lumped(v, s.blood, pressure[i], 0, 1).R);
    G(a, a) += 1 / R[i], G(b, b) += 1 / R[i], G(a, b) -= 1 / R[i], G(b, a) -= 1 / R[i];
    if (!v.R1 && !v.Rt) continue;
    const Outlet o = outlet(v, s.blood, pressure[i]);
    G(b, b) += 1 / (o.R1 + o.R2), q[b] += o.ground / (o.R1 + o.R2);
  }
  const Eigen::VectorXd p = G.fullPivLu().solve(q);
  Steady made;
  for (std::size_t i = 0; i < s.vessels.size(); ++i) {
    const double a = p[index[s.vessels[i].sn]], b = p[index[s.vessels[i].tn]];
    made.pressure.push_back((a + b) / 2), made.flow.push_back((a - b) / R[i]), made.end.push_back(b);
  }
  return made;
}

}  // namespace

Lumped lumped(const VesselData& v, const BloodData& blood, double pressure, double a, double b) {
  constexpr int n = 16;
  Lumped sum;
  for (int k = 0; k <= n; ++k) {
    const double weight = (k == 0 || k == n ? 1 : k % 2 ? 4 : 2) * (b - a) * v.L / (3 * n);
    const auto [A0, beta, A] = section(v, pressure, a + (b - a) * k / n);
    sum.R += weight * 2 * (v.gamma_profile + 2) * pi * blood.mu / (A * A);
    sum.L += weight * blood.rho / A;
    sum.C += weight * 2 * std::sqrt(A * A0) / beta;
  }
  return sum;
}

double wave_impedance(const VesselData& v, const BloodData& blood, double pressure) {
  const auto [A0, beta, A] = section(v, pressure, 1);
  return std::sqrt(blood.rho * beta / (2 * std::sqrt(A * A0))) / std::sqrt(A);
}

Outlet outlet(const VesselData& v, const BloodData& blood, double pressure) {
  const double Z = wave_impedance(v, blood, pressure);
  if (v.Rt) {
    constexpr double closed = 1e6;  // times the wave impedance
    return {.R1 = Z * (*v.Rt < 1 ? (1 + *v.Rt) / (1 - *v.Rt) : closed), .R2 = 0, .Cc = 0, .ground = v.Pext};
  }
  const bool matched = v.impedance_matching || v.R2.value_or(0) == 0;
  const double all = *v.R1 + v.R2.value_or(0);
  if (!matched) return {.R1 = *v.R1, .R2 = *v.R2, .Cc = *v.Cc};
  if (all <= Z)
    v.origin.error(
        "the outlet of \"{}\" has {:.4g} Pa.s/m3 in all, less than the {:.4g} Pa.s/m3 of the vessel's wave "
        "impedance that goes in front; give R1 and R2, without impedance matching",
        v.label, all, Z);
  return {.R1 = Z, .R2 = all - Z, .Cc = *v.Cc};
}

Steady steady_state(const Source& source) {
  std::vector<double> pressure;
  for (const auto& v : source.vessels) pressure.push_back(v.Pext);
  Steady made = solve(source, pressure);
  for (int round = 0; round < 100; ++round) {
    double change = 0;
    for (std::size_t i = 0; i < pressure.size(); ++i) {
      const double next = 0.5 * (pressure[i] + made.pressure[i]);
      change = std::max(change, std::abs(next - pressure[i])), pressure[i] = next;
    }
    made = solve(source, pressure);
    if (change < 1e-6) return made;  // Pa
  }
  source.vessels.front().origin.error(
      "the steady state of \"{}\" was not found in 100 rounds; check the inflow and the outlets",
      source.name);
}

}  // namespace ostium::app::openbf
