/// From the case to the wall that moves with the blood, and what its elasticity means for the run.
///
///   c_MK    m/s     E t / (2 rho R (1 - nu^2)), rooted: pulse wave in a tube that is held along its axis; R = 2 V / A
///   C_wall  m3/Pa   V / (rho c_MK^2): what the whole wall stores
///   c       m/s     sound speed of the fluid, 3 c_MK at least unless the case says otherwise
///   c_eff   m/s     1 / c_eff^2 = 1 / c^2 + 1 / c_MK^2: pulse wave as the run will have it
///
/// In 2D a wall resists by bending alone and has no such speed: zero, and no compliance. Source: docs/theory/walls.md, "Walls
/// that move". UserError with its place in the case: an array the surface has not, a wall too light for the explicit exchange.
#pragma once
#include <memory>

#include "app/case.hpp"
#include "app/wall_plan.hpp"
#include "sph3d/step/model.hpp"
#include "sph3d/walls/deformable_wall.hpp"

namespace ostium::app {

/// How many pulse wave speeds the sound speed is at least: the pulse wave is then 5 % slow.
inline constexpr double sound_over_pulse = 3;

inline constexpr double usual_wall_density = 1100;  // kg/m3

struct WallScales {
  double pulse_speed = 0, compliance = 0;  // m/s, m3/Pa; zero where the wall is rigid

  double effective_speed(double sound_speed) const;
};

template <int D>
WallScales wall_scales(const Case& study, const sph3d::Lumen<D>& lumen);

inline bool moves(const Case& study) { return study.vessel->wall.model != WallModel::rigid; }

/// The particles of the case's wall, with errors at their place in it.
template <int D>
WallPlan<D> plan_wall(const Case& study, const sph3d::Lumen<D>& lumen);

/// ramp: s, within which the first load comes.
template <int D>
std::unique_ptr<sph3d::DeformableWall<D>> make_wall(const Case& study, const WallPlan<D>& plan,
                                                    const sph3d::Model<D>& model, double ramp, bool quiet);

/// What the wall is, how fast its pulse wave runs and what it stores; some lines for the start of a run.
template <int D>
std::string wall_text(const WallScales& scales, double sound_speed, const sph3d::DeformableWall<D>& wall);

}  // namespace ostium::app
