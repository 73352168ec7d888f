#include "sph3d/step/model.hpp"

#include <cmath>

#include "core/error.hpp"

namespace ostium::sph3d {

namespace {

template <int D>
std::vector<Duct<D>> ducts_of(const Lumen<D>& lumen, double dp) {
  std::vector<Duct<D>> ducts;
  for (const auto& opening : lumen.openings) ducts.emplace_back(opening, dp);
  return ducts;
}

/// With ducts long enough that their ends are out of reach.
template <int D>
Surface<D> endless(const Lumen<D>& lumen, const Wendland<D>& kernel, double dp) {
  return extended(lumen, Duct<D>::layers * dp + kernel.reach() + 4.0 * dp).surface;
}

template <int D>
WallField<D> wall_of(const Surface<D>& surface, const SignedDistance<D>& phi, const Wendland<D>& kernel,
                     double dp) {
  Vec<D> lower = surface.points.front(), upper = lower;
  for (const Vec<D>& p : surface.points) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  return WallField<D>([&](const Vec<D>& x) { return phi(x).phi; }, lower, upper, kernel, dp);
}

template <int D>
Vec<D> middle(const Lumen<D>& lumen) {
  Vec<D> lower = lumen.surface.points.front(), upper = lower;
  for (const Vec<D>& p : lumen.surface.points) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
  return 0.5 * (lower + upper);
}

}  // namespace

template <int D>
Model<D>::Model(const Lumen<D>& lumen_, const FluidOptions<D>& o, std::vector<OpeningRole> roles_)
    : options(o),
      lumen(lumen_),
      domain(extended(lumen_, Duct<D>::layers * o.dp)),
      kernel{1.3 * o.dp},
      half_space(kernel, o.dp, o.friction_limit),
      distance(endless(lumen_, kernel, o.dp)),
      wall(wall_of(endless(lumen_, kernel, o.dp), distance, kernel, o.dp)),
      roles(std::move(roles_)),
      ducts(ducts_of(lumen_, o.dp)),
      origin(middle(lumen_)),
      particle_volume(std::pow(o.dp, D)),
      number_density(lattice_sum(kernel, o.dp)),
      settling_time(4.0 * length_between_openings(lumen_) / o.sound_speed) {
  OSTIUM_ASSERT(roles.size() == lumen.openings.size(), "{} roles, {} openings", roles.size(),
                lumen.openings.size());
  for (std::size_t k = 0; k < roles.size(); ++k) {
    slices.push_back(slice_of(lumen.openings[k], o.dp));
    shapes.emplace_back(roles[k].profile, lumen.openings[k]);
  }
}

template struct Model<2>;
template struct Model<3>;

}  // namespace ostium::sph3d
