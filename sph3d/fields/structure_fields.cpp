#include "sph3d/fields/structure_fields.hpp"

#include <algorithm>
#include <numeric>

#include "sph3d/shell/recover.hpp"
#include "sph3d/solid/solid_report.hpp"

namespace ostium::sph3d {

namespace {

StructureFields empty_fields(std::size_t n) {
  StructureFields fields;
  for (auto* depth : {&fields.inner, &fields.middle, &fields.outer})
    depth->stress.resize(n), depth->von_mises.resize(n);
  fields.energy.resize(n);
  return fields;
}

/// Per contact point the nearest particle of this layer: of its own column where that has one, which it has not beside an edge that
/// sticks out into the blood.
template <int D>
std::vector<std::int32_t> nearest_of_layer(const WallCloud<D>& wall, int layer) {
  std::vector<std::int32_t> particles, nearest(wall.contact.size(), -1);
  std::vector<double> least(nearest.size(), 1e300);
  const auto offer = [&](std::size_t k, std::int32_t b) {
    const double apart = (wall.solid.position[b] - wall.contact[k]).squaredNorm();
    if (apart < least[k]) least[k] = apart, nearest[k] = b;
  };
  for (std::size_t b = 0; b < wall.layer.size(); ++b)
    if (wall.layer[b] == layer) particles.push_back(static_cast<std::int32_t>(b));
  for (const auto b : particles) offer(wall.column[b], b);
  for (std::size_t k = 0; k < nearest.size(); ++k)
    if (least[k] == 1e300)
      for (const auto b : particles) offer(k, b);
  return nearest;
}

}  // namespace

template <int D>
StructureFields structure_fields(const ShellBody<D>& body, const ShellState<D>& state) {
  const ShellModel<D>& model = body.model();
  StructureFields fields = empty_fields(model.count());
  const std::pair<StructureFields::Depth*, double> depths[] = {
      {&fields.inner, -1.0}, {&fields.middle, 0.0}, {&fields.outer, 1.0}};
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

template <int D>
StructureFields structure_fields(const SolidBody<D>& body, const SolidState<D>& state) {
  const auto& wall = body.wall();
  const int layers = 1 + *std::max_element(wall.layer.begin(), wall.layer.end());
  StructureFields fields = empty_fields(body.count());
  const std::pair<StructureFields::Depth*, int> depths[] = {
      {&fields.inner, 0}, {&fields.middle, layers / 2}, {&fields.outer, layers - 1}};
  for (const auto& [depth, layer] : depths) {
    const auto particle = nearest_of_layer(wall, layer);
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < body.count(); ++k) {
      const Sym3<double> s = cauchy_stress(body.model(), state, particle[k]);
      depth->stress[k] << s.xx, s.yy, s.zz, s.xy, s.yz, s.zx;
      depth->von_mises[k] = von_mises(s);
    }
  }
  for (std::size_t b = 0; b < wall.column.size(); ++b) {
    const std::int32_t k = wall.column[b];
    fields.energy[k] += strain_energy(body.model(), state, b) / wall.inner.area[k].norm();
  }
  return fields;
}

template <int D>
StructureFields structure_fields(const DeformableWall<D>& wall, const DeformableWallState<D>& state) {
  return std::visit([&](const auto& body) { return structure_fields(body, state.*body.state); }, wall.body());
}

namespace {

/// Computed in parallel, added up in their order.
template <class Energy>
double sum_of(std::size_t n, Energy&& energy) {
  std::vector<double> each(n);
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < n; ++a) each[a] = energy(a);
  return std::accumulate(each.begin(), each.end(), 0.0);
}

template <int D>
double energy_of(const ShellBody<D>& body, const ShellState<D>& state) {
  const ShellModel<D>& model = body.model();
  return sum_of(model.count(),
                [&](std::size_t a) { return model.cloud.area[a] * surface_energy(model, state, a); });
}

template <int D>
double energy_of(const SolidBody<D>& body, const SolidState<D>& state) {
  return sum_of(body.model().count(), [&](std::size_t a) { return strain_energy(body.model(), state, a); });
}

}  // namespace

template <int D>
double strain_energy(const DeformableWall<D>& wall, const DeformableWallState<D>& state) {
  return std::visit([&](const auto& body) { return energy_of(body, state.*body.state); }, wall.body());
}

#define OSTIUM_INSTANTIATE(D)                                                                         \
  template StructureFields structure_fields(const ShellBody<D>&, const ShellState<D>&);               \
  template StructureFields structure_fields(const SolidBody<D>&, const SolidState<D>&);               \
  template StructureFields structure_fields(const DeformableWall<D>&, const DeformableWallState<D>&); \
  template double strain_energy(const DeformableWall<D>&, const DeformableWallState<D>&);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
