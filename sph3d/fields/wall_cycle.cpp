#include "sph3d/fields/wall_cycle.hpp"

#include <cmath>

#include "core/error.hpp"

namespace ostium::sph3d {

template <int D>
double CycleFields<D>::osi(std::size_t a) const {
  return tawss[a] > 0.0 ? 0.5 * (1.0 - mean_stress[a].norm() / tawss[a]) : 0.0;
}

template <int D>
double CycleFields<D>::rrt(std::size_t a) const {
  const double mean = mean_stress[a].norm();
  return mean > 0.0 ? 1.0 / mean : 0.0;
}

template <int D>
CycleFields<D> fields_of(const WallCycle<D>& cycle) {
  CycleFields<D> fields{.number = cycle.number,
                        .duration = cycle.duration,
                        .mean_stress = cycle.stress_sum,
                        .tawss = cycle.magnitude_sum,
                        .mean_pressure = cycle.pressure_sum};
  const double T = std::max(cycle.duration, 1e-300);
  for (auto& stress : fields.mean_stress) stress /= T;
  for (auto& magnitude : fields.tawss) magnitude /= T;
  for (auto& pressure : fields.mean_pressure) pressure /= T;
  return fields;
}

namespace {

template <int D>
void begin_sums(WallCycle<D>& cycle, std::size_t points) {
  cycle.duration = 0;
  cycle.stress_sum.assign(points, Vec<D>::Zero());
  cycle.magnitude_sum.assign(points, 0.0);
  cycle.pressure_sum.assign(points, 0.0);
}

/// Adds a trapezoid between the last sample and the new one: from `share` 0 to 1 of the way.
template <int D>
void add_piece(WallCycle<D>& cycle, const std::vector<Vec<D>>& stress, const std::vector<double>& pressure,
               double dt, double from, double to) {
  const double half = 0.5 * (to - from) * dt;
  cycle.duration += (to - from) * dt;
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < stress.size(); ++a) {
    const Vec<D> begin = cycle.stress[a] + from * (stress[a] - cycle.stress[a]),
                 end = cycle.stress[a] + to * (stress[a] - cycle.stress[a]);
    cycle.stress_sum[a] += half * (begin + end);
    cycle.magnitude_sum[a] += half * (begin.norm() + end.norm());
    cycle.pressure_sum[a] +=
        half * (2.0 * cycle.pressure[a] + (from + to) * (pressure[a] - cycle.pressure[a]));
  }
}

}  // namespace

namespace {
std::int64_t number_at(double time, double period) {
  return period > 0.0 ? static_cast<std::int64_t>(std::floor(time / period + 1e-9)) : 0;
}
}  // namespace

template <int D>
bool ends(const WallCycle<D>& cycle, double time, double period) {
  return !cycle.stress.empty() && number_at(time, period) != cycle.number;
}

template <int D>
CycleFields<D> take(WallCycle<D>& cycle, double time, const std::vector<Vec<D>>& sampled,
                    const std::vector<double>& pressure, double period, double filter) {
  CycleFields<D> ended;
  ended.number = -1;
  if (cycle.stress.empty()) {
    cycle.stress = sampled, cycle.pressure = pressure, cycle.time = time;
    cycle.number = number_at(time, period);
    begin_sums(cycle, sampled.size());
    return ended;
  }
  OSTIUM_ASSERT(cycle.stress.size() == sampled.size(), "{} wall points, {} before", sampled.size(),
                cycle.stress.size());
  const double dt = time - cycle.time, share = filter > 0.0 ? 1.0 - std::exp(-dt / filter) : 1.0;
  std::vector<Vec<D>> stress(sampled.size());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < sampled.size(); ++a)
    stress[a] = cycle.stress[a] + share * (sampled[a] - cycle.stress[a]);
  double done = 0;
  if (ends(cycle, time, period)) {
    done = std::min(1.0, (static_cast<double>(cycle.number + 1) * period - cycle.time) / dt);
    add_piece(cycle, stress, pressure, dt, 0.0, done);
    ended = fields_of(cycle);
    begin_sums(cycle, sampled.size());
    cycle.number = number_at(time, period);
  }
  if (done < 1.0) add_piece(cycle, stress, pressure, dt, done, 1.0);
  cycle.stress = std::move(stress), cycle.pressure = pressure, cycle.time = time;
  return ended;
}

template <int D>
void archive(Archive& a, WallCycle<D>& cycle) {
  a("number", cycle.number);
  a("time", cycle.time);
  a("duration", cycle.duration);
  a.template records<double>("stress", cycle.stress);
  a("pressure", cycle.pressure);
  a.template records<double>("stress_sum", cycle.stress_sum);
  a("magnitude_sum", cycle.magnitude_sum);
  a("pressure_sum", cycle.pressure_sum);
}

#define OSTIUM_INSTANTIATE(D)                                                     \
  template struct CycleFields<D>;                                                 \
  template CycleFields<D> fields_of(const WallCycle<D>&);                         \
  template bool ends(const WallCycle<D>&, double, double);                        \
  template CycleFields<D> take(WallCycle<D>&, double, const std::vector<Vec<D>>&, \
                               const std::vector<double>&, double, double);       \
  template void archive(Archive&, WallCycle<D>&);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
