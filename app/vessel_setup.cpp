#include "app/vessel_setup.hpp"

#include <algorithm>
#include <cmath>

#include "app/wall_setup.hpp"
#include "core/csv.hpp"
#include "core/log.hpp"
#include "sph3d/geometry/polygon.hpp"
#include "sph3d/geometry/read.hpp"

namespace ostium::app {
namespace {

using sph3d::Lumen;

sph3d::OpeningChoice choice_of(const std::string& name, const OpeningCase& o) {
  sph3d::OpeningChoice choice{
      .name = name, .largest = o.largest, .label = o.label, .where = o.origin.message("")};
  if (!o.nearest) return choice;
  if (o.nearest->size() != 3)
    o.origin.at("nearest").error("expected 3 coordinates, found {}", o.nearest->size());
  choice.nearest = Vec3((*o.nearest)[0], (*o.nearest)[1], (*o.nearest)[2]);
  return choice;
}

sph3d::OutlineOpening outline_opening(const std::string& name, const OpeningCase& o) {
  sph3d::OutlineOpening choice{.name = name, .edge = o.edge};
  if (o.largest || o.label) o.origin.error("an opening of a 2D outline is chosen by \"edge\" or \"nearest\"");
  if (!o.nearest) return choice;
  if (o.nearest->size() != 2)
    o.origin.at("nearest").error("expected 2 coordinates, found {}", o.nearest->size());
  choice.nearest = Vec2((*o.nearest)[0], (*o.nearest)[1]);
  return choice;
}

std::vector<Vec2> corners_of_file(const VesselCase& vessel, const config::Node& outline) {
  if (!vessel.length_unit)
    outline.error("a file of corners needs \"length_unit\"; add for example \"length_unit: mm\"");
  const Table table = read_table(config::read_path(outline, {}));
  if (table.columns.size() < 2) outline.error("the file needs two columns, x and y");
  std::vector<Vec2> corners;
  for (std::size_t i = 0; i < table.lines.size(); ++i)
    corners.push_back(*vessel.length_unit * Vec2(table.columns[0][i], table.columns[1][i]));
  return corners;
}

std::vector<Vec2> corners_of(const VesselCase& vessel) {
  const config::Node& outline = *vessel.outline;
  if (outline.is_scalar()) return corners_of_file(vessel, outline);
  std::vector<Vec2> corners;
  for (const auto& corner : outline.items()) {
    const auto xy = config::read_quantities(corner, {.unit = "m", .length = 2});
    corners.emplace_back(xy[0], xy[1]);
  }
  return corners;
}

config::Node spacing_node(const VesselCase& vessel) { return vessel.origin.at("spacing"); }

/// Widths are known no better: a circle of 96 sides is 0.05 % narrower than the one it stands for.
constexpr double width_tolerance = 1e-3;

/// Two significant digits, downwards, in mm: a spacing a user would write, and one that will not be warned of.
double round_down(double spacing) {
  const double unit = std::pow(10.0, std::floor(std::log10(spacing)) - 1);
  return unit * std::floor(spacing / unit * (1 + width_tolerance));
}

bool fewer(double across, double wanted) { return across < wanted * (1 - width_tolerance); }

/// Errors of the geometry know the surface, not the case: add where the case names it.
template <class Read>
auto at_key(const config::Node& origin, const char* key, Read read) {
  try {
    return read();
  } catch (const UserError& e) {
    if (std::string(e.what()).starts_with(origin.file() + ":")) throw;
    origin.at(key).error("{}", e.what());
  }
}

}  // namespace

template <>
Lumen<3> read_vessel<3>(const VesselCase& vessel) {
  sph3d::SurfaceOptions options{
      .file = *vessel.surface, .length_unit = *vessel.length_unit, .cap_open_ends = vessel.cap_open_ends};
  for (const auto& [name, o] : vessel.openings) options.openings.push_back(choice_of(name, o));
  return at_key(vessel.origin, "surface", [&] { return sph3d::read_lumen(options); });
}

template <>
Lumen<2> read_vessel<2>(const VesselCase& vessel) {
  std::vector<sph3d::OutlineOpening> choices;
  for (const auto& [name, o] : vessel.openings) choices.push_back(outline_opening(name, o));
  return at_key(vessel.origin, "outline", [&] { return sph3d::polygon_lumen(corners_of(vessel), choices); });
}

template <int D>
void check_spacing(const VesselCase& vessel, const Lumen<D>& lumen) {
  double narrowest = std::numeric_limits<double>::infinity();
  std::string name;
  for (const auto& opening : lumen.openings)
    if (const double w = sph3d::width(opening); w < narrowest) narrowest = w, name = opening.name;
  const double across = narrowest / vessel.spacing;
  const auto sentence = [&](double wanted) {
    return fmt::format(
        "the spacing of {:.4g} mm is {} for the narrowest opening \"{}\", {:.4g} mm wide: {:.1f} particles "
        "fit across, {} "
        "are needed; choose {} mm or less",
        1e3 * vessel.spacing, wanted < good_particles_across ? "too coarse" : "coarse", name, 1e3 * narrowest,
        across,
        wanted < good_particles_across ? fmt::format("at least {}", wanted)
                                       : fmt::format("{} or more for good flow", wanted),
        fmt::format("{:.2g}", round_down(1e3 * narrowest / wanted)));
  };
  if (fewer(across, least_particles_across))
    spacing_node(vessel).error("{}", sentence(least_particles_across));
  if (fewer(across, good_particles_across))
    log::warn("{}", spacing_node(vessel).message(sentence(good_particles_across)));
}

template <int D>
std::vector<network::Port> ports_of(const Lumen<D>& lumen) {
  std::vector<network::Port> ports;
  for (const auto& opening : lumen.openings) ports.push_back({opening.name, opening.area});
  return ports;
}

namespace {

sph3d::Profile profile_of(const VesselCase& vessel, const std::string& opening) {
  for (const auto& [name, o] : vessel.openings)
    if (name == opening) return o.profile;
  return sph3d::Profile::parabolic;
}

}  // namespace

template <int D>
Setup<D> set_up(const Case& study) {
  Setup<D> s;
  s.model = network::read_model(study.network.blocks);
  s.lumen = read_vessel<D>(*study.vessel);
  for (const auto& note : s.lumen.repairs) log::info("{}", note);
  check_spacing(*study.vessel, s.lumen);
  s.probes = probes_of(study, s.lumen);
  s.ports = ports_of(s.lumen);
  const network::Network network(s.model, s.ports);
  for (int k = 0; k < network.port_count(); ++k) s.kinds.push_back(network.kind(k));
  for (const auto& opening : s.lumen.openings) s.profiles.push_back(profile_of(*study.vessel, opening.name));
  if (moves(study)) s.wall = plan_wall(study, s.lumen);
  return s;
}

std::optional<network::Start> start_of(const Case& study, const network::Model& model,
                                       const std::vector<network::Port>& ports) {
  if (study.initial() != network::Initial::periodic) return {};
  if (!study.time.period)
    study.network.blocks.error(
        "a start from the periodic state needs \"time.period\"; add it, or choose \"initial: rest\"");
  return network::periodic_start(model, ports, *study.time.period);
}

template <int D>
double particle_count(const Case& study, const Lumen<D>& lumen) {
  return lumen.volume / std::pow(study.vessel->spacing, D);
}

template void check_spacing(const VesselCase&, const Lumen<2>&);
template void check_spacing(const VesselCase&, const Lumen<3>&);
template std::vector<network::Port> ports_of(const Lumen<2>&);
template std::vector<network::Port> ports_of(const Lumen<3>&);
template Setup<2> set_up(const Case&);
template Setup<3> set_up(const Case&);
template double particle_count(const Case&, const Lumen<2>&);
template double particle_count(const Case&, const Lumen<3>&);

}  // namespace ostium::app
