#include "core/units.hpp"

#include <udunits2.h>

#include <charconv>
#include <cmath>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

#include "core/did_you_mean.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace ostium {
namespace {

// What people of this field write; offered when a unit is misspelt.
const std::vector<std::string> common_units = {
    "Pa",      "kPa",      "MPa",        "mmHg",       "cmH2O",     "dyn/cm2",    "m",     "cm",
    "mm",      "um",       "m2",         "cm2",        "mm2",       "m3",         "mL",    "L",
    "m3/s",    "mL/s",     "L/min",      "mL/min",     "cm3/s",     "mm3/s",      "m/s",   "cm/s",
    "mm/s",    "s",        "ms",         "min",        "1/s",       "Hz",         "kg/m3", "g/cm3",
    "g/mL",    "Pa.s",     "mPa.s",      "cP",         "P",         "m2/s",       "N",     "dyn",
    "kg",      "g",        "Pa.s/m3",    "dyn.s/cm5",  "mmHg.s/mL", "mmHg.min/L", "m3/Pa", "mL/mmHg",
    "cm5/dyn", "Pa.s2/m3", "dyn.s2/cm5", "mmHg.s2/mL", "beats/min", "rad",        "deg",   "1",
    "%",       "Pa/m",     "K",          "N/m"};

/// The table of units of the library with ours added; one for the whole program, guarded by `mutex`.
class UnitTable {
 public:
  UnitTable() {
    ut_set_error_message_handler(ut_ignore);
    system_ = ut_read_xml(nullptr);
    if (!system_)
      user_error("the unit table of UDUNITS-2 was not found; install the package libudunits2-data");
    add("dyn", "1e-5 N");
    add("P", "0.1 Pa.s");
    add("cP", "1e-3 Pa.s");
    add("deg", "arc_degree");
    add("beat", "1");
    add("beats", "1");
    add("bpm", "1/min");
  }

  ~UnitTable() {
    for (auto& entry : converters_) cv_free(entry.second);
    ut_free_system(system_);
  }

  ut_unit* parse(const std::string& text) {
    return is_plain(text) ? ut_parse(system_, text.c_str(), UT_UTF8) : nullptr;
  }

  cv_converter* converter(const std::string& from, const std::string& to) {
    const auto known = converters_.find({from, to});
    if (known != converters_.end()) return known->second;
    cv_converter* made = make_converter(from, to);
    if (made) converters_[{from, to}] = made;
    return made;
  }

  std::mutex mutex;

 private:
  /// The library also knows points of time (s since 2000-01-01, s @ 5) and logarithms (lg(re 1 Pa)); both are no units
  /// of a plain number.
  static bool is_plain(const std::string& unit) {
    constexpr std::size_t longest = 80;
    if (unit.size() > longest || first_bad_byte(unit) != std::string::npos) return false;
    for (const char* word :
         {"@", ":", "since", "SINCE", "after", "AFTER", "from", "FROM", "ref", "REF", "(re", "(RE"})
      if (unit.find(word) != std::string::npos) return false;
    return true;
  }

  void add(const char* name, const char* meaning) {
    ut_unit* unit = parse(meaning);
    ut_map_symbol_to_unit(name, UT_UTF8, unit);
    ut_free(unit);
  }

  cv_converter* make_converter(const std::string& from, const std::string& to) {
    ut_unit *a = parse(from), *b = parse(to);
    cv_converter* converter = a && b ? ut_get_converter(a, b) : nullptr;
    ut_free(a), ut_free(b);
    // The library also converts s to Hz by taking the reciprocal; for us these differ.
    if (converter && !std::isfinite(cv_convert_double(converter, 0.0)))
      cv_free(converter), converter = nullptr;
    return converter;
  }

