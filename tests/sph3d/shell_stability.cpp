// The stable step is one: shells shaken at random keep their energy at it, and lose it well above.
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "shell_clouds.hpp"
#include "sph3d/shell/prestress.hpp"
#include "sph3d/shell/recover.hpp"
#include "sph3d/shell/stable_step.hpp"

namespace ostium::sph3d {
namespace {

template <int D>
double kinetic(const ShellModel<D>& model, const ShellState<D>& state) {
  const auto e = energies(model, state);
  return e.motion + e.rotation;
}

/// Growth of small random motion in 400 steps of `factor` times the bound, by its kinetic energy; under a pressure that the
/// wall carries in its reference.
template <int D>
double growth(const ShellCloud<D>& cloud, ShellOptions options, double factor, double pressure = 0) {
  options.cfl = 1.0;
  ShellModel<D> model(cloud, options);
  const auto load = pressure_load(model, pressure);
  find_prestress(model, load);
  auto state = rest(model);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> value(-1e-6, 1e-6);
  for (std::size_t a = 0; a < model.count(); ++a) {
    Vec<D> v, w;
    for (int d = 0; d < D; ++d) v[d] = value(random), w[d] = value(random) / options.spacing;
    state.velocity(a, v);
    state.normal_rate(a, w - w.dot(model.cloud.normal[a]) * model.cloud.normal[a]);
  }
  const double before = kinetic(model, state);
  ShellWorkspace<D> work(model);
  for (int k = 0; k < 40; ++k) {
    try {
      advance(model, state, load, work, {factor * stable_step(model), 10});
    } catch (const NumericsError&) {
      return 1e30;
    }
    const double now = kinetic(model, state);
    if (now > 10 * before) return now / before;
  }
  return kinetic(model, state) / before;
}

// Without damping the bound itself is safe; with the default damping the default share of it, 0.6. Twice the bound is not.
TEST(ShellStability, BoundHolds) {
  for (const double thick : {0.02, 0.1, 0.3})
    for (const double nu : {0.0, 0.49})
      for (const bool scaled : {false, true})
        for (const double damping : {0.0, 0.5}) {
          const ShellOptions o{.spacing = 0.1,
                               .material = SaintVenantKirchhoff(elastic(1e6, nu)),
                               .damping = damping,
                               .rotary_scaling = scaled};
          const double safe = damping > 0.0 ? 0.6 : 0.95;
          EXPECT_LT(growth<2>(strip(30, 0.1, thick, 0, 0), o, safe), 3.0)
              << thick << " " << nu << scaled << damping;
          EXPECT_LT(growth<3>(free_plate(9, 9, 0.1, thick, 0.2), o, safe), 3.0)
              << thick << " " << nu << scaled << damping;
          EXPECT_GT(growth<2>(strip(30, 0.1, thick, 0, 0), o, 2.0), 10.0)
              << thick << " " << nu << scaled << damping;
        }
}

// A wall in tension is a stiffer wall: hoop stress as large as the modulus, in a ring and in a tube.
TEST(ShellStability, BoundHoldsUnderTension) {
  const double R = 1.0, E = 1e6;
  for (const double thick : {0.02, 0.3})
    for (const bool scaled : {false, true})
      for (const double damping : {0.0, 0.5}) {
        const ShellOptions o{.spacing = 2 * pi * R / 40,
                             .material = SaintVenantKirchhoff(elastic(E, 0.45)),
                             .damping = damping,
                             .rotary_scaling = scaled};
        auto tube = cylinder(R, 40, 11, o.spacing, thick);
        for (int i = 0; i < 160; ++i)
          tube.support[i] = tube.support[tube.count() - 1 - i] = Support::released;
        const double safe = damping > 0.0 ? 0.6 : 0.95, p = E * thick / R;
        EXPECT_LT(growth<2>(ring(R, 40, thick), o, safe, p), 3.0) << thick << scaled << damping;
        EXPECT_LT(growth<3>(tube, o, safe, p), 3.0) << thick << scaled << damping;
      }
}

}  // namespace
}  // namespace ostium::sph3d
