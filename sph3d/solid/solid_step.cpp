#include "sph3d/solid/solid_step.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "sph3d/solid/solid_kernels.hpp"

namespace ostium::sph3d {

namespace {

template <int D>
void resize(const SolidModel<D>& m, SolidWorkspace<D>& work) {
  const std::size_t n = SolidModel<D>::lanes * m.groups();
  work.displacement.resize(padded<D> * n, 0.0);
  work.stress.resize(D * padded<D> * n, 0.0);
  work.force.resize(padded<D> * n, 0.0);
  work.load.resize(m.count());
}

/// The strain is taken at the middle of each step: between two of them the particles moved with one velocity, so that the
/// change of strain over that time is the exact rate.
template <int D>
SolidPass<D> pass_of(const SolidModel<D>& m, SolidState<D>& state, SolidWorkspace<D>& work, double dt) {
  const double between = 0.5 * (state.last_step + dt);
  return {.row = m.row.data(),
          .neighbour = m.neighbour.data(),
          .weight = m.weight.data(),
          .correction = m.correction.data(),
          .factor = m.factor.data(),
          .fibre = m.fibre.data(),
          .count = m.count(),
          .hourglass = m.options.hourglass * moduli(m.options.material).mu(),
          .per_time = state.last_step > 0.0 ? m.viscosity / between : 0.0,
          .strain = state.strain.data(),
          .displacement = work.displacement.data(),
          .stress = work.stress.data(),
          .force = work.force.data()};
}

/// A force f on the surface above a particle does its work on u_a + H_a (X_surface - X_a): shares of the particle and its
/// neighbours.
template <int D>
void carry(const SolidModel<D>& m, std::size_t a, const Vec<D>& f, const Vec<D>& to_surface,
           std::vector<Vec<D>>& load) {
  const Vec<D> arm = m.correction_of(a) * to_surface;
  load[a] += f;
  for (auto k = m.row[a]; k < m.row[a + 1]; ++k) {
    const Vec<D> share = pair_gradient(m, k).dot(arm) * f;
    load[m.neighbour[k]] += share, load[a] -= share;
  }
}

template <int D>
void press(const SolidModel<D>& m, const SolidState<D>& state, const PressurePatch<D>& patch,
           std::vector<Vec<D>>& load) {
  if (patch.pressure == 0.0) return;
  for (std::size_t k = 0; k < patch.particle.size(); ++k) {
    const std::int32_t a = patch.particle[k];
    const Mat<D> F = deformation_gradient(m, state.displacement, a);
    const Vec<D> area = F.determinant() * F.inverse().transpose() * patch.area[k];
    carry<D>(m, a, -patch.pressure * area, patch.depth * patch.area[k].normalized(), load);
  }
}

template <int D>
void gather_loads(const SolidModel<D>& m, const SolidState<D>& state, const SolidLoads<D>& loads,
                  std::vector<Vec<D>>& load) {
  OSTIUM_ASSERT(loads.force.empty() || loads.force.size() == m.count(), "{} forces on {} particles",
                loads.force.size(), m.count());
  if (loads.force.empty())
    load.assign(m.count(), Vec<D>::Zero());
  else
    load = loads.force;
  for (const auto& patch : loads.patches) press(m, state, patch, load);
  for (const auto& traction : loads.tractions)
    for (std::size_t k = 0; k < traction.particle.size(); ++k)
      carry<D>(m, traction.particle[k], traction.force[k], traction.to_surface[k], load);
}

template <int D>
void drift(SolidState<D>& state, SolidWorkspace<D>& work, double dt, std::size_t begin, std::size_t end) {
  for (std::size_t a = begin; a < end; ++a) {
    state.displacement[a] += dt * state.velocity[a];
    for (int d = 0; d < D; ++d) work.displacement[padded<D> * a + d] = state.displacement[a][d];
  }
}

template <int D>
void kick(const SolidModel<D>& m, SolidState<D>& state, const SolidWorkspace<D>& work, double dt, double drag,
          std::size_t a) {
  const unsigned held = m.cloud.held.empty() ? 0u : m.cloud.held[a];
  const double keep = (1.0 - 0.5 * drag * dt) / (1.0 + 0.5 * drag * dt), push = dt / (1.0 + 0.5 * drag * dt);
  for (int d = 0; d < D; ++d) {
    if (held >> d & 1u) continue;
    const double acceleration =
        work.force[padded<D> * a + d] / m.options.density + work.load[a][d] / m.mass(a);
    state.velocity[a][d] = keep * state.velocity[a][d] + push * acceleration;
  }
}

template <int D>
void check_finite(const SolidModel<D>& m, const SolidState<D>& state) {
  for (std::size_t a = 0; a < m.count(); ++a)
    if (!(state.velocity[a].squaredNorm() < 1e300)) {
      const Vec<D>& x = m.cloud.position[a];
      numerics_error("The solid's particle at ({:g}, {:g}, {:g}) m has no finite velocity at {:g} s.", x[0],
                     x[1], D == 3 ? x[D - 1] : 0.0, state.time);
    }
}

/// f(begin, end) over batches of so many of n, statically shared among the threads of a region.
template <class F>
void batches(std::size_t n, std::size_t size, F&& f) {
#pragma omp for schedule(static)
  for (std::size_t begin = 0; begin < n; begin += size) f(begin, std::min(begin + size, n));
}

/// The viscous force lags by half a step: of a mode of frequency 2/dt at the elastic limit dt (about 0.7 h/c) it lowers the limit to
/// sqrt(1 + x^2) - x of it, x the mode's damping ratio.
double viscous_share(double viscosity_ratio) {
  const double x = viscosity_ratio / 0.7;
  return std::sqrt(1.0 + x * x) - x;
}

}  // namespace

template <int D>
void advance(const SolidModel<D>& m, SolidState<D>& state, const SolidLoads<D>& loads, double dt,
             SolidWorkspace<D>& work) {
  resize(m, work);
  const auto& kernels = solid_kernels<D>();
  const SolidPass<D> pass = pass_of(m, state, work, dt);
#pragma omp parallel
  {
    batches(m.count(), 256, [&](auto begin, auto end) { drift(state, work, 0.5 * dt, begin, end); });
#pragma omp single
    gather_loads(m, state, loads, work.load);
    batches(m.groups(), 16,
            [&](auto begin, auto end) { kernels.stresses(begin, end, pass, m.options.material); });
    batches(m.count(), 64, [&](auto begin, auto end) {
      kernels.forces(begin, end, pass);
      for (auto a = begin; a < end; ++a) {
        kick(m, state, work, dt, loads.mass_damping, a);
        state.displacement[a] += 0.5 * dt * state.velocity[a];
      }
    });
  }
  state.time += dt, state.last_step = dt;
  check_finite(m, state);
}

template <int D>
double stable_step(const SolidModel<D>& m, const SolidState<D>& state, const SolidWorkspace<D>& work,
                   double courant) {
  double v2 = 0.0, a2 = 0.0, stiffest = 1.0;
  for (std::size_t a = 0; a < m.count(); ++a) {
    v2 = std::max(v2, state.velocity[a].squaredNorm());
    stiffest = std::max(stiffest, m.stiffness_of(a));
    if (work.load.empty()) continue;
    const Vec<D> force = Eigen::Map<const Vec<D>>(&work.force[padded<D> * a]);
    a2 = std::max(a2, (force / m.options.density + work.load[a] / m.mass(a)).squaredNorm());
  }
  const double c = wave_speed(stiffest * moduli(m.options.material).p_wave(), m.options.density);
  const double share = viscous_share(m.viscosity / (m.options.density * c * m.kernel.h));
  return courant * std::min(share * m.kernel.h / (c + std::sqrt(v2)), std::sqrt(m.kernel.h / std::sqrt(a2)));
}

template <int D>
Mat<D> deformation_gradient(const SolidModel<D>& m, const std::vector<Vec<D>>& u, std::size_t a) {
  Mat<D> sum = Mat<D>::Zero();
  for (auto k = m.row[a]; k < m.row[a + 1]; ++k)
    sum += (u[m.neighbour[k]] - u[a]) * pair_gradient(m, k).transpose();
  return Mat<D>::Identity() + sum * m.correction_of(a);
}

#define OSTIUM_INSTANTIATE(D)                                                                                \
  template void advance(const SolidModel<D>&, SolidState<D>&, const SolidLoads<D>&, double,                  \
                        SolidWorkspace<D>&);                                                                 \
  template double stable_step(const SolidModel<D>&, const SolidState<D>&, const SolidWorkspace<D>&, double); \
  template Mat<D> deformation_gradient(const SolidModel<D>&, const std::vector<Vec<D>>&, std::size_t);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
