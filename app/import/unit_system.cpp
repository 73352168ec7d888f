#include "app/import/unit_system.hpp"

#include "core/did_you_mean.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace ostium::app {

const std::vector<UnitSystem>& UnitSystem::all() {
  static const std::vector<UnitSystem> systems{
      {"cgs", "dyn/cm2", "cm3", "cm3/s", "dyn.s/cm5", "cm5/dyn", "dyn.s2/cm5", "dyn.s2/cm8", "dyn/cm5",
       "cm2/dyn", "1/cm3"},
      {"mmHg", "mmHg", "mL", "mL/s", "mmHg.s/mL", "mL/mmHg", "mmHg.s2/mL", "mmHg.s2/mL2", "mmHg/mL", "1/mmHg",
       "1/mL"},
      {"SI", "Pa", "m3", "m3/s", "Pa.s/m3", "m3/Pa", "Pa.s2/m3", "Pa.s2/m6", "Pa/m3", "1/Pa", "1/m3"}};
  return systems;
}

const UnitSystem& UnitSystem::of(const std::string& name) {
  std::vector<std::string> names;
  for (const auto& system : all()) {
    if (system.name == name) return system;
    names.push_back(system.name);
  }
  user_error("--units {}: there is no such system of units{}", name, did_you_mean(name, names));
}

double UnitSystem::si(const std::string& unit) {
  if (unit.empty()) return 1;
  check_unit(unit);
  for (const char* si :
       {"Pa", "m3/s", "m3", "m", "m/s", "s", "Pa.s/m3", "m3/Pa", "Pa.s2/m3", "Pa.s2/m6", "Pa/m3"})
    if (same_dimension(unit, si)) return to_si(1, unit, si);
  user_error("the unit \"{}\" is none of pressure, flow or volume", unit);
}

std::string UnitSystem::text(double value, const std::string& unit) {
  return unit.empty() ? shortest(value) : shortest(value) + " " + unit;
}

}  // namespace ostium::app
