#include "bench/workload.hpp"

#include <unistd.h>

#include <cmath>

#include "sph3d/geometry/generate.hpp"
#include "sph3d/geometry/read.hpp"
#include "sph3d/geometry/write_stl.hpp"

namespace ostium::bench {

using namespace sph3d;

namespace {

constexpr double inflow_speed = 0.3;  // m/s, mean over the first opening

/// Through a file, as a user's vessel comes.
template <class Shape>
Lumen<3> lumen_of(const Shape& shape) {
  const auto file =
      std::filesystem::temp_directory_path() / ("ostium-bench-" + std::to_string(getpid()) + ".stl");
  write_stl(generate(shape), file);
  auto lumen = read_lumen({.file = file, .length_unit = 1e-3});
  std::filesystem::remove(file);
  return lumen;
}

}  // namespace

Lumen<3> tube_of(double particles, double spacing) {
  const double radius = spacing * std::cbrt(particles / (8 * pi));
  return lumen_of(TubeShape{.radius = radius, .length = 8 * radius});
}

Lumen<3> engine_vessel(const Options& options, std::string& name) {
  if (options.surface.empty()) {
    name = "generated arch";
    return lumen_of(ArchShape{});
  }
  name = options.surface.filename().string();
  return read_lumen({.file = options.surface, .length_unit = options.length_unit});
}

Vessel<3> flowing(const Lumen<3>& lumen, double spacing) {
  constexpr int start_steps = 16;
  const FluidOptions<3> fluid{.dp = spacing,
                              .density = 1060,
                              .viscosity = 3.8e-6,
                              .sound_speed = 10,
                              .reference_speed = 0.5,
                              .density_relaxation = 0.2};
  std::vector<OpeningRole> roles(lumen.openings.size());
  roles[0].flow_driven = true;
  Vessel<3> vessel(lumen, fluid, roles);
  const auto drives = drives_of(vessel);
  for (int k = 0; k < start_steps; ++k) vessel.advance(1.0, drives, 0.01);
  return vessel;
}

std::vector<Drive> drives_of(const Vessel<3>& vessel) {
  const Model<3>& model = vessel.model();
  std::vector<Drive> drives(model.ducts.size());
  drives[0].flow_in = inflow_speed * model.ducts[0].opening().area;
  for (std::size_t k = 1; k < drives.size(); ++k)
    drives[k].law.resistance =
        model.options.density * model.options.sound_speed / model.ducts[k].opening().area;
  return drives;
}

}  // namespace ostium::bench
