#include "sph3d/openings/renewal.hpp"

#include <algorithm>
#include <cmath>

namespace ostium::sph3d {

namespace {

/// The fluid near the outer face, as an insertion sees it.
template <int D>
struct Neighbourhood {
  const Model<D>& model;
  const FluidState<D>& fluid;
  std::vector<Vec<D>> points;
  std::vector<std::int32_t> index;

  Neighbourhood(const Model<D>& m, const FluidState<D>& f, const Zone<D>& zone, double deepest)
      : model(m), fluid(f) {
    for (const auto& member : zone.members)
      if (member.depth < deepest && f.filled[member.index]) add(member.index);
  }
  void add(std::int32_t i) {
    points.push_back(fluid.position[i]);
    index.push_back(i);
  }

  /// Number density of a particle put at x, relative to the undisturbed fluid.
  double density(const Duct<D>& duct, const Vec<D>& x) const {
    double sum = model.kernel.value(0.0);
    for (const Vec<D>& p : points) {
      const double r2 = (p - x).squaredNorm();
      if (r2 < model.reach() * model.reach()) sum += model.kernel.value(std::sqrt(r2));
    }
    const double wall = model.wall(x).filling;
    const double beyond = model.half_space.filling(std::min(duct.depth(x), model.reach()));
    return (sum * model.particle_volume + wall + beyond * (1.0 - wall)) / model.number_density;
  }

  /// Means over the neighbours of x: velocity along n, density deviation.
  std::pair<double, double> means(const Vec<D>& x, const Vec<D>& n) const {
    double weight = 1e-300, speed = 0, psi = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const double w = model.kernel.value((points[k] - x).norm());
      weight += w;
      speed += w * fluid.velocity(index[k]).dot(n);
      psi += w * fluid.psi(index[k]);
    }
    return {speed / weight, psi / weight};
  }
};

template <int D>
void remove_leavers(const Model<D>& model, VesselState<D>& state, Workspace<D>& work, int k) {
  auto& members = work.zones[k].members;
  const auto kept = std::remove_if(members.begin(), members.end(), [&](const auto& member) {
    if (model.ducts[k].depth(state.fluid.position[member.index]) >= 0.0) return false;
    state.fluid.remove(member.index);
    state.ports[k].deleted += state.fluid.volume;
    return true;
  });
  members.erase(kept, members.end());
}

/// The depth between the site and `span` further in at which the density is `target`; it grows inward.
template <int D>
double fitting_depth(const Neighbourhood<D>& near, const Duct<D>& duct, const Vec<D>& site, double target) {
  double low = duct.depth(site), high = low + 0.35 * duct.spacing();
  if (near.density(duct, duct.at_depth(site, high)) < target) return high;
  for (int k = 0; k < 12; ++k) {
    const double middle = 0.5 * (low + high);
    (near.density(duct, duct.at_depth(site, middle)) < target ? low : high) = middle;
  }
  return low;
}

template <int D>
void insert(const Model<D>& model, VesselState<D>& state, Workspace<D>& work, int k, const Vec<D>& x,
            Neighbourhood<D>& near) {
  const Vec<D>& n = model.ducts[k].opening().normal;
  const auto [speed, psi] = near.means(x, n);
  const std::size_t i = state.fluid.insert(x);
  state.fluid.velocity(i, Vec<D>(speed * n));
  const double c = model.options.sound_speed;
  state.fluid.psi(i) = static_cast<float>(
      model.roles[k].flow_driven ? psi : state.ports[k].pressure / (model.options.density * c * c));
  state.ports[k].inserted += state.fluid.volume;
  work.zones[k].members.push_back(
      {static_cast<std::int32_t>(i), static_cast<float>(model.ducts[k].depth(x)), 0.0f});
  near.add(static_cast<std::int32_t>(i));
}

template <int D>
void insert_arrivals(const Model<D>& model, VesselState<D>& state, Workspace<D>& work, int k) {
  const Duct<D>& duct = model.ducts[k];
  const double first = 0.5 * model.slices[k].spacing;
  Neighbourhood<D> near(model, state.fluid, work.zones[k], first + 0.35 * duct.spacing() + model.reach());
  const double target = 1.0 + state.ports[k].density_trim;
  std::vector<std::pair<double, std::size_t>> open;
  for (std::size_t a = 0; a < model.slices[k].sites.size(); ++a) {
    const double density = near.density(duct, duct.at_depth(model.slices[k].sites[a], first));
    if (density < target) open.emplace_back(density, a);
  }
  std::sort(open.begin(), open.end());
  for (const auto& [density, a] : open) {
    const Vec<D> site = duct.at_depth(model.slices[k].sites[a], first);
    if (near.density(duct, site) >= target) continue;  // an earlier one has filled the place
    insert(model, state, work, k, duct.at_depth(site, fitting_depth(near, duct, site, target)), near);
  }
}

/// Mean number density in the part of the duct with full support, smoothly windowed, against that of the
/// fluid's mean pressure there; the insertion threshold follows with the time the fluid takes through the
/// duct.
template <int D>
void trim_density(const Model<D>& model, VesselState<D>& state, const Workspace<D>& work, int k) {
  const Duct<D>& duct = model.ducts[k];
  const double dp = duct.spacing(), low = dp, high = duct.length();
  double content = 0;
  for (const auto& member : work.zones[k].members) {
    const double u = (duct.depth(state.fluid.position[member.index]) - low) / (high - low);
    if (u > 0.0 && u < 1.0) content += state.fluid.volume * (1.0 - std::cos(2.0 * pi * u));
  }
  const double wanted = duct.opening().area * (high - low);
  state.ports[k].density_trim =
      std::clamp(state.ports[k].density_trim + 0.02 * (1.0 - content / wanted), -0.1, 0.1);
}

}  // namespace

template <int D>
void count_ports(const Model<D>& model, VesselState<D>& state, Workspace<D>& work) {
  const double c = model.options.sound_speed;
  for (std::size_t k = 0; k < state.ports.size(); ++k) {
    const Duct<D>& duct = model.ducts[k];
    double crossed = 0, pressure = 0;
    int near_cap = 0;
    for (const auto& member : work.zones[k].members) {
      const double s = duct.depth(state.fluid.position[member.index]);
      crossed += duct.crossed(s);
      if (s > duct.length() - 1.5 * duct.spacing()) pressure += state.fluid.psi(member.index), ++near_cap;
    }
    PortState& port = state.ports[k];
    port.counted = state.fluid.volume * crossed + port.deleted - port.inserted;
    if (near_cap > 0) port.cap_pressure = model.options.density * c * c * pressure / near_cap;
  }
}

template <int D>
void renew_ports(const Model<D>& model, VesselState<D>& state, Workspace<D>& work) {
  find_zones(model, state.fluid, work);
  for (int k = 0; k < static_cast<int>(state.ports.size()); ++k) {
    remove_leavers(model, state, work, k);
    trim_density(model, state, work, k);
    insert_arrivals(model, state, work, k);
  }
  count_ports(model, state, work);
}

#define OSTIUM_INSTANTIATE(D)                                                 \
  template void renew_ports(const Model<D>&, VesselState<D>&, Workspace<D>&); \
  template void count_ports(const Model<D>&, VesselState<D>&, Workspace<D>&);
OSTIUM_INSTANTIATE(2)
OSTIUM_INSTANTIATE(3)

}  // namespace ostium::sph3d