  ut_system* system_;
  std::map<std::pair<std::string, std::string>, cv_converter*> converters_;
};

UnitTable& table() {
  static UnitTable units;
  return units;
}

bool is_known(const std::string& unit) {
  std::lock_guard lock(table().mutex);
  ut_unit* parsed = table().parse(unit);
  ut_free(parsed);
  return parsed != nullptr;
}

std::optional<double> conversion(double value, const std::string& unit, const std::string& si_unit) {
  std::lock_guard lock(table().mutex);
  cv_converter* converter = table().converter(unit, si_unit);
  return converter ? std::optional(cv_convert_double(converter, value)) : std::nullopt;
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

/// Digits after the number, a second sign or a comma mean that the number itself was cut short: 1.2.3, 9,81.
void check_number_ended(const std::string& text, const std::string& rest) {
  if (rest.empty() || rest[0] == ' ' || rest[0] == '\t') return;
  if (rest[0] == ',') user_error("\"{}\" is no number; write a decimal point, not a comma", shown(text));
  if (std::string(".+-_'").find(rest[0]) != std::string::npos)
    user_error("\"{}\" is no number with a unit", shown(text));
}

/// "80 90 mmHg" would be 80 times 90 mmHg, "1 000 Pa" nothing. A unit may begin as 1/s does.
void check_one_number(const std::string& text, const std::string& unit) {
  if (unit.empty() || unit[0] < '0' || unit[0] > '9') return;
  const auto next = unit.find_first_not_of(' ', 1);
  if (unit[0] == '1' && (next == std::string::npos || unit[next] == '/')) return;
  user_error("\"{}\" holds two numbers; write one number, without blanks in it, and its unit", shown(text));
}

std::string examples(const std::string& si_unit) {
  std::string list;
  for (const auto& unit : common_units)
    if (unit != si_unit && same_dimension(unit, si_unit)) list += (list.empty() ? "" : ", ") + unit;
  return list.empty() ? "" : ", such as " + list;
}

}  // namespace

Measure parse_measure(const std::string& text) {
  const std::string clean = trimmed(text);
  const char* begin = clean.data() + (clean.size() > 1 && clean[0] == '+' && clean[1] != '-');
  double value = 0;
  const auto [end, status] = std::from_chars(begin, clean.data() + clean.size(), value);
  if (status == std::errc::result_out_of_range)
    user_error("\"{}\" is too large or too small for a number", shown(text));
  if (status != std::errc{}) user_error("\"{}\" does not begin with a number", shown(text));
  const std::string rest(end, clean.data() + clean.size());
  check_number_ended(text, rest);
  if (!std::isfinite(value)) user_error("\"{}\" is not a finite number", shown(text));
  check_one_number(text, trimmed(rest));
  return {value, trimmed(rest)};
}

double parse_number(const std::string& text) {
  const Measure m = parse_measure(text);
  if (!m.unit.empty()) user_error("\"{}\" is not a plain number", shown(text));
  return m.value;
}

void check_unit(const std::string& unit) {
  if (!is_known(unit)) {
    const auto nearest = nearest_name(unit, common_units);
    user_error("unknown unit \"{}\"{}", shown(unit),
               nearest ? fmt::format("; did you mean \"{}\"?", *nearest) : "");
  }
}

bool same_dimension(const std::string& a, const std::string& b) {
  std::lock_guard lock(table().mutex);
  return table().converter(a, b) != nullptr;
}

double to_si(double value, const std::string& unit, const std::string& si_unit) {
  if (unit == si_unit) return value;
  if (const auto converted = conversion(value, unit, si_unit)) {
    if (std::isfinite(value) && !std::isfinite(*converted))
      user_error("{} {} is too large for a number", value, unit);
    return *converted;
  }
  check_unit(unit);
  user_error("the unit \"{}\" has the wrong dimension; expected a unit that converts to {}{}", shown(unit),
             si_unit, examples(si_unit));
}

double quantity(const std::string& text, const std::string& si_unit) {
  const Measure m = parse_measure(text);
  if (m.unit.empty())
    user_error(
        "expected a value with a unit of dimension {0}, found the bare number {1}; write for example \"{1} "
        "{0}\"",
        si_unit, shown(trimmed(text)));
  return to_si(m.value, m.unit, si_unit);
}

std::string shortest(double value) { return fmt::format("{}", value); }

}  // namespace ostium
