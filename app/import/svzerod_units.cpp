#include "app/import/svzerod_units.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/units.hpp"

namespace ostium::app::svzerod {
namespace {

struct Magnitudes {
  double pressure = 0, flow = 0, resistance = 0;
};

double largest(const std::vector<double>& values) {
  double most = 0;
  for (double v : values) most = std::max(most, std::abs(v));
  return most;
}

/// What the largest chamber would build up from its volume at the start.
double chamber_pressure(const Source& source) {
  double most = 0;
  for (const auto& part : source.parts)
    if (const auto E = part.values.find("Emax"))
      most = std::max(most, std::abs(E->number() * source.start("Vc:" + part.name)));
  return most;
}

/// Largest of what the file says of pressures and flows.
Magnitudes magnitudes(const Source& source) {
  Magnitudes m{.pressure = chamber_pressure(source)};
  for (const auto& part : source.parts) {
    const auto& v = part.values;
    if (v.find("Q")) m.flow = std::max(m.flow, largest(v.at("Q").numbers()));
    for (const char* key : {"P", "Pd", "Pim", "P_v"})
      if (v.find(key)) m.pressure = std::max(m.pressure, largest(v.at(key).numbers()));
    for (const char* key : {"R_poiseuille", "R", "Rd", "Rmin"})
      if (const auto r = v.find(key); r && !r->is_list())
        m.resistance = std::max(m.resistance, std::abs(r->number()));
  }
  for (const auto& [name, value] : source.initial) {
    if (name.starts_with("pressure")) m.pressure = std::max(m.pressure, std::abs(value));
    if (name.starts_with("flow")) m.flow = std::max(m.flow, std::abs(value));
  }
  if (m.flow == 0 && m.resistance > 0) m.flow = m.pressure / m.resistance;
  m.pressure = std::max(m.pressure, m.flow * m.resistance);
  return m;
}

/// Orders of magnitude from 100 mmHg and 100 mL/s.
double distance(const Magnitudes& m, const UnitSystem& u) {
  const auto orders = [](double value, double usual) {
    return value > 0 ? std::abs(std::log10(value / usual)) : 0;
  };
  return orders(to_si(m.pressure, u.pressure, "Pa"), 13332) + orders(to_si(m.flow, u.flow, "m3/s"), 1e-4);
}

std::optional<std::pair<std::string, std::string>> from_fluid(const Source& source) {
  const auto run = source.root.at("simulation_parameters");
  for (const char* key : {"density", "viscosity"})
    if (const auto given = run.find(key)) {
      const double v = given->number();
      const bool si = key[0] == 'd' ? v > 100 : v < 0.015;  // 1060 kg/m3, 0.004 Pa.s
      return {{si ? "SI" : "cgs", std::string(key) + " " + shortest(v)}};
    }
  return std::nullopt;
}

}  // namespace

std::pair<std::string, std::string> guess_units(const Source& source) {
  if (source.has("ClosedLoopHeartAndPulmonary"))
    return {"mmHg", "ClosedLoopHeartAndPulmonary is given in them"};
  if (source.has("ChamberSphere")) return {"SI", "ChamberSphere is given in them"};
  if (const auto found = from_fluid(source)) return *found;
  const Magnitudes m = magnitudes(source);
  const auto& all = UnitSystem::all();
  const auto best = std::min_element(all.begin(), all.end(), [&](const UnitSystem& a, const UnitSystem& b) {
    return distance(m, a) < distance(m, b);
  });
  return {best->name, "the magnitude of pressures and flows; say --units to choose others"};
}

}  // namespace ostium::app::svzerod
