#include <cstdlib>
#include <string_view>

#include "sph3d/fluid/cluster.hpp"
#include "sph3d/fluid/instruction_set.hpp"

namespace ostium::sph3d {

InstructionSet instruction_set() {
  const char* wish = std::getenv("OSTIUM_ISA");
  const std::string_view choice = wish ? wish : "";
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && choice != "baseline";
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                      choice != "avx2";
  return avx512 ? InstructionSet::avx512 : avx2 ? InstructionSet::avx2 : InstructionSet::baseline;
}

OSTIUM_DECLARE_PER_ISA(template <int D> const FluidKernels<D>& table())

template <int D>
const FluidKernels<D>& fluid_kernels() {
  return OSTIUM_FOR_THIS_PROCESSOR(table<D>());
}

template const FluidKernels<2>& fluid_kernels<2>();
template const FluidKernels<3>& fluid_kernels<3>();

}  // namespace ostium::sph3d
