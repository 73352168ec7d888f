/// Conversion of values with units to SI, dimension-checked, on UDUNITS-2.
///
/// Units are written as UDUNITS-2 reads them: `mmHg`, `mL/s`, `L/min`, `mPa.s`, `Pa.s/m3`, `kg/m3`. Added
/// here because the library lacks them: `dyn` (1e-5 N), `deg`, `P` and `cP` (poise), `beat` (a count:
/// `beats/min` is 1/60 s-1). A quantity is a decimal number and its unit: `80 mmHg`. Reciprocals are
/// different dimensions (s is not Hz).
///
/// Not checked: whether the value makes sense (`MPa` where `mPa` was meant).
#pragma once
#include <string>

namespace ostium {

/// A number and the text of its unit as written; unit is empty for a bare number.
struct Measure {
  double value;
  std::string unit;
};

/// Splits "80 mmHg"; throws UserError when no finite decimal number stands in front.
Measure parse_measure(const std::string& text);

/// The whole text as one finite decimal number, independent of the locale; throws UserError.
double parse_number(const std::string& text);

/// value [unit] in the SI unit `si_unit`; throws UserError for an unknown unit or another dimension.
double to_si(double value, const std::string& unit, const std::string& si_unit);

/// "80 mmHg" in the SI unit `si_unit`; throws UserError, also when the unit is missing.
double quantity(const std::string& text, const std::string& si_unit);

/// Throws UserError with the nearest known unit when `unit` cannot be read.
void check_unit(const std::string& unit);

bool same_dimension(const std::string& a, const std::string& b);

/// Shortest decimal text that reads back to the same double: "0.66".
std::string shortest(double value);

}  // namespace ostium
