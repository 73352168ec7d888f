#include "app/import/expression.hpp"

#include "core/units.hpp"

namespace ostium::app {

double Expression::value(const std::function<double(const std::string&)>& series) const {
  double sum = constant;
  for (const auto& [name, factor] : terms) sum += factor * series(name);
  return sum;
}

std::vector<std::string> Expression::texts() const {
  std::vector<std::string> all;
  for (const auto& [name, factor] : terms)
    all.push_back(factor == 1 ? name : shortest(factor) + " * " + name);
  if (constant != 0 || all.empty()) all.push_back(shortest(constant));
  return all;
}

Expression Expression::parse(const std::vector<std::string>& texts) {
  Expression sum;
  for (const auto& text : texts) {
    const auto star = text.find(" * ");
    const bool series = text.size() > 2 && text[1] == ':';
    if (series)
      sum += of(text);
    else if (star == std::string::npos)
      sum.constant += parse_number(text);
    else
      sum += of(text.substr(star + 3), parse_number(text.substr(0, star)));
  }
  return sum;
}

Expression& Expression::operator+=(const Expression& other) {
  for (const auto& [name, factor] : other.terms)
    if ((terms[name] += factor) == 0) terms.erase(name);
  constant += other.constant;
  return *this;
}

Expression operator*(double factor, Expression e) {
  for (auto& [name, f] : e.terms) f *= factor;
  e.constant *= factor;
  return e;
}

}  // namespace ostium::app
