#include "app/coupled_options.hpp"

#include <algorithm>

namespace ostium::app {

template <int D>
sph3d::FluidOptions<D> fluid_options(const Case& study, const FlowScales& scales) {
  const auto& n = study.numerics;
  return {.dp = study.vessel->spacing,
          .density = study.fluid.density,
          .viscosity = study.fluid.viscosity / study.fluid.density,
          .sound_speed = scales.sound_speed,
          .reference_speed = n.reference_speed.value_or(0.5 * scales.speed),
          .advection_cfl = n.advection_cfl,
          .acoustic_cfl = n.acoustic_cfl,
          .shift = n.shift,
          .limiter = n.limiter,
          .density_relaxation = n.density_relaxation};
}

namespace {

coupling::SchemeKind scheme_of(Scheme scheme) {
  switch (scheme) {
    case Scheme::held:
      return coupling::SchemeKind::held;
    case Scheme::extrapolated:
      return coupling::SchemeKind::extrapolated;
    case Scheme::modified_euler:
      return coupling::SchemeKind::modified_euler;
    default:
      return coupling::SchemeKind::linearised;
  }
}

}  // namespace

coupling::CoupledOptions coupled_options(const Case& study, const FlowScales& scales) {
  const double exchange = study.coupling.exchange.value_or(0.0);
  const auto& prestress = study.vessel->wall.prestress;
  return {.scheme = scheme_of(study.coupling.scheme),
          .exchange = exchange,
          .filter_time = study.coupling.filter_time.value_or(std::max(0.01, 5.0 * exchange)),
          .datum_time = scales.datum_time,
          .ramp = start_ramp(scales),
          .period = study.time.period.value_or(0.0),
          .background = scales.background,
          .start_pressure = prestress ? std::optional(prestress->pressure) : std::nullopt,
          .wall_compliance = scales.wall.compliance,
          .force = study.coupling.force};
}

template sph3d::FluidOptions<2> fluid_options(const Case&, const FlowScales&);
template sph3d::FluidOptions<3> fluid_options(const Case&, const FlowScales&);

}  // namespace ostium::app
