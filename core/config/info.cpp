#include "core/config/info.hpp"

#include <fmt/format.h>

#include "core/units.hpp"

namespace ostium::config {

bool Range::contains(double x) const {
  return (low_open ? x > low : x >= low) && (high_open ? x < high : x <= high);
}

std::string Range::text(const std::string& unit) const {
  const std::string suffix = unit.empty() ? "" : " " + unit;
  std::string text;
  if (low > -inf)
    text += fmt::format("{} {}{}", low_open ? ">" : ">=", shortest(low), high < inf ? "" : suffix);
  if (low > -inf && high < inf) text += " and ";
  if (high < inf) text += fmt::format("{} {}{}", high_open ? "<" : "<=", shortest(high), suffix);
  return text;
}

}  // namespace ostium::config
