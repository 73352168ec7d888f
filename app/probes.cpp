#include "app/probes.hpp"

#include "sph3d/geometry/nearest_on_wall.hpp"
#include "sph3d/geometry/signed_distance.hpp"

namespace ostium::app {
namespace {

constexpr double furthest_from_wall = 2.0;  // spacings

/// As it is written in a case.
template <int D>
std::string text_of(const Vec<D>& x) {
  std::string text;
  for (int d = 0; d < D; ++d) text += fmt::format("{}{:.6g} m", d ? ", " : "[", x[d] == 0 ? 0.0 : x[d]);
  return text + "]";
}

template <int D>
Vec<D> coordinates(const ProbeCase& probe) {
  if (probe.at.size() != D)
    probe.origin.at("at").error("expected {} coordinates, found {}", D, probe.at.size());
  return Eigen::Map<const Vec<D>>(probe.at.data());
}

template <int D>
Probe<D> on_wall(const std::string& name, const ProbeCase& probe, const sph3d::Lumen<D>& lumen,
                 double spacing) {
  const Vec<D> at = coordinates<D>(probe);
  const auto wall = sph3d::nearest_on_wall(lumen.surface, at);
  if (const double apart = (wall.point - at).norm(); apart > furthest_from_wall * spacing)
    probe.origin.at("at").error(
        "the probe is {:.4g} mm from the wall, at most {:.4g} mm are allowed, two spacings; the nearest "
        "point of "
        "the wall is {}; write that, or leave out \"on: wall\" for a probe in the blood",
        1e3 * apart, 1e3 * furthest_from_wall * spacing, text_of<D>(wall.point));
  return {name, true, wall.point, wall.normal};
}

template <int D>
Probe<D> in_blood(const std::string& name, const ProbeCase& probe, const sph3d::Lumen<D>& lumen,
                  const sph3d::SignedDistance<D>& distance) {
  const Vec<D> at = coordinates<D>(probe);
  if (const auto hit = distance(at); hit.phi > 0.0) {
    const int opening = lumen.surface.label[hit.facet];
    const auto wall = sph3d::nearest_on_wall(lumen.surface, at);
    probe.origin.at("at").error(
        "the probe lies outside the vessel{}, {:.4g} mm from the wall; the nearest point of the wall is {}; "
        "move "
        "the probe inside, or write \"on: wall\" for one that follows the wall",
        opening < 0 ? "" : ", beyond the opening \"" + lumen.openings[opening].name + "\"",
        1e3 * (wall.point - at).norm(), text_of<D>(wall.point));
  }
  return {name, false, at};
}

}  // namespace

template <int D>
std::vector<Probe<D>> probes_of(const Case& study, const sph3d::Lumen<D>& lumen) {
  std::vector<Probe<D>> probes;
  std::optional<sph3d::SignedDistance<D>> distance;
  for (const auto& [name, probe] : study.output.probes) {
    if (!probe.on_wall && !distance) distance.emplace(lumen.surface);
    probes.push_back(probe.on_wall ? on_wall(name, probe, lumen, study.vessel->spacing)
                                   : in_blood(name, probe, lumen, *distance));
  }
  return probes;
}

template <int D>
std::string place_of(const Probe<D>& probe) {
  return (probe.on_wall ? "on the wall at " : "in the blood at ") + text_of<D>(probe.at);
}

template std::vector<Probe<2>> probes_of(const Case&, const sph3d::Lumen<2>&);
template std::vector<Probe<3>> probes_of(const Case&, const sph3d::Lumen<3>&);
template std::string place_of(const Probe<2>&);
template std::string place_of(const Probe<3>&);

}  // namespace ostium::app
