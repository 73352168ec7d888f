#include "sph3d/shell/archive.hpp"

namespace ostium::sph3d {

// A structure that has grown is not to be saved without what is new in it.
static_assert(sizeof(ShellState<2>) == sizeof(std::vector<ShellBlock<2>>) + 2 * sizeof(double));

template <int D>
void archive(Archive& a, ShellState<D>& state) {
  a("time", state.time);
  a("strain_time", state.strain_time);
  a.template records<double>("blocks", state.blocks);
}

template <int D>
void archive(Archive& a, ShellPrestressField<D>& prestress) {
  a.template records<double>("prestress", prestress.blocks);
  a.template records<double>("prestrain", prestress.prestrain);
}

template void archive(Archive&, ShellPrestressField<2>&);
template void archive(Archive&, ShellPrestressField<3>&);
template void archive(Archive&, ShellState<2>&);
template void archive(Archive&, ShellState<3>&);

}  // namespace ostium::sph3d
