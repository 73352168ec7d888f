#include "sph3d/shell/step.hpp"

#include <cmath>

#include "core/error.hpp"

namespace ostium::sph3d {

namespace {

template <int D>
ShellArrays<D> arrays(const ShellModel<D>& model, ShellState<D>& state, const std::vector<ShellLoad<D>>& load,
                      ShellWorkspace<D>& work) {
  OSTIUM_ASSERT(load.size() == model.blocks() && state.blocks.size() == model.blocks(),
                "blocks: {}, loads: {}, state: {}", model.blocks(), load.size(), state.blocks.size());
  const auto& held = model.prestress.blocks;
  OSTIUM_ASSERT(held.empty() || held.size() == model.blocks(), "blocks: {}, prestress: {}", model.blocks(),
                held.size());
  return {
      model.reference.data(), model.rows(),       load.data(),       state.blocks.data(),
      work.motion.data(),     work.stress.data(), work.force.data(), held.empty() ? nullptr : held.data()};
}

/// f(begin, end) for the part of the blocks that belongs to each thread of the team, then all wait.
template <class F>
void for_blocks(std::int64_t n, F f) {
#pragma omp for schedule(static)
  for (std::int64_t i = 0; i < n; ++i) f(i, i + 1);
}

template <int D>
void check(const ShellModel<D>& model, const ShellState<D>& state) {
  for (std::size_t a = 0; a < model.count(); ++a)
    if (!std::isfinite(state.displacement(a).sum() + state.normal(a).sum())) {
      const Vec<D> x = model.cloud.position[a];
      numerics_error(
          "the wall moved beyond all bounds at ({:.4g}, {:.4g}{}) m, time {:.6g} s; its time step may be too "
          "long",
          x[0], x[1], D == 3 ? fmt::format(", {:.4g}", x[D - 1]) : "", state.time);
    }
}

}  // namespace

template <int D>
void advance(const ShellModel<D>& model, ShellState<D>& state, const std::vector<ShellLoad<D>>& load,
             ShellWorkspace<D>& work, const ShellSteps& steps) {
  const ShellArrays<D> s = arrays(model, state, load, work);
  const ShellKernels<D>& kernels = shell_kernels<D>();
  const auto n = std::int64_t(model.blocks());
  const double dt = steps.dt, since = state.time + 0.5 * dt - state.strain_time,
               slow = 0.5 * dt * steps.mass_damping;
#pragma omp parallel
  {
    ShellConstants c{.gauss_points = model.options.gauss_points,
                     .per_time = since > 0.0 ? 1.0 / since : 0.0,
                     .kick = dt,
                     .drift = 0.5 * dt,
                     .keep = 1.0 - slow,
                     .weight = 1.0 + slow};
    for_blocks(n, [&](std::int64_t i, std::int64_t end) { kernels.drift(i, end, s, c); });
    for (int k = 0; k < steps.count; ++k) {
      for_blocks(
          n, [&](std::int64_t i, std::int64_t end) { kernels.stress(i, end, s, model.options.material, c); });
      c.per_time = 1.0 / dt;
      c.drift = k + 1 < steps.count ? dt : 0.5 * dt;
      for_blocks(n, [&](std::int64_t i, std::int64_t end) { kernels.kick(i, end, s, c); });
    }
  }
  state.time += steps.count * dt;
  state.strain_time = state.time - 0.5 * dt;
  check(model, state);
}

template <int D>
void accelerate(const ShellModel<D>& model, ShellState<D>& state, const std::vector<ShellLoad<D>>& load,
                ShellWorkspace<D>& work) {
  const ShellArrays<D> s = arrays(model, state, load, work);
  const ShellKernels<D>& kernels = shell_kernels<D>();
  const ShellConstants still{.gauss_points = model.options.gauss_points};
  const auto n = std::int64_t(model.blocks());
  kernels.drift(0, n, s, still);
  kernels.stress(0, n, s, model.options.material, still);
  kernels.kick(0, n, s, still);
}

template <int D>
Vec<D> ShellWorkspace<D>::acceleration(std::size_t a) const {
  Vec<D> x;
  for (int d = 0; d < D; ++d) x[d] = force[a / 8].force[d][a % 8];
  return x;
}

template struct ShellWorkspace<2>;
template struct ShellWorkspace<3>;
template void advance(const ShellModel<2>&, ShellState<2>&, const std::vector<ShellLoad<2>>&,
                      ShellWorkspace<2>&, const ShellSteps&);
template void advance(const ShellModel<3>&, ShellState<3>&, const std::vector<ShellLoad<3>>&,
                      ShellWorkspace<3>&, const ShellSteps&);
template void accelerate(const ShellModel<2>&, ShellState<2>&, const std::vector<ShellLoad<2>>&,
                         ShellWorkspace<2>&);
template void accelerate(const ShellModel<3>&, ShellState<3>&, const std::vector<ShellLoad<3>>&,
                         ShellWorkspace<3>&);

}  // namespace ostium::sph3d
