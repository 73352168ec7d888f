// Steps of a shell by law and size, on one thread, everything included.
#include <fmt/format.h>
#include <omp.h>

#include <memory>

#include "bench/bench.hpp"
#include "sph3d/shell/stable_step.hpp"

namespace ostium::bench {

namespace {

using namespace sph3d;

/// A tube of n particles around and as many along, spacing 1 mm, wall 1 mm, at rest.
ShellCloud<3> tube(int n) {
  ShellCloud<3> cloud;
  const double dp = 1e-3, R = n * dp / (2 * pi);
  for (int i = 0; i < n * n; ++i) {
    const double phi = 2 * pi * (i % n) / n;
    const Vec3 normal(std::cos(phi), std::sin(phi), 0.0);
    cloud.position.push_back(R * normal + Vec3(0.0, 0.0, (i / n) * dp));
    cloud.normal.push_back(normal);
    cloud.circumference.push_back(Vec3(-normal[1], normal[0], 0.0));
  }
  cloud.area.assign(cloud.count(), dp * dp);
  cloud.thickness.assign(cloud.count(), 1e-3);
  return in_memory_order(cloud);
}

struct Moving {
  ShellModel<3> model;
  ShellState<3> state;
  ShellWorkspace<3> work;
  std::vector<ShellLoad<3>> load;
  ShellSteps steps;

  Moving(int n, const Material& material)
      : model(tube(n), {.spacing = 1e-3, .material = material, .fibre_angle = 0.7}),
        state(rest(model)),
        work(model),
        load(no_load(model)),
        steps{stable_step(model), 400000 / (n * n) + 1} {}
};

}  // namespace

ShellResult measure_shell(const Options& options) {
  const int threads = omp_get_max_threads();
  omp_set_num_threads(1);
  const Moduli artery = elastic(1e6, 0.45);
  ShellResult result;
  for (const int n : {50, 100, 200})
    for (const Material& material : {Material(SaintVenantKirchhoff(artery)), Material(NeoHookean(artery)),
                                     Material(holzapfel(artery, {.k1 = 1e5, .k2 = 1.0, .kappa = 0.1}))}) {
      Moving shell(n, material);
      Timing t = in_turn({[&] { advance(shell.model, shell.state, shell.load, shell.work, shell.steps); }},
                         options.rounds)[0];
      const double all = double(shell.steps.count) * double(shell.model.count());
      result.rows.push_back({std::visit([](const auto& law) { return law.name; }, material),
                             shell.model.count(),
                             {t.median / all, t.best / all}});
    }
  omp_set_num_threads(threads);
  return result;
}

void print(const ShellResult& r) {
  fmt::print("\nShell, tube, three Gauss points, one thread, whole steps\n");
  fmt::print("{:<24} {:>10} {:>11} {:>9}\n", "law", "particles", "median ns", "best ns");
  for (const auto& row : r.rows)
    fmt::print("{:<24} {:>10} {:11.0f} {:9.0f}\n", row.law, row.particles, 1e9 * row.per_step.median,
               1e9 * row.per_step.best);
}

}  // namespace ostium::bench
