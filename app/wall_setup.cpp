#include "app/wall_setup.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/log.hpp"
#include "sph3d/geometry/surface_array.hpp"
#include "sph3d/shell/prestress.hpp"

namespace ostium::app {
namespace {

using namespace sph3d;

constexpr double usual_fibre_angle = 40 * pi / 180;  // rad

Material material_of(const MaterialCase& m) {
  const Moduli moduli = elastic(m.E, m.nu);
  switch (m.law) {
    case WallLaw::neo_hookean:
      return NeoHookean(moduli);
    case WallLaw::holzapfel:
      return holzapfel(moduli, {.k1 = *m.k1, .k2 = *m.k2, .kappa = m.kappa.value_or(0.0)});
    default:
      return SaintVenantKirchhoff(moduli);
  }
}

/// Values for every point of the surface, from the array of its file.
template <int D>
std::vector<double> array_of(const VesselCase& vessel, const Lumen<D>& lumen, const config::Node& where,
                             const std::string& name, double unit) {
  if constexpr (D == 2) {
    where.error("an outline in 2D has no arrays; let the value vary from an opening");
  } else {
    try {
      auto values = surface_array(*vessel.surface, name, *vessel.length_unit, lumen.surface);
      for (double& v : values) v *= unit;
      return values;
    } catch (const UserError& error) {
      where.at("array").error("{}", error.what());
    }
  }
}

template <Varies V, int D>
WallQuantity quantity_of(const VaryingCase<V>& v, const VesselCase& vessel, const Lumen<D>& lumen) {
  // lengths in the file are in its own unit
  const double unit = V == Varies::thickness ? vessel.length_unit.value_or(1.0) : 1.0;
  if (v.array) return array_of(vessel, lumen, v.origin, *v.array, unit);
  return FromOpening{*v.opening, *v.at_opening, *v.away, *v.length};
}

template <int D>
WallQuantity thickness_of(const VesselCase& vessel, const Lumen<D>& lumen) {
  if (vessel.wall.thickness) return *vessel.wall.thickness;
  return quantity_of(*vessel.wall.varying_thickness, vessel, lumen);
}

/// One that stands for all of them: by the mean where it varies in any way, away from the opening where it varies there only.
template <int D>
double typical(const WallQuantity& quantity, const Lumen<D>& lumen) {
  if (const auto* same = std::get_if<double>(&quantity)) return *same;
  if (const auto* from = std::get_if<FromOpening>(&quantity)) return from->away;
  double sum = 0;
  for (const double v : std::get<std::vector<double>>(quantity)) sum += v;
  return sum / static_cast<double>(lumen.surface.points.size());
}

ShellOptions shell_options(const VesselCase& vessel) {
  const WallCase& w = vessel.wall;
  ShellOptions options{.spacing = w.spacing.value_or(vessel.spacing),
                       .density = w.density.value_or(usual_wall_density),
                       .material = material_of(*w.material),
                       .gauss_points = w.gauss_points.value_or(3),
                       .viscosity = w.viscosity.value_or(0.0),
                       .face = -1};
  if (w.support) options.spring = w.support->spring, options.dashpot = w.support->dashpot;
  options.fibre_angle = w.material->fibre_angle.value_or(usual_fibre_angle);
  return options;
}

/// The wall answers the blood one acoustic step at a time: it has to be heavier than the blood that sound crosses meanwhile.
void check_exchange(const Case& study, const std::vector<double>& thickness) {
  constexpr double most = 2.0, smoothing_ratio = 1.3;
  const VesselCase& vessel = *study.vessel;
  const double thinnest = *std::min_element(thickness.begin(), thickness.end()),
               cfl = study.numerics.acoustic_cfl,
               blood = study.fluid.density * cfl * smoothing_ratio * vessel.spacing,
               mass = vessel.wall.density.value_or(usual_wall_density) * thinnest;
  if (blood <= most * mass) return;
  vessel.wall.origin.error(
      "the wall, {:.3g} mm thick, is too light for blood of this spacing: it weighs {:.3g} kg/m2, the blood "
      "that "
      "sound crosses in an acoustic step {:.3g} kg/m2, and more than twice as much is not stable; set "
      "vessel.spacing "
      "to {:.2g} mm or less, or numerics.acoustic_cfl to {:.2g}",
      1e3 * thinnest, mass, blood, 1e3 * vessel.spacing * most * mass / blood, cfl * most * mass / blood);
}

}  // namespace

double WallScales::effective_speed(double sound_speed) const {
  return 1.0 / std::sqrt(1.0 / (sound_speed * sound_speed) + 1.0 / (pulse_speed * pulse_speed));
}

template <int D>
WallScales wall_scales(const Case& study, const Lumen<D>& lumen) {
  if (D == 2 || !moves(study)) return {};
  const WallCase& w = study.vessel->wall;
  const double rho = study.fluid.density, radius = 2.0 * lumen.volume / lumen.wall_area;
  const double t = typical(thickness_of(*study.vessel, lumen), lumen);
  const double speed2 = elastic(w.material->E, w.material->nu).plate() * t / (2.0 * rho * radius);
  return {std::sqrt(speed2), lumen.volume / (rho * speed2)};
}

namespace {

template <int D>
WallShell<D> plan_shell(const VesselCase& vessel, const Lumen<D>& lumen) {
  const WallCase& w = vessel.wall;
  ShellWallOptions options{.spacing = w.spacing.value_or(vessel.spacing),
                           .fluid_spacing = vessel.spacing,
                           .thickness = thickness_of(vessel, lumen)};
  if (w.varying_stiffness) options.stiffness = quantity_of(*w.varying_stiffness, vessel, lumen);
  options.ends = w.ends.value_or(WallEnds::clamped);
  options.clamp_length = w.clamp_length.value_or(0.0);
  WallShell<D> shell = shell_of(lumen, options);
  for (const auto& warning : shell.warnings) log::warn("{}", warning);
  return shell;
}

double solid_spacing(const VesselCase& vessel) {
  return vessel.wall.spacing.value_or(std::min(vessel.spacing, 0.25 * *vessel.wall.thickness));
}

template <int D>
WallCloud<D> plan_solid(const VesselCase& vessel, const Lumen<D>& lumen) {
  return solid_of(lumen, {.spacing = solid_spacing(vessel),
                          .fluid_spacing = vessel.spacing,
                          .thickness = *vessel.wall.thickness,
                          .clamp_length = vessel.wall.clamp_length.value_or(0.0)});
}

}  // namespace

template <int D>
WallPlan<D> plan_wall(const Case& study, const Lumen<D>& lumen) {
  const VesselCase& vessel = *study.vessel;
  const bool solid = vessel.wall.model == WallModel::solid;
  WallPlan<D> plan;
  try {
    if (solid)
      plan = plan_solid(vessel, lumen);
    else
      plan = plan_shell(vessel, lumen);
  } catch (const UserError& error) {
    vessel.origin.at("wall").error("{}", error.what());
  }
  check_exchange(study, solid ? std::vector<double>{*vessel.wall.thickness}
                              : std::get<WallShell<D>>(plan).cloud.thickness);
  return plan;
}

namespace {

/// The stress that keeps the shape at the pressure of the image, less that of the tissue.
template <int D>
void carry(ShellModel<D>& shell, const WallCase& w, bool quiet) {
  const double pressure = w.prestress->pressure - w.outside_pressure.value_or(0.0);
  PrestressReport report;
  try {
    report = find_prestress(shell, pressure_load(shell, pressure));
  } catch (const NumericsError& error) {
    w.origin.at("prestress").error("{}", error.what());
  }
  if (quiet || report.iterations == 0) return;
  log::info(
      "the wall carries {:.4g} Pa in the shape of the image; free of stress it would have moved up to {:.3g} "
      "mm",
      pressure, 1e3 * report.displacement);
}

template <int D>
ShellBody<D> body_of(const Case& study, const WallShell<D>& plan, bool quiet) {
  const VesselCase& vessel = *study.vessel;
  ShellModel<D> shell(plan.cloud, shell_options(vessel));
  if (vessel.wall.prestress) carry(shell, vessel.wall, quiet);
  return {std::move(shell), plan.contact};
}

/// The viscosity of the wall's own is added to that of the numerics.
template <int D>
SolidBody<D> body_of(const Case& study, const WallCloud<D>& plan, bool) {
  const WallCase& w = study.vessel->wall;
  SolidOptions options{.material = material_of(*w.material),
                       .density = w.density.value_or(usual_wall_density),
                       .spacing = solid_spacing(*study.vessel)};
  const double c = wave_speed(elastic(w.material->E, w.material->nu).plate(), options.density);
  options.damping += 2.0 * w.viscosity.value_or(0.0) / (options.density * c * options.spacing);
  return {plan, options};
}

}  // namespace

template <int D>
std::unique_ptr<DeformableWall<D>> make_wall(const Case& study, const WallPlan<D>& plan,
                                             const Model<D>& model, double ramp, bool quiet) {
  const WallCase& w = study.vessel->wall;
  SurroundingsOfWall around{.outside_pressure = w.outside_pressure.value_or(0.0), .ramp = ramp};
  around.rest_pressure = w.prestress ? w.prestress->pressure : around.outside_pressure;
  WallBody<D> body = std::visit([&](const auto& p) -> WallBody<D> { return body_of(study, p, quiet); }, plan);
  return std::make_unique<DeformableWall<D>>(std::move(body), model.reach(), around);
}

template <int D>
std::string wall_text(const WallScales& scales, double sound_speed, const DeformableWall<D>& wall) {
  std::string text = std::visit(
      [](const auto& body) {
        const auto& o = body.model().options;
        const bool shell = std::is_same_v<std::decay_t<decltype(body)>, ShellBody<D>>;
        return fmt::format("the wall moves: {} {} particles of {:.3g} mm, {}", body.model().count(),
                           shell ? "shell" : "solid", 1e3 * o.spacing,
                           std::visit([](const auto& law) { return law.name; }, o.material));
      },
      wall.body());
  if (scales.pulse_speed <= 0) return text;
  const double ratio = scales.effective_speed(sound_speed) / scales.pulse_speed,
               fluid = scales.compliance * std::pow(scales.pulse_speed / sound_speed, 2);
  text += fmt::format(
      "; its pulse wave runs at {:.3g} m/s and with this blood at {:.3g} m/s, {:.1f} % slower; it stores "
      "{:.3g} m3/Pa, the "
      "compressible blood {:.2g} of that",
      scales.pulse_speed, ratio * scales.pulse_speed, 100 * (1 - ratio), scales.compliance,
      fluid / scales.compliance);
  if (sound_speed < 0.99 * sound_over_pulse * scales.pulse_speed)
    log::warn(
        "the sound speed of {:.3g} m/s makes pulse waves {:.0f} % slower than they are; with {:.3g} m/s it "
        "is 5 %",
        sound_speed, 100 * (1 - ratio), sound_over_pulse * scales.pulse_speed);
  return text;
}

template WallScales wall_scales(const Case&, const Lumen<2>&);
template WallScales wall_scales(const Case&, const Lumen<3>&);
template WallPlan<2> plan_wall(const Case&, const Lumen<2>&);
template WallPlan<3> plan_wall(const Case&, const Lumen<3>&);
template std::unique_ptr<DeformableWall<2>> make_wall(const Case&, const WallPlan<2>&, const Model<2>&,
                                                      double, bool);
template std::unique_ptr<DeformableWall<3>> make_wall(const Case&, const WallPlan<3>&, const Model<3>&,
                                                      double, bool);
template std::string wall_text(const WallScales&, double, const DeformableWall<2>&);
template std::string wall_text(const WallScales&, double, const DeformableWall<3>&);

}  // namespace ostium::app
