#include "sph3d/fields/wall_gradient.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "sph3d/geometry/point_grid.hpp"
#include "sph3d/shell/reduced_kernel.hpp"

namespace ostium::sph3d {

namespace {

constexpr double range = 3.0;  // of the fit, over the smoothing length: four layers of particles

/// The particles in front of the wall.
template <int D>
struct Layers {
  std::vector<Vec<D>> position, velocity, normal;  // the wall's, at the foot
  std::vector<double> distance;
};

/// Normal of the wall at the foot of x, and the distance: along the mean of that normal and the nearest point's, which is exact to
/// second order in the curvature. Negative where the wall is further than the range.
template <int D>
std::pair<double, Vec<D>> foot_of(const Vec<D>& x, const std::vector<WallPoint<D>>& wall,
                                  const PointGrid<D>& grid, const ReducedKernel<D>& kernel, double furthest) {
  int nearest = -1;
  double least = 1e300;
  grid.near(x, [&](int a, const Vec<D>& apart) {
    if (apart.squaredNorm() < least && apart.dot(wall[a].normal) < 0.5 * kernel.h)
      nearest = a, least = apart.squaredNorm();
  });
  if (nearest < 0) return {-1.0, Vec<D>::Zero()};
  const Vec<D>& n = wall[nearest].normal;
  const Vec<D> to_wall = wall[nearest].position - x;
  const Vec<D> across = to_wall - to_wall.dot(n) * n;
  Vec<D> mean = Vec<D>::Zero();
  grid.near(x, [&](int a, const Vec<D>& apart) {
    const Vec<D> along = apart + to_wall - across;  // from the point to the foot
    if (wall[a].normal.dot(n) > 0.0) mean += kernel.value(along.norm()) * wall[a].normal;
  });
  mean.normalize();
  const double s = std::max(to_wall.dot((n + mean).normalized()), 0.1 * kernel.h);
  return {s < furthest ? s : -1.0, mean};
}

template <int D>
Layers<D> layers_of(const Vessel<D>& vessel, const std::vector<WallPoint<D>>& wall) {
  const auto& fluid = vessel.state().fluid;
  const auto& duct_of = vessel.workspace().duct_of;
  const double h = vessel.model().kernel.h, furthest = range * h;
  std::vector<Vec<D>> x;
  for (const auto& point : wall) x.push_back(point.position);
  const PointGrid<D> grid(x, furthest + h);
  std::vector<double> distance(fluid.places(), -1.0);
  std::vector<Vec<D>> normal(fluid.places());
  const std::size_t known = std::min(fluid.places(), duct_of.size());
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < known; ++i)
    if (fluid.filled[i] && duct_of[i] < 0)
      std::tie(distance[i], normal[i]) =
          foot_of<D>(fluid.position[i], wall, grid, ReducedKernel<D>{h}, furthest);
  Layers<D> layers;
  for (std::size_t i = 0; i < known; ++i) {
    if (distance[i] < 0.0) continue;
    layers.position.push_back(fluid.position[i]), layers.velocity.push_back(fluid.velocity(i));
    layers.normal.push_back(normal[i]), layers.distance.push_back(distance[i]);
  }
  return layers;
}

/// Sums of the least squares; `moments` k: sum of w s^(k+2).
template <int D>
struct Fit {
  double moments[3] = {};
  Vec<D> first = Vec<D>::Zero(), second = Vec<D>::Zero();

  void add(double w, double s, const Vec<D>& u) {
    moments[0] += w * s * s, moments[1] += w * s * s * s, moments[2] += w * s * s * s * s;
    first += w * s * u, second += w * s * s * u;
  }
  Vec<D> slope() const {
    if (moments[0] <= 0.0) return Vec<D>::Zero();
    const double whole = moments[0] * moments[2], determinant = whole - moments[1] * moments[1];
    if (determinant < 0.02 * whole) return first / moments[0];
    return (moments[2] * first - moments[1] * second) / determinant;
  }
};

}  // namespace

template <int D>
std::vector<Vec<D>> shear_stress_from_gradient(const Vessel<D>& vessel,
                                               const std::vector<WallPoint<D>>& now) {
  const auto& o = vessel.model().options;
  const ReducedKernel<D> kernel{vessel.model().kernel.h};
  const Layers<D> layers = layers_of(vessel, now);
  const PointGrid<D> grid(layers.position, std::hypot(range * kernel.h, kernel.reach()));
  std::vector<Vec<D>> stress(now.size());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < now.size(); ++a) {
    const Vec<D>& n = now[a].normal;
    const Vec<D> own = vessel.wall() ? vessel.state().wall.velocity[a] : Vec<D>(Vec<D>::Zero());
    Fit<D> fit;
    grid.near(now[a].position, [&](int i, const Vec<D>& apart) {
      if (layers.normal[i].dot(n) < 0.5) return;
      const Vec<D> u = layers.velocity[i] - own;
      const double s = layers.distance[i], along = (apart - apart.dot(n) * n).norm();
      fit.add(s / kernel.h * kernel.value(along), s, u - u.dot(n) * n);
    });
    stress[a] = o.density * o.viscosity * fit.slope();
  }
  return stress;
}

template std::vector<Vec2> shear_stress_from_gradient(const Vessel<2>&, const std::vector<WallPoint<2>>&);
template std::vector<Vec3> shear_stress_from_gradient(const Vessel<3>&, const std::vector<WallPoint<3>>&);

}  // namespace ostium::sph3d
