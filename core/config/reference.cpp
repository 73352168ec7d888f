#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/config/info.hpp"

namespace ostium::config {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

std::string kind_of(const FieldInfo& f) {
  switch (f.kind) {
    case FieldKind::quantity:
      return f.unit;
    case FieldKind::unit:
      return "unit that converts to " + f.unit;
    case FieldKind::number:
      return "number";
    case FieldKind::integer:
      return "integer";
    case FieldKind::text:
      return "text";
    case FieldKind::flag:
      return "true, false";
    case FieldKind::choice:
      return fmt::format("{}", fmt::join(f.choices, ", "));
    case FieldKind::path:
      return "file";
    case FieldKind::quantities:
      return "list, " + f.unit;
    case FieldKind::texts:
      return "list of texts";
    case FieldKind::section:
      return "section";
    case FieldKind::sections:
      return "list of sections";
    case FieldKind::map:
      return "named sections";
    case FieldKind::waveform:
      return "waveform, " + f.unit;
    case FieldKind::raw:
      return "see text";
  }
  return {};
}

// The bounds of the integer type itself are of no interest.
std::string range_of(const FieldInfo& f) {
  Range range = f.range;
  if (range.low <= -2147483648.0) range.low = -Range::inf;
  if (range.high >= 2147483647.0) range.high = Range::inf;
  return range.text("");
}

std::string row(const FieldInfo& f) {
  const std::string fallback = !f.fallback.empty() ? "`" + f.fallback + "`" : f.required ? "required" : "";
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", f.name, escaped(kind_of(f)), escaped(range_of(f)),
                     escaped(fallback), escaped(f.doc));
}

std::string table(const Description& fields) {
  std::string text = "| key | unit or kind | range | default | meaning |\n|---|---|---|---|---|\n";
  for (const auto& f : fields) text += row(f);
  return text;
}

std::string nested(const Description& fields, const std::string& prefix) {
  std::string text;
  for (const auto& f : fields) {
    if (!f.inner || f.inner->empty()) continue;
    const std::string path = prefix + f.name + (f.kind == FieldKind::section ? "" : ".NAME");
    text +=
        fmt::format("\n### `{}`\n\n{}\n\n{}", path, f.doc, table(*f.inner)) + nested(*f.inner, path + ".");
  }
  return text;
}

}  // namespace

std::string reference_of(const Description& fields, const std::string& title) {
  return (title.empty() ? "" : "## " + title + "\n\n") + table(fields) + nested(fields, "");
}

}  // namespace ostium::config
