#include <cstdlib>
#include <string_view>

#include "sph3d/fluid/cluster.hpp"

namespace ostium::sph3d {

#define OSTIUM_DECLARE(isa)       \
  namespace isa {                 \
  template <int D>                \
  const FluidKernels<D>& table(); \
  }
OSTIUM_DECLARE(baseline)
#ifndef OSTIUM_BASELINE_ONLY
OSTIUM_DECLARE(avx2)
OSTIUM_DECLARE(avx512)
#endif

template <int D>
const FluidKernels<D>& fluid_kernels() {
#ifndef OSTIUM_BASELINE_ONLY
  const char* wish =
      std::getenv("OSTIUM_ISA");  // "baseline" or "avx2" for comparisons; otherwise the best there is
  const std::string_view choice = wish ? wish : "";
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && choice != "baseline";
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                      __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw") &&
                      choice != "avx2";
  if (avx512) return avx512::table<D>();
  if (avx2) return avx2::table<D>();
#endif
  return baseline::table<D>();
}

template const FluidKernels<2>& fluid_kernels<2>();
template const FluidKernels<3>& fluid_kernels<3>();

}  // namespace ostium::sph3d
