#include <cstdlib>
#include <cstring>

#include "sph3d/fluid/cluster.hpp"

namespace ostium::sph3d {

namespace baseline {
template <int D>
const FluidKernels<D>& table();
}
namespace avx2 {
template <int D>
const FluidKernels<D>& table();
}

template <int D>
const FluidKernels<D>& fluid_kernels() {
  const char* choice = std::getenv("OSTIUM_ISA");  // "baseline" for comparisons; anything else picks the best
  const bool plain = choice && std::strcmp(choice, "baseline") == 0;
  if (!plain && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return avx2::table<D>();
  return baseline::table<D>();
}

template const FluidKernels<2>& fluid_kernels<2>();
template const FluidKernels<3>& fluid_kernels<3>();

}  // namespace ostium::sph3d
