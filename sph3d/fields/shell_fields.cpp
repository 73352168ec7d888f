#include "sph3d/fields/shell_fields.hpp"

namespace ostium::sph3d {

template <int D>
ShellFields shell_fields(const ShellModel<D>& model, const ShellState<D>& state) {
  ShellFields fields;
  const std::pair<ShellFields::Depth*, double> depths[] = {
      {&fields.inner, -1.0}, {&fields.middle, 0.0}, {&fields.outer, 1.0}};
  for (const auto& [depth, zeta] : depths)
    depth->stress.resize(model.count()), depth->von_mises.resize(model.count());
  fields.energy.resize(model.count());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < model.count(); ++a) {
    for (const auto& [depth, zeta] : depths) {
      const WallStress<D> at = wall_stress(model, state, a, zeta);
      const Eigen::Matrix3d& s = at.cauchy;
      depth->stress[a] << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
      depth->von_mises[a] = at.von_mises();
    }
    fields.energy[a] = surface_energy(model, state, a);
  }
  return fields;
}

template ShellFields shell_fields(const ShellModel<2>&, const ShellState<2>&);
template ShellFields shell_fields(const ShellModel<3>&, const ShellState<3>&);

}  // namespace ostium::sph3d
