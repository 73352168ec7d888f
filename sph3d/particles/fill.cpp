#include "sph3d/particles/fill.hpp"

#include <algorithm>
#include <cmath>

#include "sph3d/geometry/signed_distance.hpp"
#include "sph3d/particles/relax.hpp"

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
    if (s < inner_face && s > -duct.spacing() && duct.holds(duct.at_depth(x, 0.5 * duct.length())) &&
        inside_outline(duct.opening(), x))
      return true;
  }
  return false;
}

/// Lattice points inside the domain and outside the layers, deepest first.
template <int D>
std::vector<Vec<D>> lattice(const Model<D>& model, std::size_t wanted) {
  const SignedDistance<D> phi(model.domain.surface);
  const double dp = model.options.dp;
  Vec<D> lower = model.domain.surface.points.front(), upper = lower;
  for (const Vec<D>& p : model.domain.surface.points) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  std::array<std::int64_t, 3> n{1, 1, 1};
  for (int d = 0; d < D; ++d) n[d] = static_cast<std::int64_t>((upper[d] - lower[d]) / dp) + 1;
  const Vec<D> first =
      0.5 * (lower + upper - Vec<D>::Constant(dp)) -
      0.5 * dp * Eigen::Map<Eigen::Array<std::int64_t, D, 1>>(n.data()).template cast<double>().matrix() +
      Vec<D>::Constant(dp);
  std::vector<std::vector<std::pair<double, Vec<D>>>> found(n[D - 1]);
#pragma omp parallel for schedule(dynamic)
  for (std::int64_t layer = 0; layer < n[D - 1]; ++layer) {
    const std::int64_t size = D == 3 ? n[0] * n[1] : n[0];
    for (std::int64_t k = 0; k < size; ++k) {
      Vec<D> x = first;
      x[0] += dp * static_cast<double>(k % n[0]);
      x[D - 1] += dp * static_cast<double>(layer);
      if constexpr (D == 3) x[1] += dp * static_cast<double>(k / n[0]);
      const double distance = phi(x).phi;
      if (distance < 0.0 && !in_layers(model, x)) found[layer].emplace_back(distance, x);
    }
  }
  std::vector<std::pair<double, Vec<D>>> all;
  for (auto& layer : found) all.insert(all.end(), layer.begin(), layer.end());
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  if (all.size() > wanted) all.resize(wanted);
  std::vector<Vec<D>> points;
  for (const auto& [distance, x] : all) points.push_back(x);
  return points;
}

/// Where the lattice has too few points, the missing ones go between it: beside points spread evenly over the
/// list.
template <int D>
void complete(std::vector<Vec<D>>& points, std::size_t wanted, double dp) {
  const std::size_t present = points.size();
  for (std::size_t k = 0; present + k < wanted && present > 0; ++k) {
    Vec<D> beside = points[(k * 7919) % present];
    beside[k % D] += 0.5 * dp;
    points.push_back(beside);
  }
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
  std::vector<Vec<D>> inner = lattice(model, wanted);
  complete(inner, wanted, model.options.dp);
  points.insert(points.end(), inner.begin(), inner.end());
  std::vector<std::uint8_t> fixed(points.size(), 0);
  std::fill_n(fixed.begin(), fixed_count, 1);
  const auto report = [&](int iteration) {
    if (options.progress) options.progress((iteration + 1.0) / options.iterations);
  };
  relax<D>(points, fixed,
           {.outside = [&](const Vec<D>& x) { return model.wall(x); },
            .kernel = model.kernel,
            .volume = model.particle_volume,
            .iterations = options.iterations,
            .progress = report});
  return fluid_at<D>(points, model.particle_volume);
}

template FluidState<2> fill<2>(const Model<2>&, const FillOptions&);
template FluidState<3> fill<3>(const Model<3>&, const FillOptions&);

}  // namespace ostium::sph3d
