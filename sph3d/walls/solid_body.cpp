#include "sph3d/walls/solid_body.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::sph3d {

template <int D>
SolidBody<D>::SolidBody(const WallCloud<D>& wall, const SolidOptions& options)
    : wall_(wall), model_(make_solid(wall.solid, options)) {
  TractionPatch<D> traction{.particle = wall.inner.particle, .force = {}, .to_surface = {}};
  for (std::size_t k = 0; k < count(); ++k) {
    const std::int32_t a = wall.inner.particle[k];
    traction.to_surface.push_back(wall.contact[k] - wall.solid.position[a]);
    normal_.push_back(wall.normal[a]);
  }
  traction.force.assign(count(), Vec<D>::Zero());
  loads_.patches = {wall.inner};
  loads_.tractions = {std::move(traction)};
}

template <int D>
std::vector<WallPoint<D>> SolidBody<D>::points(const SolidState<D>& solid) const {
  std::vector<WallPoint<D>> points(count());
#pragma omp parallel for schedule(static)
  for (std::size_t k = 0; k < points.size(); ++k) {
    const std::int32_t a = wall_.inner.particle[k];
    const Mat<D> F = deformation_gradient(model_, solid.displacement, a), turn = F.inverse().transpose();
    points[k].position =
        model_.cloud.position[a] + solid.displacement[a] + F * loads_.tractions[0].to_surface[k];
    points[k].normal = (turn * normal_[k]).normalized();
    points[k].area = F.determinant() * (turn * wall_.inner.area[k]).norm();
  }
  return points;
}

template <int D>
std::vector<Vec<D>> SolidBody<D>::contacts(const SolidState<D>& solid) const {
  std::vector<Vec<D>> x(count());
  const auto now = points(solid);
  for (std::size_t k = 0; k < x.size(); ++k) x[k] = now[k].position;
  return x;
}

template <int D>
std::vector<Vec<D>> SolidBody<D>::normals(const SolidState<D>& solid) const {
  std::vector<Vec<D>> n(count());
  const auto now = points(solid);
  for (std::size_t k = 0; k < n.size(); ++k) n[k] = now[k].normal;
  return n;
}

template <int D>
void SolidBody<D>::step(SolidState<D>& solid, double dt, const std::vector<Vec<D>>& force, double pressure) {
  loads_.patches[0].pressure = pressure;
  loads_.tractions[0].force = force;
  const double stable = stable_step(model_, solid, {});  // from the state alone: the same after a restart
  const int steps = std::max(1, static_cast<int>(std::ceil(dt / stable)));
  for (int k = 0; k < steps; ++k) advance(model_, solid, loads_, dt / steps, work_);
}

template class SolidBody<2>;
template class SolidBody<3>;

}  // namespace ostium::sph3d
