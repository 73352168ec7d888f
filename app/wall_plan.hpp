/// The particles of a wall that moves, before there is blood: those of a shell or those of a solid.
#pragma once
#include <variant>

#include "sph3d/shell/generate.hpp"
#include "sph3d/solid/solid_wall.hpp"

namespace ostium::app {

template <int D>
using WallPlan = std::variant<sph3d::WallShell<D>, sph3d::WallCloud<D>>;

template <int D>
bool is_solid(const WallPlan<D>& plan) {
  return std::holds_alternative<sph3d::WallCloud<D>>(plan);
}

template <int D>
std::size_t particles_of(const WallPlan<D>& plan) {
  if (const auto* solid = std::get_if<sph3d::WallCloud<D>>(&plan)) return solid->solid.count();
  return std::get<sph3d::WallShell<D>>(plan).count();
}

}  // namespace ostium::app
