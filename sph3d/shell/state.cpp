#include "sph3d/shell/state.hpp"

namespace ostium::sph3d {

template <int D>
ShellState<D> rest(const ShellModel<D>& model) {
  ShellState<D> state;
  state.blocks.assign(model.blocks(), ShellBlock<D>{});
  for (std::size_t b = 0; b < model.blocks(); ++b)
    for (int d = 0; d < D; ++d)
      for (int lane = 0; lane < 8; ++lane) state.blocks[b].n[d][lane] = model.reference[b].N[d][lane];
  return state;
}

template ShellState<2> rest(const ShellModel<2>&);
template ShellState<3> rest(const ShellModel<3>&);

}  // namespace ostium::sph3d
