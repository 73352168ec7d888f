/// What is declared of one field, as plain data: error texts, JSON schema and reference pages are made from
/// it.
#pragma once
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace ostium::config {

enum class FieldKind {
  quantity,
  unit,
  number,
  integer,
  text,
  flag,
  choice,
  path,
  quantities,
  texts,
  section,
  sections,
  map,
  waveform,
  raw
};

struct Range {
  static constexpr double inf = std::numeric_limits<double>::infinity();
  double low = -inf, high = inf;
  bool low_open = false, high_open = false;
  bool contains(double x) const;
  bool is_bounded() const { return low > -inf || high < inf; }
  /// "> 0 Pa", ">= 1 and < 3 m"; empty without bounds.
  std::string text(const std::string& unit) const;
};

struct FieldInfo;
using Description = std::vector<FieldInfo>;

struct FieldInfo {
  std::string name = {};
  FieldKind kind = FieldKind::text;
  std::string unit = {};  // SI, UDUNITS text; empty for numbers without dimension
  std::string doc = {};
  Range range = {};
  bool required = true;
  std::string fallback = {};  // the default as it would be written; empty: none
  std::vector<std::string> choices = {};
  std::size_t length = 0;                         // of `quantities`; 0: any
  std::shared_ptr<const Description> inner = {};  // of section, sections, map
};

/// Markdown tables of a description.
std::string reference_of(const Description& fields, const std::string& title);

}  // namespace ostium::config
