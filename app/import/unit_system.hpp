/// The units a file without units is taken to be in.
///
///   cgs    dyn/cm2, cm3, s        vessels (density 1.06, viscosity 0.04)
///   mmHg   mmHg, mL, s            hearts
///   SI     Pa, m3, s
///
/// All other units follow: resistance = pressure.time/volume, compliance = volume/pressure, and so on.
#pragma once
#include <string>
#include <vector>

namespace ostium::app {

struct UnitSystem {
  std::string name, pressure, volume, flow, resistance, compliance, inertance, stenosis, elastance,
      per_pressure, per_volume;

  static const std::vector<UnitSystem>& all();
  /// Throws UserError for another name than those of `all`.
  static const UnitSystem& of(const std::string& name);
  /// Size of a unit of a network's quantities in SI; throws UserError where it is none.
  static double si(const std::string& unit);
  /// "1000 dyn.s/cm5": a value as a case file has it.
  static std::string text(double value, const std::string& unit);
};

}  // namespace ostium::app
