#include "frozen_fluid.hpp"

#include <Eigen/SparseCholesky>

namespace ostium::sph3d {

using bench::WallSums;

/// Images of the particles across the periodic faces stand in for the rest of the fluid.
template <int D>
auto FrozenFluid<D>::pairs(double reach) const -> std::vector<std::vector<Pair>> {
  std::vector<Vec<D>> images;
  std::vector<int> original;
  const int n = static_cast<int>(points.size());
  for (int i = 0; i < n; ++i) images.push_back(points[i]), original.push_back(i);
  for (int d = 0; d < D; ++d)
    if (period[d] > 0)
      for (std::size_t i = 0, end = images.size(); i < end; ++i)
        for (int k = -static_cast<int>(reach / period[d]) - 1; k <= reach / period[d] + 1; ++k)
          if (const double x = images[i][d] + k * period[d]; k != 0 && x > -reach && x < period[d] + reach) {
            images.push_back(images[i] + k * period[d] * Vec<D>::Unit(d));
            original.push_back(original[i]);
          }
  const bench::Cells<D> cells(images, reach);
  std::vector<std::vector<Pair>> result(n);
  for (int i = 0; i < n; ++i)
    cells.near(points[i], [&](int j, const Vec<D>& r) {
      if (j != i) result[i].push_back({original[j], r});
    });
  return result;
}

template <int D>
void FrozenFluid<D>::relax(const Wall<D>& wall, int iterations) {
  const double h2 = kernel.h * kernel.h;
  std::vector<std::vector<Pair>> near;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    if (iteration % 5 == 0) {
      for (auto& x : points)
        for (int d = 0; d < D; ++d)
          if (period[d] > 0) x[d] -= period[d] * std::floor(x[d] / period[d]);
      near = pairs(kernel.reach() + 0.4);
    }
    std::vector<Vec<D>> step(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const WallSums<D> outside = wall(points[i]);
      Vec<D> push = outside.gradient;
      for (const auto& [j, r] : near[i]) {
        const double length = r.norm();
        push += kernel.slope(length) / std::max(length, 1e-9) * r;
      }
      step[i] =
          outside.filling > 0.5 ? Vec<D>(-0.2 * outside.gradient.normalized()) : Vec<D>(-0.4 * h2 * push);
      if (const double size = step[i].norm(); size > 0.1 && outside.filling <= 0.5) step[i] *= 0.1 / size;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      points[i] += step[i];
      for (auto& pair : near[i]) pair.r += step[i] - step[pair.j];
    }
  }
}

template <int D>
std::vector<WallSums<D>> FrozenFluid<D>::sums() const {
  std::vector<WallSums<D>> result(points.size());
  const auto near = pairs(kernel.reach());
  for (std::size_t i = 0; i < points.size(); ++i) {
    result[i].filling = kernel.value(0);
    for (const auto& [j, r] : near[i]) {
      const double length = r.norm(), slope = kernel.slope(length) / length;
      result[i].filling += kernel.value(length);
      result[i].gradient += slope * r;
      result[i].moment -= slope * r * r.transpose();
    }
  }
  return result;
}

template <int D>
std::vector<Mat<D>> FrozenFluid<D>::corrections(const Wall<D>& wall) const {
  const auto fluid = sums();
  std::vector<Mat<D>> B(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) B[i] = (fluid[i].moment + wall(points[i]).moment).inverse();
  return B;
}

template <int D>
std::vector<double> FrozenFluid<D>::friction(const Wall<D>& wall) const {
  const auto B = corrections(wall);
  std::vector<double> rate(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) rate[i] = wall(points[i]).friction.cwiseProduct(B[i]).sum();
  return rate;
}

template <int D>
std::vector<double> FrozenFluid<D>::steady_flow(const Wall<D>& wall) const {
  const auto B = corrections(wall);
  const auto diagonal = friction(wall);
  const auto near = pairs(kernel.reach());
  std::vector<Eigen::Triplet<double>> entries;
  const int n = static_cast<int>(points.size());
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, diagonal[i]);
    for (const auto& [j, r] : near[i]) {
      const double length = r.norm();
      const double g = 0.5 * r.dot((B[i] + B[j]) * r) / (length * length);
      const double weight = -2.0 * g * kernel.slope(length) / length;
      entries.emplace_back(i, i, weight);
      entries.emplace_back(i, j, -weight);
    }
  }
  Eigen::SparseMatrix<double> matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
  const Eigen::VectorXd u = solver.solve(Eigen::VectorXd::Ones(n));
  return {u.data(), u.data() + n};
}

template struct FrozenFluid<2>;
template struct FrozenFluid<3>;

}  // namespace ostium::sph3d
