#include "sph3d/fields/point_weights.hpp"

#include "sph3d/geometry/point_grid.hpp"
#include "sph3d/shell/reduced_kernel.hpp"

namespace ostium::sph3d {

namespace {

constexpr double same_side = 0.5;  // cosine between normals

template <int D>
std::vector<Vec<D>> positions(const std::vector<WallPoint<D>>& wall) {
  std::vector<Vec<D>> x;
  for (const auto& point : wall) x.push_back(point.position);
  return x;
}

/// rows(i) of all receiving points, found in parallel, one after the other.
template <class Row>
PointWeights collected(std::size_t count, Row&& row_of) {
  std::vector<std::vector<PointWeights::Entry>> rows(count);
#pragma omp parallel for schedule(dynamic, 64)
  for (std::size_t i = 0; i < count; ++i) rows[i] = row_of(i);
  PointWeights weights;
  for (const auto& row : rows) {
    weights.entry.insert(weights.entry.end(), row.begin(), row.end());
    weights.begin.push_back(static_cast<std::int64_t>(weights.entry.size()));
  }
  return weights;
}

/// A wall point near a place, and its kernel.
template <int D>
struct Near {
  int point;
  Vec<D> apart;
  double w;
};

/// Weights that are exact for linear fields in the tangent plane; those of the kernel alone where that plane is badly covered.
template <int D>
std::vector<PointWeights::Entry> linear_weights(const std::vector<Near<D>>& near, const Vec<D>& n, double h) {
  double whole = 0;
  Vec<D> first = Vec<D>::Zero();
  Mat<D> second = Mat<D>::Zero();
  for (const auto& [b, apart, w] : near)
    whole += w, first += w * apart, second += w * apart * apart.transpose();
  // a little stiffness, and none along the normal
  second += whole * h * h * (1e-6 * Mat<D>::Identity() + 1e6 * n * n.transpose());
  const Vec<D> slope = second.ldlt().solve(first);
  const double sum = whole - slope.dot(first);
  const bool good = sum > 0.05 * whole;
  std::vector<PointWeights::Entry> row;
  for (const auto& [b, apart, w] : near)
    row.push_back({b, static_cast<float>(good ? w * (1.0 - slope.dot(apart)) / sum : w / whole)});
  return row;
}

}  // namespace

template <int D>
PointWeights smoothing_weights(const std::vector<WallPoint<D>>& wall, double h) {
  const ReducedKernel<D> kernel{h};
  const auto x = positions(wall);
  const PointGrid<D> grid(x, kernel.reach());
  const auto for_near = [&](std::size_t a, auto&& f) {
    grid.near(x[a], [&](int b, const Vec<D>& apart) {
      if (wall[a].normal.dot(wall[b].normal) > same_side) f(b, kernel.value(apart.norm()));
    });
  };
  std::vector<double> given(wall.size(), 0.0);
#pragma omp parallel for schedule(static)
  for (std::size_t b = 0; b < wall.size(); ++b)
    for_near(b, [&](int c, double w) { given[b] += w * wall[c].area; });
  return collected(wall.size(), [&](std::size_t a) {
    std::vector<PointWeights::Entry> row;
    for_near(a, [&](int b, double w) {
      row.push_back({b, static_cast<float>(w * wall[a].area / given[b])});
    });
    return row;
  });
}

template <int D>
PointWeights mapping_weights(const std::vector<WallPoint<D>>& wall, const std::vector<Vec<D>>& points,
                             const std::vector<Vec<D>>& normals, double h) {
  constexpr double widest = 2.0;
  const auto x = positions(wall);
  const PointGrid<D> grid(x, 2.0 * widest * h);
  return collected(points.size(), [&](std::size_t i) {
    const bool faces = normals[i].squaredNorm() > 0.0;
    std::vector<Near<D>> near;
    for (const double wide : {1.0, widest}) {
      const ReducedKernel<D> kernel{wide * h};
      near.clear();
      grid.near(points[i], [&](int b, const Vec<D>& apart) {
        const double w = kernel.value(apart.norm());
        if (w > 0.0 && (!faces || wall[b].normal.dot(normals[i]) > same_side)) near.push_back({b, -apart, w});
      });
      if (near.size() >= std::size_t(D)) break;
    }
    return near.empty() ? std::vector<PointWeights::Entry>() : linear_weights<D>(near, normals[i], h);
  });
}

#define OSTIUM_INSTANTIATE(D)                                                                         \
  template PointWeights smoothing_weights(const std::vector<WallPoint<D>>&, double);                  \
  template PointWeights mapping_weights(const std::vector<WallPoint<D>>&, const std::vector<Vec<D>>&, \
                                        const std::vector<Vec<D>>&, double);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
