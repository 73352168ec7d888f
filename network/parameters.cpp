#include "network/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/did_you_mean.hpp"
#include "core/error.hpp"

namespace ostium::network {

namespace {

/// What a quantity of that unit has in the circulation, from 100 mmHg, 100 mL/s and a second.
double typical(const std::string& unit) {
  static const std::map<std::string, double> sizes{
      {"Pa", 1.3e4},   {"m3", 1e-4},       {"m3/s", 1e-4},   {"Pa.s/m3", 1.3e8}, {"Pa.s2/m3", 1.3e7},
      {"m3/Pa", 1e-9}, {"Pa.s2/m6", 1e12}, {"Pa/m3", 1.3e8}, {"1/m3", 1e4},      {"s", 0.1},
      {"m", 0.01},     {"m/s", 0.1},       {"m2", 1e-4}};
  const auto at = sizes.find(unit);
  return at == sizes.end() ? 1.0 : at->second;
}

std::vector<std::string> names(const std::vector<Parameter>& all) {
  std::vector<std::string> list;
  for (const auto& p : all) list.push_back(p.name);
  return list;
}

/// The names that may be meant: those of the block where there is one.
std::vector<std::string> candidates(const Model& model, const std::vector<Parameter>& all,
                                    const std::string& name) {
  for (const auto& e : model.entries) {
    if (!name.starts_with(e.name + ".")) continue;
    std::vector<std::string> of_block;
    for (const auto& p : all)
      if (p.name.starts_with(e.name + ".")) of_block.push_back(p.name);
    return of_block;
  }
  return names(all);
}

}  // namespace

std::vector<Parameter> parameters(const Model& model) {
  std::vector<Parameter> all;
  for (size_t i = 0; i < model.entries.size(); ++i) {
    int number = 0;
    for (const auto& p : model.entries[i].block->parameters())
      all.push_back({model.entries[i].name + "." + p.key, p.unit.empty() ? "1" : p.unit, p.value,
                     p.value != 0 ? std::abs(p.value) : typical(p.unit), p.range, static_cast<int>(i),
                     number++});
  }
  return all;
}

Parameter parameter(const Model& model, const std::string& name, const std::string& where) {
  const auto all = parameters(model);
  const auto at = std::find_if(all.begin(), all.end(), [&](const auto& p) { return p.name == name; });
  if (at != all.end()) return *at;
  user_error(
      "{}: there is no parameter \"{}\"; a parameter is BLOCK.KEY with a key that the case gives or that has "
      "a "
      "default{}",
      where, name, did_you_mean(name, candidates(model, all, name)));
}

void check_value(const Parameter& p, double value) {
  if (std::isfinite(value) && p.range.contains(value)) return;
  const std::string allowed = p.range.text(p.unit);
  user_error("{} is {:g} {}, and must be {}", p.name, value, p.unit, allowed.empty() ? "finite" : allowed);
}

std::vector<lumped::Change> Changes::with(const Parameter& p, double value) const {
  auto changed = changes_[p.entry];
  std::erase_if(changed, [&](const auto& c) { return c.parameter == p.number; });
  changed.push_back({p.number, value});
  return changed;
}

std::shared_ptr<const lumped::Block> Changes::block(const Parameter& p, double value) const {
  check_value(p, value);
  auto block = given_.entries[p.entry].block->with(with(p, value));
  if (const auto sentence = block->refusal(); !sentence.empty())
    user_error("{} = {:g} {}: {}", p.name, value, p.unit, sentence);
  return block;
}

std::vector<Replacement> Changes::blocks(const std::vector<Parameter>& parameters,
                                         std::span<const double> values) const {
  std::map<int, std::vector<lumped::Change>> changed;
  for (size_t k = 0; k < parameters.size(); ++k) {
    const auto& p = parameters[k];
    check_value(p, values[k]);
    auto& of_entry = changed.try_emplace(p.entry, changes_[p.entry]).first->second;
    std::erase_if(of_entry, [&](const auto& c) { return c.parameter == p.number; });
    of_entry.push_back({p.number, values[k]});
  }
  std::vector<Replacement> all;
  for (const auto& [entry, changes] : changed) {
    all.push_back({entry, given_.entries[entry].block->with(changes)});
    if (const auto sentence = all.back().block->refusal(); !sentence.empty())
      user_error("{}: {}", given_.entries[entry].name, sentence);
  }
  return all;
}

void Changes::keep(const Parameter& p, double value) { changes_[p.entry] = with(p, value); }

}  // namespace ostium::network
