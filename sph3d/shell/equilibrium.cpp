#include "sph3d/shell/equilibrium.hpp"

#include <cmath>

#include "core/error.hpp"
#include "sph3d/shell/stable_step.hpp"

namespace ostium::sph3d {

namespace {

/// Sums over the change between two moments.
struct Change {
  double work = 0, inertia = 0;  // -sum dF.dx, sum m dx.dx
  double largest = 0, displacement = 0;

  double frequency() const { return inertia > 0.0 ? std::sqrt(std::max(work / inertia, 0.0)) : 0.0; }
};

template <int D>
double dot(const double (&a)[D][8], const double (&b)[D][8], const double (&c)[D][8], const double (&d)[D][8],
           std::size_t lane) {
  double sum = 0.0;
  for (int k = 0; k < D; ++k) sum += (a[k][lane] - b[k][lane]) * (c[k][lane] - d[k][lane]);
  return sum;
}

template <int D>
Change change(const ShellModel<D>& model, const std::vector<ShellBlock<D>>& now,
              const std::vector<ShellBlock<D>>& before, const std::vector<ShellForce<D>>& force,
              const std::vector<ShellForce<D>>& last) {
  Change sum;
  const double none[D][8] = {};
  for (std::size_t a = 0; a < model.count(); ++a) {
    const std::size_t i = a / 8, lane = a % 8;
    const double m = model.mass(a), rotary = m * model.gyration2(a);
    const double moved2 = dot<D>(now[i].u, before[i].u, now[i].u, before[i].u, lane);
    sum.work -= m * dot<D>(force[i].force, last[i].force, now[i].u, before[i].u, lane) +
                rotary * dot<D>(force[i].moment, last[i].moment, now[i].n, before[i].n, lane);
    sum.inertia += m * moved2 + rotary * dot<D>(now[i].n, before[i].n, now[i].n, before[i].n, lane);
    sum.largest = std::max(sum.largest, moved2);
    sum.displacement = std::max(sum.displacement, dot<D>(now[i].u, none, now[i].u, none, lane));
  }
  sum.largest = std::sqrt(sum.largest), sum.displacement = std::sqrt(sum.displacement);
  return sum;
}

template <int D>
void stop(ShellState<D>& state) {
  for (auto& block : state.blocks)
    for (int d = 0; d < D; ++d)
      for (int lane = 0; lane < 8; ++lane) block.v[d][lane] = block.w[d][lane] = 0.0;
}

}  // namespace

/// What the motion of this round may still come to: if it goes on to decay as it did, and within 1/omega.
double left_over(const Change& now, double inertia_before, double rounds_per_omega) {
  const double decay = std::sqrt(now.inertia / std::max(inertia_before, 1e-300));
  return now.largest * std::max(rounds_per_omega, 1.0 / std::max(1.0 - decay, 1e-6));
}

template <int D>
EquilibriumReport find_equilibrium(const ShellModel<D>& model, ShellState<D>& state,
                                   const std::vector<ShellLoad<D>>& load, const EquilibriumOptions& options) {
  ShellWorkspace<D> work(model);
  EquilibriumReport report;
  const double dt = stable_step(model), round = options.check_every * dt;
  double inertia = 0.0;
  while (report.steps < options.most_steps) {
    const auto before = state.blocks;
    const auto last = work.force;
    advance(model, state, load, work, {dt, options.check_every, 2.0 * report.frequency});
    report.steps += options.check_every;
    if (report.steps == options.check_every) continue;
    const Change moved = change(model, state.blocks, before, work.force, last);
    report.frequency = std::min(moved.frequency(), 0.5 / dt);
    const double left = left_over(moved, inertia, 1.0 / (round * std::max(report.frequency, 1e-12 / dt)));
    report.residual = left / std::max(moved.displacement, 1e-300);
    inertia = moved.inertia;
    if (report.residual < options.tolerance) {
      stop(state);
      return report;
    }
  }
  numerics_error(
      "the wall found no equilibrium within {} steps; what is left of the motion is {:.3g} of the "
      "displacement",
      report.steps, report.residual);
}

template EquilibriumReport find_equilibrium(const ShellModel<2>&, ShellState<2>&,
                                            const std::vector<ShellLoad<2>>&, const EquilibriumOptions&);
template EquilibriumReport find_equilibrium(const ShellModel<3>&, ShellState<3>&,
                                            const std::vector<ShellLoad<3>>&, const EquilibriumOptions&);

}  // namespace ostium::sph3d
