#include "sph3d/openings/renewal.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "sph3d/geometry/point_grid.hpp"
#include "sph3d/neighbours/order.hpp"

namespace ostium::sph3d {

namespace {

constexpr double window_start = 1.0,
                 window_end = 5.0;  // of the content, in particle spacings from the outer face
constexpr double brim = 0.75;       // depth to which the duct is kept filled, in layers

/// 1 near the outer face, 0 where the content is no longer looked at.
double window(double s, double dp) {
  const double x = std::clamp((s / dp - window_start) / (window_end - window_start), 0.0, 1.0);
  return 1.0 - x * x * x * (10.0 - 15.0 * x + 6.0 * x * x);
}

/// A site's say in what stands opposite to it at this distance over dp: nearly a Gaussian of width 0.6, zero from 1.7 on.
double weight_of(double distance2) {
  const double t = std::max(1.0 - distance2 / 2.88, 0.0), t2 = t * t, t4 = t2 * t2;
  return t4 * t4;
}

/// f(site, share) for the sites a particle at x belongs to; the shares add up to one.
template <int D, class F>
void for_sites(const Slice<D>& slice, const Duct<D>& duct, const Vec<D>& x, F&& f) {
  const Vec<D> on_slice = duct.at_depth(x, duct.length());
  const double scale = 1.0 / (duct.spacing() * duct.spacing());
  const auto& near = slice.near(on_slice);
  const auto weight = [&](std::int32_t a) {
    return weight_of(scale * (slice.sites[a] - on_slice).squaredNorm());
  };
  double sum = 0;
  for (const std::int32_t a : near) sum += weight(a);
  for (const std::int32_t a : near) {
    const double share = sum > 0.0 ? weight(a) / sum : 1.0 / static_cast<double>(near.size());
    if (share > 0.0) f(a, share);
  }
}

/// The depth of the duct that a particle takes up, in the part that is looked at.
template <int D>
double taken_by(const Model<D>& model, const VesselState<D>& state, int k, std::int32_t i) {
  return model.slices[k].spacing * window(model.ducts[k].depth(state.fluid.position[i]), model.options.dp) /
         std::max(0.5, 1.0 + state.fluid.psi(i));  // bounded also in a fluid that is blowing up
}

/// How deep the part that is looked at would be, were it empty.
template <int D>
double whole_depth(const Model<D>& model, int k) {
  return 0.5 * (window_start + window_end) * model.options.dp - brim * model.slices[k].spacing;
}

/// How much of the duct between the outer face and the fluid is empty, as a depth, summed over the sites.
template <int D>
double room(const Model<D>& model, const VesselState<D>& state, const Workspace<D>& work, int k) {
  double sum = whole_depth(model, k) * static_cast<double>(model.slices[k].sites.size());
  for (const auto& member : work.zones[k].members) sum -= taken_by(model, state, k, member.index);
  return sum;
}

/// The same for each site. In parallel by shares of fixed length, whose depths are added in their order.
template <int D>
std::vector<double> free_depth(const Model<D>& model, const VesselState<D>& state, const Workspace<D>& work,
                               int k) {
  constexpr std::size_t shares = 8;
  const Slice<D>& slice = model.slices[k];
  const auto& members = work.zones[k].members;
  std::vector<std::vector<double>> taken(shares, std::vector<double>(slice.sites.size()));
#pragma omp parallel for schedule(static)
  for (std::size_t part = 0; part < shares; ++part)
    for (std::size_t m = members.size() * part / shares; m < members.size() * (part + 1) / shares; ++m)
      if (const double depth = taken_by(model, state, k, members[m].index); depth > 0.0)
        for_sites(slice, model.ducts[k], state.fluid.position[members[m].index],
                  [&](std::int32_t a, double share) { taken[part][a] += share * depth; });
  std::vector<double> depth(slice.sites.size(), whole_depth(model, k));
  for (const auto& part : taken)
    for (std::size_t a = 0; a < depth.size(); ++a) depth[a] -= part[a];
  return depth;
}

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

/// The places of new particles: one for every layer's share of room, each at the site that is emptiest then.
template <int D>
std::vector<Vec<D>> places_of_arrivals(const Model<D>& model, VesselState<D>& state, const Workspace<D>& work,
                                       int k) {
  const Duct<D>& duct = model.ducts[k];
  const Slice<D>& slice = model.slices[k];
  std::vector<Vec<D>> places;
  double sum = room(model, state, work, k);
  if (sum <= 0.0) return places;
  std::vector<double> depth = free_depth(model, state, work, k);
  double& level = state.ports[k].insertion_level;
  while (sum > 0.0) {
    const auto emptiest = std::max_element(depth.begin(), depth.end());
    const double excess = *emptiest / slice.spacing - level;
    level += excess / static_cast<double>(depth.size());
    const double s = slice.spacing * std::clamp(brim + excess, 0.0, 2.0 * brim);
    places.push_back(duct.at_depth(slice.sites[emptiest - depth.begin()], s));
    for_sites(slice, duct, places.back(),
              [&](std::int32_t a, double share) { depth[a] -= share * slice.spacing; });
    sum -= slice.spacing;
  }
  return places;
}

/// The members of a zone near its outer face, to take means over them.
template <int D>
class NearFace {
 public:
  NearFace(const Model<D>& model, const FluidState<D>& fluid, const Zone<D>& zone, int k)
      : model_(model), fluid_(fluid), normal_(model.ducts[k].opening().normal) {
    for (const auto& member : zone.members)
      if (member.depth < model.reach() + 2.0 * model.options.dp) {
        index_.push_back(member.index);
        position_.push_back(fluid.position[member.index]);
      }
    grid_.emplace(position_, model.reach());
  }

