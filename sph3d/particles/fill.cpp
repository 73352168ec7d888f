#include "sph3d/particles/fill.hpp"

#include <algorithm>
#include <cmath>

#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/particles/relax.hpp"
#include "sph3d/step/workspace.hpp"

namespace ostium::sph3d {

namespace {

/// Layers of an opening's slice at the middle of each layer, from the outer face to just inside the cap.
template <int D>
std::vector<Vec<D>> layers(const Duct<D>& duct, const Slice<D>& slice) {
  std::vector<Vec<D>> points;
  for (double s = 0.5 * slice.spacing; s < duct.length() + 0.25 * duct.spacing(); s += slice.spacing)
    for (const Vec<D>& site : slice.sites) points.push_back(duct.at_depth(site, s));
  return points;
}

template <int D>
bool in_layers(const Model<D>& model, const Vec<D>& x) {
  for (std::size_t k = 0; k < model.ducts.size(); ++k) {
    const Duct<D>& duct = model.ducts[k];
    const int count =
        static_cast<int>(std::ceil((duct.length() + 0.25 * duct.spacing()) / model.slices[k].spacing - 0.5));
    const double inner_face = count * model.slices[k].spacing;
    const double s = duct.depth(x);
    if (s < inner_face + 0.4 * duct.spacing() && s > -duct.spacing() &&
        duct.holds(duct.at_depth(x, 0.5 * duct.length())) && inside_outline(duct.opening(), x))
      return true;
  }
  return false;
}

/// Points of a cubic lattice of this spacing inside the domain and outside the layers, with their distance to the surface.
template <int D>
std::vector<std::pair<double, Vec<D>>> lattice(const Model<D>& model, const SignedDistance<D>& phi,
                                               double spacing) {
  Vec<D> lower = model.domain.surface.points.front(), upper = lower;
  for (const Vec<D>& p : model.domain.surface.points) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  std::array<std::int64_t, 3> n{1, 1, 1};
  Vec<D> first;
  for (int d = 0; d < D; ++d) {
    n[d] = static_cast<std::int64_t>((upper[d] - lower[d]) / spacing) + 1;
    first[d] = 0.5 * (lower[d] + upper[d] - static_cast<double>(n[d] - 1) * spacing);
  }
  std::vector<std::vector<std::pair<double, Vec<D>>>> found(n[D - 1]);
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t layer = 0; layer < n[D - 1]; ++layer) {
    const std::int64_t size = D == 3 ? n[0] * n[1] : n[0];
    for (std::int64_t k = 0; k < size; ++k) {
      Vec<D> x = first;
      x[0] += spacing * static_cast<double>(k % n[0]);
      x[D - 1] += spacing * static_cast<double>(layer);
      if constexpr (D == 3) x[1] += spacing * static_cast<double>(k / n[0]);
      const double distance = phi(x).phi;
      if (distance < -0.25 * model.options.dp && !in_layers(model, x)) found[layer].emplace_back(distance, x);
    }
  }
  std::vector<std::pair<double, Vec<D>>> all;
  for (auto& layer : found) all.insert(all.end(), layer.begin(), layer.end());
  return all;
}

/// Exactly `wanted` points of the widest lattice that has as many: those nearest to the surface are left out.
template <int D>
std::vector<Vec<D>> inner_points(const Model<D>& model, std::size_t wanted) {
  const SignedDistance<D> phi(model.domain.surface);
  std::vector<std::pair<double, Vec<D>>> found;
  double spacing = model.options.dp;
  for (int attempt = 0; attempt < 50 && wanted > 0; ++attempt) {
    found = lattice(model, phi, spacing);
    if (found.size() >= wanted) break;
    const double share = std::max(static_cast<double>(found.size()), 1.0) / static_cast<double>(wanted);
    spacing *= std::clamp(std::pow(share, 1.0 / D), 0.7, 0.998);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  found.resize(std::min(found.size(), wanted));
  std::vector<Vec<D>> points;
  for (const auto& [distance, x] : found) points.push_back(x);
  return points;
}

/// The strain of the lattice goes more slowly in the plane: after 200 iterations 1 % of disorder, after 1000 0.5 %.
template <int D>
constexpr int default_iterations = D == 2 ? 1000 : 200;

/// Walls and outer faces together.
template <int D>
WallSample<D> outside(const Model<D>& model, const Vec<D>& x) {
  WallSample<D> sample = model.wall(x);
  for (std::size_t k = 0; k < model.ducts.size(); ++k)
    if (model.ducts[k].holds(x)) {
      const WallSample<D> beyond = beyond_face(model, static_cast<int>(k), x, sample);
      sample.filling += beyond.filling;
      sample.flux += beyond.flux;
    }
  return sample;
}

}  // namespace

template <int D>
FluidState<D> fill(const Model<D>& model, const FillOptions& options) {
  std::vector<Vec<D>> points;
  for (std::size_t k = 0; k < model.ducts.size(); ++k) {
    const auto some = layers(model.ducts[k], model.slices[k]);
    points.insert(points.end(), some.begin(), some.end());
  }
  const auto total = static_cast<std::size_t>(std::llround(model.domain.volume / model.particle_volume));
  const std::size_t fixed_count = points.size(), wanted = total > fixed_count ? total - fixed_count : 0;
  const std::vector<Vec<D>> inner = inner_points(model, wanted);
  points.insert(points.end(), inner.begin(), inner.end());
  std::vector<std::uint8_t> fixed(points.size(), 0);
  std::fill_n(fixed.begin(), fixed_count, 1);
  const int iterations = options.iterations > 0 ? options.iterations : default_iterations<D>;
  const auto report = [&](int iteration) {
    if (options.progress) options.progress((iteration + 1.0) / iterations);
  };
  relax<D>(points, fixed,
           {.outside = [&](const Vec<D>& x) { return outside(model, x); },
            .kernel = model.kernel,
            .volume = model.particle_volume,
            .iterations = iterations,
            .progress = report});
  return fluid_at<D>(points, model.particle_volume);
}

template FluidState<2> fill<2>(const Model<2>&, const FillOptions&);
template FluidState<3> fill<3>(const Model<3>&, const FillOptions&);

}  // namespace ostium::sph3d
