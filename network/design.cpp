#include "network/design.hpp"

#include <set>

#include "core/error.hpp"
#include "core/random.hpp"

namespace ostium::network {

namespace {

constexpr double most_rows = 1e12;  // beyond any computer, below what a double counts exactly

void check_parameters(const std::vector<Variation>& all) {
  if (all.empty()) user_error("a sweep needs at least one parameter");
  std::set<std::string> names;
  for (const auto& v : all)
    if (!names.insert(v.parameter.name).second)
      user_error("the parameter {} is given twice; leave one of the two out", v.parameter.name);
}

std::string sizes_text(const std::vector<Variation>& all) {
  std::string text;
  for (const auto& v : all) text += fmt::format("{}{}", text.empty() ? "" : " x ", v.values.size());
  return text;
}

}  // namespace

Design::Design(DesignOptions options) : options_(std::move(options)) {
  const auto& all = options_.parameters;
  check_parameters(all);
  const auto sampling = options_.sampling;
  if (sampling == Sampling::grid || sampling == Sampling::table)
    options_.count = sampling == Sampling::table ? static_cast<std::int64_t>(all[0].values.size()) : 1;
  double rows = static_cast<double>(options_.count);
  if (sampling == Sampling::saltelli) rows *= columns() + 2;
  if (sampling == Sampling::grid)
    for (const auto& v : all) rows *= static_cast<double>(v.values.size());
  if (rows > most_rows)
    user_error("the sweep has {:.2g} samples{}; choose fewer values, or `sample: latin_hypercube`", rows,
               sampling == Sampling::grid ? fmt::format(" ({})", sizes_text(all)) : "");
  rows_ = static_cast<std::int64_t>(rows);
  if (rows_ < 1) user_error("a sweep needs at least one sample, found a count of {}", options_.count);
  std::int64_t stride = rows_;
  if (sampling == Sampling::grid)
    for (const auto& v : all) strides_.push_back(stride /= static_cast<std::int64_t>(v.values.size()));
}

std::vector<Parameter> Design::parameters() const {
  std::vector<Parameter> all;
  for (const auto& v : options_.parameters) all.push_back(v.parameter);
  return all;
}

void Design::row(std::int64_t i, std::span<double> values) const {
  for (int k = 0; k < columns(); ++k) values[k] = value(i, k);
}

double Design::value(std::int64_t i, int k) const {
  const auto& v = options_.parameters[k];
  switch (options_.sampling) {
    case Sampling::grid:
      return from_grid(i, k);
    case Sampling::random:
      return draw(i, k);
    case Sampling::latin_hypercube: {
      const auto n = static_cast<std::uint64_t>(rows_), row = static_cast<std::uint64_t>(i);
      const auto column = static_cast<std::uint32_t>(k);
      const auto slice = static_cast<double>(shuffled(options_.seed, column, row, n));
      return v.at((slice + uniform(options_.seed, {row, column})) / static_cast<double>(n));
    }
    case Sampling::saltelli:
      return from_saltelli(i, k);
    case Sampling::table:
      return v.values[static_cast<std::size_t>(i)];
  }
  return 0;
}

/// Of column k + d, of which a Saltelli design has as many again, with the distribution of parameter k.
double Design::draw(std::int64_t row, int column) const {
  const auto& v = options_.parameters[column % columns()];
  return v.at(uniform(options_.seed, {static_cast<std::uint64_t>(row), static_cast<std::uint32_t>(column)}));
}

double Design::from_grid(std::int64_t i, int k) const {
  const auto& values = options_.parameters[k].values;
  return values[static_cast<std::size_t>(i / strides_[k]) % values.size()];
}

double Design::from_saltelli(std::int64_t i, int k) const {
  const std::int64_t d = columns(), base = i / (d + 2), part = i % (d + 2);
  const bool from_b = part == 1 || part == k + 2;
  return draw(base, from_b ? k + columns() : k);
}

}  // namespace ostium::network
