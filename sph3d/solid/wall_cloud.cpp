#include "sph3d/solid/wall_cloud.hpp"

#include <cmath>

#include "core/error.hpp"
#include "sph3d/geometry/offset.hpp"
#include "sph3d/geometry/point_grid.hpp"
#include "sph3d/geometry/sample.hpp"
#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/geometry/stretches.hpp"
#include "sph3d/neighbours/order.hpp"

namespace ostium::sph3d {

namespace {

int layers_of(double thickness, double spacing) {
  if (!(thickness > 0)) user_error("The thickness of a wall must be positive; found {:g} m.", thickness);
  if (!(spacing > 0))
    user_error("The spacing of a wall's particles must be positive; found {:g} m.", spacing);
  const int layers = static_cast<int>(std::lround(thickness / spacing));
  if (layers < 4)
    user_error(
        "A volume wall needs four layers of particles or more; a thickness of {:g} m with a spacing of {:g} "
        "m makes {}. "
        "Take a spacing of {:g} m or less, or a shell, which is one layer whatever the thickness.",
        thickness, spacing, layers, thickness / 4.0);
  return layers;
}

/// The wall alone, for distances to it.
template <int D>
Surface<D> wall_of(const Lumen<D>& lumen) {
  Surface<D> wall{.points = lumen.surface.points, .facets = {}, .label = {}};
  for (std::size_t f = 0; f < lumen.surface.facets.size(); ++f)
    if (lumen.surface.label[f] < 0) wall.facets.push_back(lumen.surface.facets[f]), wall.label.push_back(-1);
  return wall;
}

std::vector<WallPoint<2>> spread(const Lumen<2>& lumen, double spacing) {
  return spread_evenly(lumen.surface, spacing);
}

std::vector<WallPoint<3>> spread(const Lumen<3>& lumen, double spacing) {
  return sample_wall(lumen, spacing);
}

template <int D>
void add_layer(WallCloud<D>& cloud, const Lumen<D>& lumen, const SignedDistance<D>& inner, int layer,
               double height, double spacing) {
  const double depth = (layer + 0.5) * height;
  for (const auto& p : spread(offset(lumen, depth), spacing)) {
    const auto hit = inner(p.position);
    if ((p.position - hit.closest).norm() < depth - 0.25 * height) continue;  // beyond a crotch
    cloud.solid.position.push_back(p.position), cloud.solid.volume.push_back(p.area * height);
    cloud.depth.push_back(depth), cloud.normal.push_back(p.normal), cloud.layer.push_back(layer);
  }
}

template <class T>
void reorder(std::vector<T>& values, const std::vector<std::int32_t>& order) {
  std::vector<T> sorted;
  for (const auto k : order) sorted.push_back(values[k]);
  values = std::move(sorted);
}

/// f(point, area vector) over pieces of facet f no longer than `size`.
template <class F>
void for_pieces(const Surface<2>& s, int f, double size, F&& visit) {
  const Vec2 a = s.points[s.facets[f][0]], along = s.points[s.facets[f][1]] - a, area = area_vector(s, f);
  const int n = std::max(1, static_cast<int>(std::ceil(along.norm() / size)));
  for (int k = 0; k < n; ++k) visit(a + (k + 0.5) / n * along, area / n);
}

template <class F>
void for_pieces(const Surface<3>& s, int f, double size, F&& visit) {
  const Vec3 a = s.points[s.facets[f][0]], u = s.points[s.facets[f][1]] - a, v = s.points[s.facets[f][2]] - a;
  const double longest = std::max({u.norm(), v.norm(), (u - v).norm()});
  const int n = std::max(1, static_cast<int>(std::ceil(longest / size)));
  const Vec3 area = area_vector(s, f) / (n * n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n - i; ++j) {
      visit(a + (i + 1.0 / 3.0) / n * u + (j + 1.0 / 3.0) / n * v, area);
      if (i + j < n - 1) visit(a + (i + 2.0 / 3.0) / n * u + (j + 2.0 / 3.0) / n * v, area);
    }
}

/// The nearest of the points, within three spacings.
template <int D>
int nearest(const PointGrid<D>& grid, const Vec<D>& x) {
  double least = 1e300;
  int best = -1;
  grid.near(x, [&](int j, const Vec<D>& apart) {
    if (apart.squaredNorm() < least) least = apart.squaredNorm(), best = j;
  });
  return best;
}

/// Each small piece of the inner surface goes to the nearest particle of the first layer.
template <int D>
PressurePatch<D> inner_patch(const WallCloud<D>& cloud, const Lumen<D>& lumen, double height,
                             double spacing) {
  std::vector<Vec<D>> points;
  PressurePatch<D> patch;
  for (std::size_t a = 0; a < cloud.layer.size(); ++a)
    if (cloud.layer[a] == 0)
      points.push_back(cloud.solid.position[a]), patch.particle.push_back(static_cast<std::int32_t>(a));
  patch.area.assign(points.size(), Vec<D>::Zero());
  patch.depth = 0.5 * height;
  const PointGrid<D> grid(points, 3 * spacing);
  const auto& s = lumen.surface;
  for (int f = 0; f < static_cast<int>(s.facets.size()); ++f) {
    if (s.label[f] >= 0) continue;
    for_pieces(s, f, 0.3 * spacing, [&](const Vec<D>& x, const Vec<D>& area) {
      const int best = nearest<D>(grid, x);
      if (best >= 0) patch.area[best] -= area;  // out of the wall is into the lumen
    });
  }
  return patch;
}

/// Contact points below the first layer, and the one at the foot of every particle.
template <int D>
void find_contacts(WallCloud<D>& cloud, const SignedDistance<D>& inner, double spacing) {
  for (const auto a : cloud.inner.particle) cloud.contact.push_back(inner(cloud.solid.position[a]).closest);
  const PointGrid<D> grid(cloud.contact, 3 * spacing);
  for (std::size_t a = 0; a < cloud.layer.size(); ++a) {
    const Vec<D> foot = inner(cloud.solid.position[a]).closest;
    cloud.column.push_back(nearest<D>(grid, foot));
    OSTIUM_ASSERT(cloud.column.back() >= 0, "no particle of the first layer near the foot of particle {}", a);
  }
}

}  // namespace

template <int D>
WallCloud<D> wall_cloud(const Lumen<D>& lumen, double thickness, double spacing) {
  const int layers = layers_of(thickness, spacing);
  const double height = thickness / layers;
  const SignedDistance<D> inner(wall_of(lumen));
  WallCloud<D> cloud;
  for (int layer = 0; layer < layers; ++layer) add_layer(cloud, lumen, inner, layer, height, spacing);
  const auto order = bisection_order<D>(cloud.solid.position);
  reorder(cloud.solid.position, order), reorder(cloud.solid.volume, order);
  reorder(cloud.depth, order), reorder(cloud.normal, order), reorder(cloud.layer, order);
  cloud.inner = inner_patch(cloud, lumen, height, spacing);
  find_contacts(cloud, inner, spacing);
  return cloud;
}

template WallCloud<2> wall_cloud(const Lumen<2>&, double, double);
template WallCloud<3> wall_cloud(const Lumen<3>&, double, double);

}  // namespace ostium::sph3d
