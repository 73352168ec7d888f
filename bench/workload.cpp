#include "bench/workload.hpp"

#include <cmath>

#include "sph3d/geometry/generate.hpp"
#include "sph3d/geometry/read.hpp"
#include "sph3d/geometry/write_stl.hpp"

namespace ostium::bench {
namespace {

constexpr double speed = 0.8;  // m/s, mean at the inlet

sph3d::Vessel<3> flowing(const sph3d::Lumen<3>& lumen, double dp) {
  std::vector<sph3d::OpeningRole> roles(lumen.openings.size());
  std::size_t inlet = 0;
  for (std::size_t k = 1; k < roles.size(); ++k)
    if (lumen.openings[k].area > lumen.openings[inlet].area) inlet = k;
  roles[inlet].flow_driven = true;
  const double c = 25;
  sph3d::Vessel<3> vessel(lumen,
                          {.dp = dp,
                           .density = 1060,
                           .viscosity = 3.8e-6,
                           .sound_speed = c,
                           .reference_speed = 1.25,
                           .density_relaxation = 0.2},
                          roles, 3000.0);
  const auto drives = drives_of(vessel);
  for (int k = 0; k < 100; ++k) vessel.advance(1, drives, 0.01);
  return vessel;
}

sph3d::Vessel<3> flowing(const sph3d::Surface<3>& surface, double dp) {
  const auto file = std::filesystem::temp_directory_path() / "ostium-bench.stl";
  sph3d::write_stl(surface, file);
  const auto lumen = sph3d::read_lumen({.file = file, .length_unit = 1e-3});
  std::filesystem::remove(file);
  return flowing(lumen, dp);
}

}  // namespace

std::vector<sph3d::Drive> drives_of(const sph3d::Vessel<3>& vessel) {
  const auto& model = vessel.model();
  std::vector<sph3d::Drive> drives(model.ducts.size());
  for (std::size_t k = 0; k < drives.size(); ++k) {
    if (model.roles[k].flow_driven)
      drives[k].flow_in = speed * model.ducts[k].opening().area;
    else
      drives[k].law = {.p_star = 3000, .resistance = 1060 * 25 / model.ducts[k].opening().area};
  }
  return drives;
}

sph3d::Vessel<3> flowing_tube(int particles) {
  const double dp = 1e-3, radius = 10 * dp;
  return flowing(generate(sph3d::TubeShape{.radius = radius,
                                           .length = particles * dp * dp * dp / (pi * radius * radius)}),
                 dp);
}

sph3d::Vessel<3> flowing_aorta(const std::filesystem::path& surface) {
  return flowing(sph3d::read_lumen({.file = surface, .length_unit = 1e-2}), 1e-3);
}

sph3d::Vessel<3> flowing_arch() { return flowing(generate(sph3d::ArchShape{}), 1e-3); }

}  // namespace ostium::bench
