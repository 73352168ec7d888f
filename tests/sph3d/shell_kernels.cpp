// The kernels: one result for any number of threads and any order of memory, near that of other instruction sets.
#include <gtest/gtest.h>
#include <omp.h>

#include <cstdlib>
#include <cstring>

#include "shell_clouds.hpp"
#include "sph3d/shell/stable_step.hpp"

namespace ostium::sph3d {
namespace {

ShellState<3> flying_cylinder(const char* instruction_set = nullptr) {
  if (instruction_set) setenv("OSTIUM_ISA", instruction_set, 1);
  const ShellModel<3> model(in_memory_order(cylinder(0.01, 60, 40, 0.001, 0.001)),
                            {.spacing = 0.001, .material = NeoHookean(elastic(1e6, 0.45))});
  auto state = rest(model);
  for (std::size_t a = 0; a < model.count(); ++a) {
    const Vec3 x = model.cloud.position[a];
    state.velocity(a, Vec3(x[1], x[2], 20 * x[0]));
  }
  ShellWorkspace<3> work(model);
  advance(model, state, no_load(model), work, {stable_step(model), 20});
  if (instruction_set) unsetenv("OSTIUM_ISA");
  return state;
}

TEST(ShellKernels, SameBitsForAnyNumberOfThreads) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto one = flying_cylinder();
  omp_set_num_threads(3);
  const auto three = flying_cylinder();
  omp_set_num_threads(before);
  EXPECT_EQ(std::memcmp(one.blocks.data(), three.blocks.data(), one.blocks.size() * sizeof(one.blocks[0])),
            0);
}

TEST(ShellKernels, SameMotionWithEveryInstructionSet) {
  const auto best = flying_cylinder();
  for (const char* name : {"baseline", "avx2"}) {
    const auto other = flying_cylinder(name);
    for (std::size_t a = 0; a < 2400; ++a) {
      EXPECT_LT((best.displacement(a) - other.displacement(a)).norm(), 1e-15) << name;
      EXPECT_LT((best.normal(a) - other.normal(a)).norm(), 1e-10) << name;
    }
  }
}

// Steps taken in one call or in several are the same steps.
TEST(ShellKernels, CallsDoNotMatter) {
  const ShellModel<2> model(ring(0.01, 64, 0.001), {.spacing = 0.001});
  auto one = rest(model), two = one;
  for (std::size_t a = 0; a < model.count(); ++a) {
    one.velocity(a, Vec2(0.1 * std::sin(3.0 * double(a)), 0.2));
    two.velocity(a, one.velocity(a));
  }
  ShellWorkspace<2> work(model);
  const double dt = stable_step(model);
  advance(model, one, no_load(model), work, {dt, 10});
  for (int k = 0; k < 10; ++k) advance(model, two, no_load(model), work, {dt, 1});
  for (std::size_t a = 0; a < model.count(); ++a)
    EXPECT_LT((one.displacement(a) - two.displacement(a)).norm(), 1e-16);
}

}  // namespace
}  // namespace ostium::sph3d
