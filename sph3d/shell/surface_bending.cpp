#include "sph3d/shell/surface_bending.hpp"

#include <algorithm>
#include <cmath>

#include "sph3d/shell/weights.hpp"

namespace ostium::sph3d {

namespace {

constexpr double smoothing = 1.15;   // h over the spacing, that of the shell
constexpr int contact_passes = 2;    // bends a corner over two spacings
constexpr double wall_length = 0.5;  // over the thickness
constexpr double most_length = 1.5;  // of the averages that keep a wall from crossing itself

/// The inverse of M; a point that sees too little has no gradient.
template <int D>
Bending<D> inverse(const Bending<D>& M) {
  const Eigen::SelfAdjointEigenSolver<Bending<D>> eigen(M);
  auto values = eigen.eigenvalues();
  for (auto& v : values) v = v > 0.05 ? 1.0 / v : 0.0;
  return eigen.eigenvectors() * values.asDiagonal() * eigen.eigenvectors().transpose();
}

template <int D>
Bending<D> bending_at(const SurfacePoints<D>& p, const SurfacePairs<D>& pairs,
                      const std::vector<Vec<D>>& normal, const ReducedKernel<D>& kernel, std::size_t a) {
  const auto e = tangent_frame<D>(normal[a]);
  Bending<D> M = Bending<D>::Zero(), turn = Bending<D>::Zero();
  for (const auto [b, rim] : pairs.of(a)) {
    const Vec<D> apart = p.position[b] - p.position[a];
    const Eigen::Matrix<double, D - 1, 1> xi = e * apart, dn = e * (normal[b] - normal[a]);
    const double w = kernel.pull(apart.norm()) * p.area[b];
    M += w * xi * xi.transpose(), turn += w * dn * xi.transpose();
  }
  const Bending<D> S = turn * inverse<D>(M);
  return 0.5 * (S + S.transpose());
}

/// The marked ones and all that see them, over so many steps.
template <int D>
std::vector<char> grown(std::vector<char> marked, const SurfacePairs<D>& pairs, int steps) {
  for (; steps > 0; --steps) {
    const auto before = marked;
    for (std::size_t a = 0; a < before.size(); ++a)
      if (before[a])
        for (const auto [b, rim] : pairs.of(a)) marked[b] = 1;
  }
  return marked;
}

/// Averages on where the wall would cross itself, and more than a thickness around. `look`: where that may have changed.
template <int D>
void open_up(std::vector<Vec<D>>& normal, const SurfacePoints<D>& p, const SurfaceAverage<D>& average,
             const std::vector<double>& thickness, double spacing) {
  const ReducedKernel<D> kernel{smoothing * spacing};
  const double thickest = *std::max_element(thickness.begin(), thickness.end());
  const auto rounds = static_cast<int>(std::ceil(std::pow(most_length * thickest, 2) / average.variance()));
  const auto steps = 1 + static_cast<int>(std::ceil(thickest / kernel.reach()));
  std::vector<char> look(normal.size(), 1);
  for (int round = 0; round < rounds; ++round) {
    std::vector<char> tight(normal.size(), 0);
#pragma omp parallel for schedule(static)
    for (std::size_t a = 0; a < normal.size(); ++a)
      if (look[a]) {
        const double k = principal<D>(bending_at(p, average.pairs(), normal, kernel, a))[0];
        tight[a] = 1.0 + 0.5 * k * thickness[a] < least_opening;
      }
    if (std::none_of(tight.begin(), tight.end(), [](char t) { return t; })) return;
    const auto around = grown(tight, average.pairs(), steps);
    smooth(normal, average, std::vector<double>(around.begin(), around.end()), 1);
    look = grown(around, average.pairs(), 1);
  }
}

}  // namespace

template <int D>
std::vector<Vec<D>> contact_normals(const SurfacePoints<D>& p, const SurfaceAverage<D>& average) {
  auto normal = p.normal;
  smooth(normal, average, std::vector<double>(normal.size(), 1.0), contact_passes);
  return normal;
}

template <int D>
std::vector<Vec<D>> wall_normals(const SurfacePoints<D>& p, const SurfaceAverage<D>& average,
                                 const std::vector<Vec<D>>& contact_normal,
                                 const std::vector<double>& thickness, double spacing) {
  auto normal = contact_normal;
  std::vector<double> passes;  // beyond those of the contact normals
  for (const double t : thickness)
    passes.push_back(std::max(0.0, std::pow(wall_length * t, 2) / average.variance() - contact_passes));
  const int rows = static_cast<int>(std::ceil(*std::max_element(passes.begin(), passes.end())));
  for (double& share : passes) share /= std::max(rows, 1);
  smooth(normal, average, passes, rows);
  open_up(normal, p, average, thickness, spacing);
  return normal;
}

template <int D>
std::vector<Bending<D>> bending(const SurfacePoints<D>& p, const SurfacePairs<D>& pairs,
                                const std::vector<Vec<D>>& normal, double spacing) {
  const ReducedKernel<D> kernel{smoothing * spacing};
  std::vector<Bending<D>> S(normal.size());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < normal.size(); ++a) S[a] = bending_at(p, pairs, normal, kernel, a);
  return S;
}

#define OSTIUM_BENDING(D)                                                                                    \
  template std::vector<Vec<D>> contact_normals(const SurfacePoints<D>&, const SurfaceAverage<D>&);           \
  template std::vector<Vec<D>> wall_normals(const SurfacePoints<D>&, const SurfaceAverage<D>&,               \
                                            const std::vector<Vec<D>>&, const std::vector<double>&, double); \
  template std::vector<Bending<D>> bending(const SurfacePoints<D>&, const SurfacePairs<D>&,                  \
                                           const std::vector<Vec<D>>&, double);

OSTIUM_BENDING(2)
OSTIUM_BENDING(3)

}  // namespace ostium::sph3d
