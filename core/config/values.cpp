#include "core/config/values.hpp"

#include <fmt/ranges.h>

#include <cmath>

#include "core/did_you_mean.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace ostium::config {
namespace {

/// Runs a conversion that knows nothing of positions and adds the position to its error.
template <class Convert>
auto at_position(const Node& node, Convert convert) -> decltype(convert()) {
  try {
    return convert();
  } catch (const UserError& e) {
    node.error("{}", e.what());
  }
}

/// " Pa"; nothing for a number without dimension.
std::string suffix(const FieldInfo& info) {
  return info.unit.empty() || info.unit == "1" ? "" : " " + info.unit;
}

/// The value as it stands in the file, and in SI where that is another one.
std::string value_of(double value, const Node& node, const FieldInfo& info) {
  const std::string unit = suffix(info), text = shown(node.text());
  return unit.empty() || text.ends_with(unit) ? text : fmt::format("{} ({}{})", text, shortest(value), unit);
}

/// Far beyond anything that flows, and near enough to 1 that products and quotients of some such stay numbers.
void check_size(double value, const Node& node, const FieldInfo& info) {
  constexpr double most = 1e30;
  if (value == 0 || (std::abs(value) <= most && std::abs(value) >= 1 / most)) return;
  node.error("{} cannot be; the size of a value is 0 or between {:g} and {:g}{}, look at its exponent",
             value_of(value, node, info), 1 / most, most, suffix(info));
}

void check_range(double value, const Node& node, const FieldInfo& info) {
  check_size(value, node, info);
  if (!info.range.contains(value))
    node.error("{} is not allowed; it must be {}", value_of(value, node, info),
               info.range.text(info.unit == "1" ? "" : info.unit));
}

std::string example_of(const FieldInfo& info) {
  return info.unit.empty() ? "a number" : fmt::format("a value with a unit of dimension {}", info.unit);
}

const std::string& value_text(const Node& node, const std::string& expected) {
  if (!node.is_scalar()) node.error("expected {}, found {}", expected, node.describe());
  return node.text();
}

std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> words;
  std::string word;
  for (char c : text + " ") {
    if (c != ' ' && c != '\t' && c != ',')
      word += c;
    else if (!word.empty())
      words.push_back(std::exchange(word, ""));
  }
  return words;
}

/// "1 2 3 mm"
std::vector<double> split_quantities(const std::string& text, const std::string& unit) {
  std::vector<std::string> words = words_of(text);
  if (words.empty()) user_error("expected values with a unit of dimension {}, found nothing", unit);
  const Measure last = parse_measure(
      words.size() > 1 && std::isalpha(static_cast<unsigned char>(words.back()[0])) ? "0 " + words.back()
                                                                                    : words.back());
  if (last.unit.empty() && unit != "1")
    user_error("expected a unit of dimension {0} behind the values \"{1}\"; write for example \"{1} {0}\"",
               unit, shown(text));
  if (std::isalpha(static_cast<unsigned char>(words.back()[0]))) words.pop_back();
  std::vector<double> values;
  for (const auto& word : words)
    values.push_back(to_si(parse_measure(word).value, last.unit.empty() ? "1" : last.unit, unit));
  return values;
}

}  // namespace

double read_quantity(const Node& node, const FieldInfo& info) {
  const std::string& text = value_text(node, example_of(info));
  const double value = at_position(node, [&] { return quantity(text, info.unit); });
  check_range(value, node, info);
  return value;
}

double read_unit(const Node& node, const FieldInfo& info) {
  const std::string& text = value_text(node, fmt::format("a unit that converts to {}", info.unit));
  const bool is_name = !text.empty() && std::string("+-.0123456789").find(text[0]) == std::string::npos;
  const double value =
      at_position(node, [&] { return is_name ? to_si(1.0, text, info.unit) : quantity(text, info.unit); });
  if (!(value > 0)) node.error("{} is not allowed; a unit must be > 0 {}", shown(text), info.unit);
  check_size(value, node, info);
  return value;
}

