/// Elastic bodies for tests: boxes and rings of particles, and how they come to rest.
#pragma once
#include <cmath>
#include <functional>
#include <random>

#include "sph3d/neighbours/order.hpp"
#include "sph3d/solid/solid_report.hpp"
#include "sph3d/solid/solid_step.hpp"

namespace ostium::sph3d::bodies {

/// In the order of memory that the kernels like.
template <int D>
SolidCloud<D> ordered(const SolidCloud<D>& cloud) {
  SolidCloud<D> out;
  for (const auto k : bisection_order<D>(cloud.position)) {
    out.position.push_back(cloud.position[k]), out.volume.push_back(cloud.volume[k]);
    if (!cloud.held.empty()) out.held.push_back(cloud.held[k]);
  }
  return out;
}

/// A square or cubic lattice that fills the box from `lower` to `upper`, the outer particles half a spacing inside, shaken by
/// so much of the spacing.
template <int D>
SolidCloud<D> box(const Vec<D>& lower, const Vec<D>& upper, double dp, double shake = 0.0) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-shake * dp, shake * dp);
  SolidCloud<D> cloud;
  const auto along = [&](int d) { return static_cast<int>(std::lround((upper[d] - lower[d]) / dp)); };
  int total = 1;
  for (int d = 0; d < D; ++d) total *= along(d);
  for (int k = 0; k < total; ++k) {
    Vec<D> x;
    for (int d = 0, rest = k; d < D; rest /= along(d), ++d)
      x[d] = lower[d] + (rest % along(d) + 0.5) * dp + (shake > 0.0 ? any(random) : 0.0);
    cloud.position.push_back(x), cloud.volume.push_back(std::pow(dp, D));
  }
  return ordered(cloud);
}

/// Holds all components where `where` says so.
template <int D>
void hold(SolidCloud<D>& cloud, const std::function<bool(const Vec<D>&)>& where) {
  cloud.held.assign(cloud.count(), 0);
  for (std::size_t a = 0; a < cloud.count(); ++a)
    if (where(cloud.position[a])) cloud.held[a] = hold_all;
}

/// A force spread over the particles that `where` picks, by volume.
template <int D>
std::vector<Vec<D>> spread(const SolidCloud<D>& cloud, const Vec<D>& force,
                           const std::function<bool(const Vec<D>&)>& where) {
  std::vector<Vec<D>> out(cloud.count(), Vec<D>::Zero());
  double volume = 0.0;
  for (std::size_t a = 0; a < cloud.count(); ++a) volume += where(cloud.position[a]) ? cloud.volume[a] : 0.0;
  for (std::size_t a = 0; a < cloud.count(); ++a)
    if (where(cloud.position[a])) out[a] = force * cloud.volume[a] / volume;
  return out;
}

/// Mean displacement of the particles that `where` picks.
template <int D>
Vec<D> mean_displacement(const SolidModel<D>& m, const SolidState<D>& state,
                         const std::function<bool(const Vec<D>&)>& where) {
  Vec<D> sum = Vec<D>::Zero();
  double volume = 0.0;
  for (std::size_t a = 0; a < m.count(); ++a)
    if (where(m.cloud.position[a]))
      sum += m.cloud.volume[a] * state.displacement[a], volume += m.cloud.volume[a];
  return sum / volume;
}

/// Drags the body to rest: near the critical damping of a mode of angular frequency `omega`, for so many of its periods.
template <int D>
SolidState<D> settled(const SolidModel<D>& m, SolidLoads<D> loads, double omega, double periods = 4.0,
                      double courant = 0.6) {
  auto state = at_rest(m);
  SolidWorkspace<D> work;
  loads.mass_damping = 1.4 * omega;
  while (state.time < periods * 2.0 * pi / omega)
    advance(m, state, loads, stable_step(m, state, work, courant), work);
  return state;
}

}  // namespace ostium::sph3d::bodies