  /// Kernel means: velocity along the normal, density deviation.
  std::pair<double, double> means(const Vec<D>& x) const {
    double weight = 1e-300, speed = 0, psi = 0;
    grid_->near(x, [&](int n, const Vec<D>& apart) {
      const double w = model_.kernel.value(apart.norm());
      weight += w;
      speed += w * fluid_.velocity(index_[n]).dot(normal_);
      psi += w * fluid_.psi(index_[n]);
    });
    return {speed / weight, psi / weight};
  }

 private:
  const Model<D>& model_;
  const FluidState<D>& fluid_;
  Vec<D> normal_;
  std::vector<std::int32_t> index_;
  std::vector<Vec<D>> position_;
  std::optional<PointGrid<D>> grid_;
};

/// New particles stand together in memory as they do in the duct.
template <int D>
void insert_arrivals(const Model<D>& model, VesselState<D>& state, Workspace<D>& work, int k) {
  const std::vector<Vec<D>> places = places_of_arrivals(model, state, work, k);
  if (places.empty()) return;
  const NearFace<D> neighbours(model, state.fluid, work.zones[k], k);
  const double c = model.options.sound_speed,
               face_psi = state.ports[k].face_pressure / (model.options.density * c * c);
  for (const std::int32_t n : bisection_order<D>(places)) {
    const Vec<D>& x = places[n];
    const auto [speed, psi] = neighbours.means(x);
    const std::size_t i = state.fluid.insert(x);
    work.duct_of.resize(state.fluid.places(), -1);  // it may stand in a new cluster
    work.duct_of[i] = static_cast<std::int8_t>(k);
    state.fluid.velocity(i, Vec<D>(speed * model.ducts[k].opening().normal));
    state.fluid.psi(i) = static_cast<float>(model.roles[k].flow_driven ? psi : face_psi);
    state.ports[k].inserted += state.fluid.volume;
    work.zones[k].members.push_back(
        {static_cast<std::int32_t>(i), static_cast<float>(model.ducts[k].depth(x)), 0.0f});
  }
}

}  // namespace

template <int D>
void count_ports(const Model<D>& model, VesselState<D>& state, Workspace<D>& work) {
  const double c = model.options.sound_speed;
  for (std::size_t k = 0; k < state.ports.size(); ++k) {
    const Duct<D>& duct = model.ducts[k];
    const Zone<D>& zone = work.zones[k];
    double crossed = 0, psi = 0;
    for (const auto& member : zone.members)
      crossed += duct.crossed(duct.depth(state.fluid.position[member.index]));
    for (const std::int32_t i : zone.before_cap) psi += state.fluid.psi(i);
    PortState& port = state.ports[k];
    port.counted = state.fluid.volume * crossed + port.deleted - port.inserted;
    if (!zone.before_cap.empty())
      port.cap_pressure = model.options.density * c * c * psi / static_cast<double>(zone.before_cap.size()) +
                          state.datum.reference;
    if (model.roles[k].flow_driven) port.pressure = port.cap_pressure;
  }
}

template <int D>
void renew_ports(const Model<D>& model, VesselState<D>& state, Workspace<D>& work) {
  find_zones(model, state.fluid, work);
  for (int k = 0; k < static_cast<int>(state.ports.size()); ++k) {
    remove_leavers(model, state, work, k);
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
