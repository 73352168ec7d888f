/// The motion of a solid as plain data: a checkpoint is this structure written out.
///
///   displacement, velocity   per particle, in the order of the model                          m, m/s
///   strain                   Green strain at the middle of the last step, for the damping: per group of four particles
///                            xx, yy, zz, xy, yz, zx, four numbers each                        -
///   last_step                0 before the first                                               s
#pragma once
#include "core/archive.hpp"
#include "sph3d/solid/solid_model.hpp"

namespace ostium::sph3d {

template <int D>
struct SolidState {
  std::vector<Vec<D>> displacement, velocity;
  std::vector<double> strain;
  double time = 0, last_step = 0;
};

/// Undeformed and at rest.
template <int D>
SolidState<D> at_rest(const SolidModel<D>& model) {
  const std::vector<Vec<D>> zero(model.count(), Vec<D>::Zero());
  return {.displacement = zero,
          .velocity = zero,
          .strain = std::vector<double>(6 * SolidModel<D>::lanes * model.groups(), 0.0)};
}

template <int D>
void archive(Archive& a, SolidState<D>& state) {
  a("time", state.time);
  a("last_step", state.last_step);
  a.template records<double>("displacement", state.displacement);
  a.template records<double>("velocity", state.velocity);
  a("strain", state.strain);
}

}  // namespace ostium::sph3d
