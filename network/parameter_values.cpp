#include "network/parameter_values.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

#include "core/did_you_mean.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace ostium::network {
namespace {

using config::Node;
using config::Tree;
using config::TreePtr;

struct Measured {
  double value = 0;
  std::string unit = "1";
};

std::string joined(const std::string& a, const char* op, const std::string& b) {
  if (b == "1") return a;
  if (a == "1" && *op == '.') return b;
  return "(" + a + ")" + op + "(" + b + ")";
}

std::vector<std::string> names_of(const ParameterValues& parameters) {
  std::vector<std::string> names;
  for (const auto& [name, value] : parameters) names.push_back(name);
  return names;
}

const ParameterValue& parameter(const std::string& name, const Node& at, const ParameterValues& parameters) {
  const auto found = parameters.find(name);
  if (found == parameters.end())
    at.error("the subnetwork has no parameter \"{}\"{}", name, did_you_mean(name, names_of(parameters)));
  return found->second;
}

bool is_letter(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

/// sum := product {(+|-) product};  product := factor {(*|/) factor};  factor := number | $name | -factor | (sum)
class Expression {
 public:
  Expression(const Node& at, const ParameterValues& parameters)
      : at_(at), parameters_(parameters), text_(at.text()) {}

  Measured value() {
    const Measured m = sum();
    if (next() != '\0') fail();
    return m;
  }

 private:
  char next() {
    while (i_ < text_.size() && text_[i_] == ' ') ++i_;
    return i_ < text_.size() ? text_[i_] : '\0';
  }

  Measured sum() {
    Measured a = product();
    for (char op = next(); op == '+' || op == '-'; op = next()) {
      ++i_;
      const Measured b = product();
      if (!same_dimension(a.unit, b.unit))
        at_.error("\"{}\" adds {} and {}, which are different things; both sides need one dimension",
                  shown(text_), a.unit, b.unit);
      a.value += (op == '+' ? 1 : -1) * to_si(b.value, b.unit, a.unit);
    }
    return a;
  }

  Measured product() {
    Measured a = factor();
    for (char op = next(); op == '*' || op == '/'; op = next()) {
      ++i_;
      const Measured b = factor();
      a = op == '*' ? Measured{a.value * b.value, joined(a.unit, ".", b.unit)}
                    : Measured{a.value / b.value, joined(a.unit, "/", b.unit)};
    }
    return a;
  }

  Measured factor() {
    constexpr int deepest = 100;
    if (++depth_ > deepest) fail();
    const Measured m = signed_or_bracketed();
    --depth_;
    return m;
  }

  Measured signed_or_bracketed() {
    const char c = next();
    if (c == '$') return ++i_, named();
    if (c == '-') {
      ++i_;
      const Measured m = factor();
      return {-m.value, m.unit};
    }
    if (c == '(') return bracket();
    return number();
  }

  Measured bracket() {
    ++i_;
    const Measured m = sum();
    if (next() != ')') fail();
    ++i_;
    return m;
  }

  Measured named() {
    const std::size_t begin = i_;
    while (i_ < text_.size() && is_letter(text_[i_])) ++i_;
    const auto& p = parameter(text_.substr(begin, i_ - begin), at_, parameters_);
    return {read(p), p.unit};
  }

  Measured number() {
    const char *begin = text_.data() + i_, *last = text_.data() + text_.size();
    double value = 0;
    const auto [end, status] = std::from_chars(begin, last, value);
    if (status != std::errc{} || !std::isfinite(value) || (end != last && is_letter(*end))) fail();
    i_ += static_cast<std::size_t>(end - begin);
    return {value, "1"};
  }

  [[noreturn]] void fail() const {
    at_.error(
        "\"{}\" cannot be read from its character {} on; expected parameters ($name), plain numbers, + - * / "
        "and brackets, for example \"0.1 * $R\"",
        shown(text_), i_ + 1);
  }

  const Node& at_;
  const ParameterValues& parameters_;
  const std::string& text_;
  std::size_t i_ = 0;
  int depth_ = 0;
};

bool is_bare(const std::string& text) {
  return text.size() > 1 && text[0] == '$' && std::all_of(text.begin() + 1, text.end(), is_letter);
}

TreePtr scalar(const Node& node, const ParameterValues& parameters) {
  if (node.text().find('$') == std::string::npos) return node.shared_tree();
  if (is_bare(node.text()))
    return parameter(node.text().substr(1), node, parameters)
        .node.grafted({}, " (for " + node.where() + ")")
        .value;
  const Measured m = Expression(node, parameters).value();
  return node.with_text(m.unit == "1" ? shortest(m.value) : shortest(m.value) + " " + m.unit).shared_tree();
}

TreePtr list(const Node& node, const ParameterValues& parameters) {
  Tree copy = node.tree();
  std::size_t i = 0;
  for (const auto& item : node.items()) copy.items[i++] = evaluated(item, parameters);
  return std::make_shared<Tree>(std::move(copy));
}

TreePtr map(const Node& node, const ParameterValues& parameters) {
  Tree copy = node.tree();
  std::size_t i = 0;
  for (const auto& [key, child] : node.entries()) {
    auto& entry = copy.entries[i++];
    entry.value = evaluated(child, parameters);
    if (entry.value->origin) entry.line = entry.value->line, entry.column = entry.value->column;
  }
  return std::make_shared<Tree>(std::move(copy));
}

}  // namespace

double read(const ParameterValue& value) {
  const config::FieldInfo info{.name = value.node.key(), .unit = value.unit == "1" ? "" : value.unit};
  return info.unit.empty() ? config::read_number(value.node, info) : config::read_quantity(value.node, info);
}

TreePtr evaluated(const Node& value, const ParameterValues& parameters) {
  switch (value.kind()) {
    case Tree::Kind::scalar:
      return scalar(value, parameters);
    case Tree::Kind::list:
      return list(value, parameters);
    case Tree::Kind::map:
      return map(value, parameters);
    case Tree::Kind::null:
      break;
  }
  return value.shared_tree();
}

}  // namespace ostium::network
