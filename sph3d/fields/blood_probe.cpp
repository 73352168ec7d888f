#include "sph3d/fields/blood_probe.hpp"

namespace ostium::sph3d {

namespace {

constexpr double least_filling = 0.1;  // at the tip of a corner of the vessel an eighth is filled
constexpr double least_sum = 0.05;     // of the corrected weights over the kernel's

template <int D>
struct Near {
  std::size_t particle;
  Vec<D> apart;  // from the place to the particle
  double weight;
};

template <int D>
std::vector<Near<D>> particles_near(const FluidState<D>& fluid, const Wendland<D>& kernel, const Vec<D>& x) {
  const double reach2 = kernel.reach() * kernel.reach();
  std::vector<Near<D>> near;
  for (std::size_t i = 0; i < fluid.places(); ++i) {
    const Vec<D> apart = fluid.position[i] - x;
    if (apart.squaredNorm() < reach2 && fluid.filled[i])
      near.push_back({i, apart, kernel.value(apart.norm())});
  }
  return near;
}

/// Kernels become weights.
template <int D>
void correct(std::vector<Near<D>>& near, double h) {
  double whole = 0;
  Vec<D> first = Vec<D>::Zero();
  Mat<D> second = Mat<D>::Zero();
  for (const auto& [i, apart, w] : near)
    whole += w, first += w * apart, second += w * apart * apart.transpose();
  second += 1e-9 * whole * h * h * Mat<D>::Identity();  // particles may stand in a line
  const Vec<D> a = second.ldlt().solve(first);
  const double sum = whole - a.dot(first);
  const bool good = sum > least_sum * whole;
  for (auto& [i, apart, w] : near) w *= good ? (1.0 - a.dot(apart)) / sum : 1.0 / whole;
}

}  // namespace

template <int D>
std::optional<BloodSample<D>> blood_at(const Vessel<D>& vessel, const Vec<D>& x) {
  const auto& fluid = vessel.state().fluid;
  const auto& o = vessel.model().options;
  auto near = particles_near(fluid, vessel.model().kernel, x);
  double filling = 0;
  for (const auto& n : near) filling += fluid.volume * n.weight;
  if (filling < least_filling) return {};
  correct<D>(near, vessel.model().kernel.h);
  BloodSample<D> sample{.pressure = vessel.state().datum.reference};
  for (const auto& [i, apart, w] : near) {
    sample.velocity += w * fluid.velocity(i);
    sample.pressure += w * o.density * o.sound_speed * o.sound_speed * fluid.psi(i);
  }
  return sample;
}

template std::optional<BloodSample<2>> blood_at(const Vessel<2>&, const Vec2&);
template std::optional<BloodSample<3>> blood_at(const Vessel<3>&, const Vec3&);

}  // namespace ostium::sph3d