double read_number(const Node& node, const FieldInfo& info) {
  const std::string& text = value_text(node, "a number");
  const double value = at_position(node, [&] {
    const Measure m = parse_measure(text);
    return m.unit.empty() ? m.value : to_si(m.value, m.unit, "1");  // 5 % is a number, 5 mm is none
  });
  check_range(value, node, info);
  return value;
}

long read_integer(const Node& node, const FieldInfo& info) {
  const std::string& text = value_text(node, "a whole number");
  const double value = at_position(node, [&] { return parse_number(text); });
  if (value != std::floor(value)) node.error("expected a whole number, found {}", shown(text));
  check_range(value, node, info);
  return static_cast<long>(value);
}

std::string read_text(const Node& node, const FieldInfo&) { return value_text(node, "a text"); }

bool read_flag(const Node& node, const FieldInfo&) {
  const std::string& text = value_text(node, "true or false");
  if (text == "true" || text == "yes" || text == "on") return true;
  if (text == "false" || text == "no" || text == "off") return false;
  node.error("expected true or false, found \"{}\"", shown(text));
}

std::size_t read_choice(const Node& node, const FieldInfo& info) {
  const std::string& text = value_text(node, fmt::format("one of {}", fmt::join(info.choices, ", ")));
  for (std::size_t i = 0; i < info.choices.size(); ++i)
    if (info.choices[i] == text) return i;
  node.error("unknown choice \"{}\"{}", shown(text), did_you_mean(text, info.choices));
}

std::filesystem::path read_path(const Node& node, const FieldInfo&) {
  const std::filesystem::path path = value_text(node, "a file name");
  if (path.empty()) node.error("expected a file name, found an empty text");
  return path.is_absolute() ? path : (node.folder() / path).lexically_normal();
}

std::vector<double> read_quantities(const Node& node, const FieldInfo& info) {
  std::vector<double> values;
  if (node.is_scalar())
    values = at_position(node, [&] { return split_quantities(node.text(), info.unit); });
  else if (node.is_list())
    for (const Node& item : node.items())
      values.push_back(info.unit == "1" ? read_number(item, info) : read_quantity(item, info));
  else
    node.error("expected a list of values with units, found {}", node.describe());
  if (info.length && values.size() != info.length)
    node.error("expected {} values, found {}", info.length, values.size());
  for (double v : values) {
    const Node one = node.with_text(write_quantity(v, info.unit).text);
    check_range(v, one, info);
  }
  return values;
}

std::vector<std::string> read_texts(const Node& node, const FieldInfo& info) {
  std::vector<std::string> all;
  for (const Node& item : node.items()) all.push_back(read_text(item, info));
  return all;
}

Tree write_quantity(double value, const std::string& unit) {
  return Tree::scalar(unit.empty() || unit == "1" ? shortest(value) : shortest(value) + " " + unit);
}

Tree write_quantities(const std::vector<double>& values, const std::string& unit) {
  Tree list = Tree::list();
  for (double v : values) list.items.push_back(std::make_shared<Tree>(write_quantity(v, unit)));
  return list;
}

Tree write_texts(const std::vector<std::string>& texts) {
  Tree list = Tree::list();
  for (const auto& t : texts) list.items.push_back(std::make_shared<Tree>(Tree::scalar(t)));
  return list;
}

Tree write_path(const std::filesystem::path& path) {
  return Tree::scalar(path.empty() ? "" : std::filesystem::absolute(path).lexically_normal().string());
}

void missing_key(const Node& mapping, const FieldInfo& info) {
  const std::string unit = info.unit.empty() ? "" : fmt::format(" [{}]", info.unit);
  mapping.error("the key \"{}\" is missing: {}{}", info.name, info.doc, unit);
}

void require_mapping(const Node& node, const Description& fields) {
  if (node.is_map()) return;
  std::vector<std::string> names;
  for (const auto& f : fields) names.push_back(f.name);
  if (!node.is_null())
    node.error("expected a mapping with the keys {}; found {}", fmt::join(names, ", "), node.describe());
  if (node.path().empty() && !node.file().empty())
    node.error("this file is empty; expected a mapping with the keys {}", fmt::join(names, ", "));
}

}  // namespace ostium::config
