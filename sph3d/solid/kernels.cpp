#include "sph3d/solid/solid_kernels.hpp"

namespace ostium::sph3d {

OSTIUM_DECLARE_PER_ISA(template <int D> const SolidKernels<D>& solid_table())

template <int D>
const SolidKernels<D>& solid_kernels() {
  return OSTIUM_FOR_THIS_PROCESSOR(solid_table<D>());
}

template const SolidKernels<2>& solid_kernels<2>();
template const SolidKernels<3>& solid_kernels<3>();

}  // namespace ostium::sph3d
