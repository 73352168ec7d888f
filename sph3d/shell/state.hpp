/// A moving shell as plain data: a checkpoint is this structure written out, a copy is a copy, a restart is exact.
///
///   blocks       displacement, velocity, pseudo-normal and its rate, last strains; see block.hpp
///   time         of positions and velocities                                          s
///   strain_time  at which the strains were stored; before any step: not a number      s
#pragma once
#include <limits>
#include <vector>

#include "sph3d/shell/model.hpp"

namespace ostium::sph3d {

template <int D>
struct ShellState {
  std::vector<ShellBlock<D>> blocks;
  double time = 0, strain_time = std::numeric_limits<double>::quiet_NaN();

  Vec<D> displacement(std::size_t a) const { return at(blocks[a / 8].u, a % 8); }
  Vec<D> velocity(std::size_t a) const { return at(blocks[a / 8].v, a % 8); }
  Vec<D> normal(std::size_t a) const { return at(blocks[a / 8].n, a % 8); }
  Vec<D> normal_rate(std::size_t a) const { return at(blocks[a / 8].w, a % 8); }

  void displacement(std::size_t a, const Vec<D>& u) { put(blocks[a / 8].u, a % 8, u); }
  void velocity(std::size_t a, const Vec<D>& v) { put(blocks[a / 8].v, a % 8, v); }
  /// Unit vector.
  void normal(std::size_t a, const Vec<D>& n) { put(blocks[a / 8].n, a % 8, n); }
  /// Perpendicular to the normal.
  void normal_rate(std::size_t a, const Vec<D>& w) { put(blocks[a / 8].w, a % 8, w); }

 private:
  static void put(double (&field)[D][8], std::size_t lane, const Vec<D>& x) {
    for (int d = 0; d < D; ++d) field[d][lane] = x[d];
  }
};

/// At rest in the reference.
template <int D>
ShellState<D> rest(const ShellModel<D>& model);

/// What acts from outside, constant during the steps of one call: zero everywhere.
template <int D>
std::vector<ShellLoad<D>> no_load(const ShellModel<D>& model) {
  return std::vector<ShellLoad<D>>(model.blocks(), ShellLoad<D>{});
}

}  // namespace ostium::sph3d
