#include "plane_poiseuille.hpp"

#include "sph3d/fields/wall_loads.hpp"
#include "vessels.hpp"

namespace ostium::sph3d {

Poiseuille plane_poiseuille(int across, double end, const MakeChannelWall& make_wall) {
  const double d = 1e-3, length = 4e-3, rho = 1000, eta = 2.5e-4, u_max = 0.0125, c = 40 * u_max;
  Vessel<2> vessel(channel(length, d),
                   {.dp = d / across,
                    .density = rho,
                    .viscosity = eta / rho,
                    .sound_speed = c,
                    .reference_speed = u_max,
                    .density_relaxation = 0.2},
                   {{true, Profile::parabolic}, {}}, 0.05);
  if (make_wall) vessel.set_wall(make_wall(length, d, d / across, vessel.model().reach()));
  WallSampler<2> sampler(vessel);
  const auto& wall = sampler.points();
  std::vector<Drive> drives(2);
  drives[1].law.p_star = 0.05;
  std::vector<double> sum(across, 0.0), count(across, 0.0), exact(across, 0.0);
  double stress = 0, samples = 0;
  while (vessel.time() < end) {
    drives[0].since = vessel.time();
    drives[0].flow_in = u_max * 2 / 3 * d * std::min(1.0, vessel.time() / (0.1 * end));
    vessel.advance(1, drives, 0.01);
    if (vessel.time() < 0.6 * end) continue;
    const auto& fluid = vessel.state().fluid;
    for (std::size_t i = 0; i < fluid.places(); ++i) {
      const Vec2& x = fluid.position[i];
      if (!fluid.filled[i] || std::abs(x[0] - 0.5 * length) > 0.25 * length) continue;
      const int row = std::clamp(static_cast<int>(x[1] / d * across), 0, across - 1);
      sum[row] += fluid.velocity(i)[0], ++count[row];
      exact[row] += 4 * u_max * x[1] * (d - x[1]) / (d * d);
    }
    sampler.sample(vessel);
    const auto& loads = sampler.loads();
    double force = 0, area = 0;
    for (std::size_t a = 0; a < wall.size(); ++a)
      if (std::abs(wall[a].position[0] - 0.5 * length) < 0.25 * length)
        force += loads.shear_stress[a][0] * wall[a].area, area += wall[a].area;
    stress += force / area, ++samples;
  }
  Poiseuille result;
  for (int row = 0; row < across; ++row)
    result.profile_error += std::pow((sum[row] - exact[row]) / count[row] / u_max, 2) / across;
  result.profile_error = std::sqrt(result.profile_error);
  double middle = 0, expected = 0;
  for (int row = 2 * across / 5; row < across - 2 * across / 5; ++row)
    middle += sum[row], expected += exact[row];
  result.peak_error = middle / expected - 1;
  result.shear_stress = stress / samples / (4 * eta * u_max / d);
  return result;
}

}  // namespace ostium::sph3d
