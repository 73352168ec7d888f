#include "sph3d/fields/stress_agreement.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::sph3d {

namespace {

constexpr double tolerance = 0.1, least_scale = 0.25;

void archive(Archive& a, StressSums& sums) {
  a("count", sums.count);
  a("forces", sums.forces);
  a("gradient", sums.gradient);
}

template <int D>
void add(StressSums& sums, const std::vector<Vec<D>>& forces, const std::vector<Vec<D>>& gradient) {
  sums.forces.resize(forces.size()), sums.gradient.resize(forces.size());
  for (std::size_t a = 0; a < forces.size(); ++a)
    sums.forces[a] += forces[a].norm(), sums.gradient[a] += gradient[a].norm();
  ++sums.count;
}

}  // namespace

void archive(Archive& a, StressAgreement& agreement) {
  a("cycle", agreement.cycle);
  a("time", agreement.time);
  a.part("running", [&] { archive(a, agreement.running); });
  a.part("whole", [&] { archive(a, agreement.whole); });
}

template <int D>
void take(StressAgreement& agreement, std::int64_t cycle, double time, const std::vector<Vec<D>>& forces,
          const std::vector<Vec<D>>& gradient) {
  if (cycle != agreement.cycle) {
    agreement.whole = std::move(agreement.running);
    agreement.running = {};
    agreement.cycle = cycle;
  }
  add<D>(agreement.running, forces, gradient);
  agreement.time = time;
}

template <int D>
Disagreement disagreement(const StressSums& sums, const std::vector<WallPoint<D>>& wall) {
  Disagreement report;
  if (sums.count == 0) return report;
  double area = 0, mean = 0, beyond = 0, half = 0, most = -1;
  for (std::size_t a = 0; a < wall.size(); ++a) area += wall[a].area, mean += wall[a].area * sums.forces[a];
  mean /= area;
  std::vector<std::pair<double, double>> d;  // and area
  for (std::size_t a = 0; a < wall.size(); ++a) {
    const double F = sums.forces[a], g = sums.gradient[a], scale = std::max({F, g, least_scale * mean});
    d.emplace_back(scale > 0.0 ? std::abs(F - g) / scale : 0.0, wall[a].area);
    if (d.back().first > tolerance) beyond += wall[a].area;
    if (d.back().first > most) most = d.back().first, report.worst = a;
  }
  report.share = beyond / area;
  report.forces = sums.forces[report.worst] / double(sums.count);
  report.gradient = sums.gradient[report.worst] / double(sums.count);
  std::sort(d.begin(), d.end());
  for (const auto& [value, piece] : d) {
    report.median = value;
    if ((half += piece) >= 0.5 * area) break;
  }
  return report;
}

template void take(StressAgreement&, std::int64_t, double, const std::vector<Vec2>&,
                   const std::vector<Vec2>&);
template void take(StressAgreement&, std::int64_t, double, const std::vector<Vec3>&,
                   const std::vector<Vec3>&);
template Disagreement disagreement(const StressSums&, const std::vector<WallPoint<2>>&);
template Disagreement disagreement(const StressSums&, const std::vector<WallPoint<3>>&);

}  // namespace ostium::sph3d
