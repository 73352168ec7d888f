#include "core/config/schema.hpp"

#include <cmath>

namespace ostium::config {
namespace {

using nlohmann::json;

json with_range(json s, const Range& range) {
  if (range.low > -Range::inf) s[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
  if (range.high < Range::inf) s[range.high_open ? "exclusiveMaximum" : "maximum"] = range.high;
  return s;
}

// A quantity is a text: a schema can see the number and that a unit follows, not its dimension.
json quantity_schema() {
  return {{"type", "string"}, {"pattern", R"(^\s*[-+]?[0-9.]+([eE][-+]?[0-9]+)?\s*[^\s0-9].*$)"}};
}

json waveform_schema() {
  const json text = {{"type", "string"}};
  json table = {{"type", "object"}};
  for (const char* key : {"file", "unit", "time_unit", "interpolation", "period", "start"})
    table["properties"][key] = text;
  return {{"anyOf", {quantity_schema(), table}}};
}

json any_of(json a, json b) { return {{"anyOf", {std::move(a), std::move(b)}}}; }

json schema_of(const FieldInfo& f) {
  switch (f.kind) {
    case FieldKind::quantity:
      return quantity_schema();
    case FieldKind::unit:
      return {{"type", "string"}};
    case FieldKind::number:
      return any_of(with_range({{"type", "number"}}, f.range), quantity_schema());
    case FieldKind::integer:
      return with_range({{"type", "integer"}}, f.range);
    case FieldKind::text:
    case FieldKind::path:
      return {{"type", {"string", "number"}}};
    case FieldKind::flag:
      return {{"type", "boolean"}};
    case FieldKind::choice:
      return {{"enum", f.choices}};
    case FieldKind::quantities:
      return any_of({{"type", "array"}, {"items", quantity_schema()}}, quantity_schema());
    case FieldKind::texts:
      return {{"type", "array"}, {"items", {{"type", "string"}}}};
    case FieldKind::section:
      return config::schema_of(*f.inner);
    case FieldKind::sections:
      return {{"type", "array"}, {"items", config::schema_of(*f.inner)}};
    case FieldKind::map:
      return {{"type", "object"}, {"additionalProperties", config::schema_of(*f.inner)}};
    case FieldKind::waveform:
      return waveform_schema();
    case FieldKind::raw:
      break;
  }
  return json::object();
}

std::string description_of(const FieldInfo& f) {
  const std::string unit = f.unit.empty() ? "" : fmt::format(" [{}]", f.unit);
  const std::string range =
      f.range.is_bounded() && f.kind == FieldKind::quantity ? "; " + f.range.text(f.unit) : "";
  return f.doc + unit + range;
}

}  // namespace

json schema_of(const Description& fields, const std::vector<std::string>& also_allowed) {
  json s = {{"type", "object"}, {"additionalProperties", false}, {"properties", json::object()}};
  for (const auto& f : fields) {
    json& property = s["properties"][f.name] = schema_of(f);
    property["description"] = description_of(f);
    if (!f.fallback.empty()) property["default"] = f.fallback;
    if (f.required) s["required"].push_back(f.name);
  }
  for (const auto& name : also_allowed) s["properties"][name] = json::object();
  return s;
}

}  // namespace ostium::config
