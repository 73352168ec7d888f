#include "sph3d/shell/kernels.hpp"

#include "sph3d/fluid/instruction_set.hpp"

namespace ostium::sph3d {

OSTIUM_DECLARE_PER_ISA(template <int D> const ShellKernels<D>& shell_table())

template <int D>
const ShellKernels<D>& shell_kernels() {
  return OSTIUM_FOR_THIS_PROCESSOR(shell_table<D>());
}

template const ShellKernels<2>& shell_kernels<2>();
template const ShellKernels<3>& shell_kernels<3>();

}  // namespace ostium::sph3d
