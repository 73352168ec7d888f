#include "app/measured.hpp"

#include "core/units.hpp"

namespace ostium::app {

double measured(const config::Node& place, const std::string& text, const std::string& unit) {
  try {
    return unit == "1" ? parse_number(text) : quantity(text, unit);
  } catch (const UserError& error) {
    place.error("{}", error.what());
  }
}

}  // namespace ostium::app
