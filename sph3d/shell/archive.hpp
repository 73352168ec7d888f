/// The state of a shell as named arrays (core/archive): what a checkpoint holds of it.
#pragma once
#include "core/archive.hpp"
#include "sph3d/shell/state.hpp"

namespace ostium::sph3d {

template <int D>
void archive(Archive& a, ShellState<D>& state);

/// The stress of the reference, for who would rather keep it than find it anew.
template <int D>
void archive(Archive& a, ShellPrestressField<D>& prestress);

}  // namespace ostium::sph3d
