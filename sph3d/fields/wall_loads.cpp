#include "sph3d/fields/wall_loads.hpp"

#include <cmath>
#include <unordered_map>

#include "sph3d/step/lane_access.hpp"

namespace ostium::sph3d {

namespace {

/// Wall points by cells of one kernel reach.
template <int D>
class Cells {
 public:
  Cells(const std::vector<WallPoint<D>>& wall, double size) : size_(size) {
    for (std::size_t a = 0; a < wall.size(); ++a)
      points_[key(cell(wall[a].position))].push_back(static_cast<int>(a));
  }

  template <class F>
  void near(const Vec<D>& x, F&& f) const {
    const auto c = cell(x);
    for (int k = 0; k < (D == 3 ? 27 : 9); ++k) {
      auto other = c;
      for (int d = 0, rest = k; d < D; ++d, rest /= 3) other[d] += rest % 3 - 1;
      if (const auto found = points_.find(key(other)); found != points_.end())
        for (const int a : found->second) f(a);
    }
  }

 private:
  using Cell = std::array<std::int64_t, D>;
  Cell cell(const Vec<D>& x) const {
    Cell c;
    for (int d = 0; d < D; ++d) c[d] = static_cast<std::int64_t>(std::floor(x[d] / size_));
    return c;
  }
  static std::int64_t key(const Cell& c) {
    std::int64_t k = 0;
    for (int d = 0; d < D; ++d) k = k * 2097152 + (c[d] + 1048576);
    return k;
  }

  double size_;
  std::unordered_map<std::int64_t, std::vector<int>> points_;
};

}  // namespace

template <int D>
WallLoads<D> wall_loads(const Vessel<D>& vessel, const std::vector<WallPoint<D>>& wall) {
  const auto& model = vessel.model();
  const auto& fluid = vessel.state().fluid;
  const auto& work = vessel.workspace();
  const double rho = model.options.density, c2 = model.options.sound_speed * model.options.sound_speed;
  const Cells<D> cells(wall, model.reach());
  WallLoads<D> loads{std::vector<Vec<D>>(wall.size(), Vec<D>::Zero()), std::vector<double>(wall.size(), 0.0)};
  std::vector<double> weight(wall.size(), 0.0);
  std::vector<std::pair<int, double>> near;
  for (std::size_t i = 0; i < fluid.places() && i < work.duct_of.size(); ++i) {
    const Cluster<D>& own = fluid.clusters[i / 8];
    if (!fluid.filled[i] || work.duct_of[i] >= 0 || own.friction[i % 8] <= 0.0f) continue;
    near.clear();
    double sum = 0;
    cells.near(fluid.position[i], [&](int a) {
      const double w = model.kernel.value((wall[a].position - fluid.position[i]).norm());
      if (w > 0.0) near.emplace_back(a, w), sum += w;
    });
    const Vec<D> force = rho * fluid.volume * own.friction[i % 8] * lane_vector<D>(own.v, i % 8);
    const double pressure = rho * c2 * own.psi[i % 8] + vessel.state().datum.reference;
    for (const auto& [a, w] : near) {
      loads.shear_stress[a] += w / sum * force;
      loads.pressure[a] += w * pressure;
      weight[a] += w;
    }
  }
  for (std::size_t a = 0; a < wall.size(); ++a) {
    const Vec<D>& n = wall[a].normal;
    loads.shear_stress[a] = (loads.shear_stress[a] - loads.shear_stress[a].dot(n) * n) / wall[a].area;
    loads.pressure[a] = weight[a] > 0.0 ? loads.pressure[a] / weight[a] : vessel.state().datum.reference;
  }
  return loads;
}

namespace {

/// Area-weighted normals of the wall's facets at the corners of the surface; zero where only openings meet.
template <int D>
std::vector<Vec<D>> corner_normals(const Surface<D>& surface) {
  std::vector<Vec<D>> normals(surface.points.size(), Vec<D>::Zero());
  for (std::size_t f = 0; f < surface.facets.size(); ++f) {
    if (surface.label[f] >= 0) continue;
    for (const int corner : surface.facets[f]) normals[corner] += area_vector(surface, static_cast<int>(f));
  }
  for (auto& n : normals) n.normalize();
  return normals;
}

}  // namespace

template <int D>
WallLoads<D> mapped_to_surface(const Model<D>& model, const std::vector<WallPoint<D>>& wall,
                               const WallLoads<D>& loads) {
  const auto& points = model.lumen.surface.points;
  const auto normals = corner_normals(model.lumen.surface);
  const Cells<D> cells(wall, model.reach());
  WallLoads<D> mapped{std::vector<Vec<D>>(points.size(), Vec<D>::Zero()),
                      std::vector<double>(points.size(), 0.0)};
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < points.size(); ++i) {
    double weight = 0;
    cells.near(points[i], [&](int a) {
      if (wall[a].normal.dot(normals[i]) < 0.5 && normals[i].squaredNorm() > 0.0) return;
      const double w = model.kernel.value((wall[a].position - points[i]).norm());
      weight += w;
      mapped.shear_stress[i] += w * loads.shear_stress[a];
      mapped.pressure[i] += w * loads.pressure[a];
    });
    if (weight > 0.0) mapped.shear_stress[i] /= weight, mapped.pressure[i] /= weight;
  }
  return mapped;
}

template WallLoads<2> mapped_to_surface(const Model<2>&, const std::vector<WallPoint<2>>&,
                                        const WallLoads<2>&);
template WallLoads<3> mapped_to_surface(const Model<3>&, const std::vector<WallPoint<3>>&,
                                        const WallLoads<3>&);
template WallLoads<2> wall_loads(const Vessel<2>&, const std::vector<WallPoint<2>>&);
template WallLoads<3> wall_loads(const Vessel<3>&, const std::vector<WallPoint<3>>&);

}  // namespace ostium::sph3d
