#include <unistd.h>

#include <cmath>

#include "bench/bench.hpp"
#include "sph3d/geometry/generate.hpp"
#include "sph3d/geometry/read.hpp"
#include "sph3d/geometry/write_stl.hpp"

namespace ostium::bench {

namespace {

/// Through a file, as a user's vessel comes.
template <class Shape>
sph3d::Lumen<3> lumen_of(const Shape& shape) {
  const auto file =
      std::filesystem::temp_directory_path() / ("ostium-bench-" + std::to_string(getpid()) + ".stl");
  sph3d::write_stl(sph3d::generate(shape), file);
  auto lumen = sph3d::read_lumen({.file = file, .length_unit = 1e-3});
  std::filesystem::remove(file);
  return lumen;
}

}  // namespace

/// Four diameters long.
sph3d::Lumen<3> tube_of(double particles, double spacing) {
  const double radius = spacing * std::cbrt(particles / (8 * pi));
  return lumen_of(sph3d::TubeShape{.radius = radius, .length = 8 * radius});
}

sph3d::Lumen<3> engine_vessel(const Options& options, std::string& name) {
  if (options.surface.empty()) {
    name = "generated arch";
    return lumen_of(sph3d::ArchShape{});
  }
  name = options.surface.filename().string();
  return sph3d::read_lumen({.file = options.surface, .length_unit = options.length_unit});
}

}  // namespace ostium::bench
