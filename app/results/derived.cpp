#include "app/results/derived.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <unordered_map>
#include <unordered_set>

#include "core/error.hpp"
#include "core/units.hpp"
#include "lumped/block.hpp"

namespace ostium::app {
namespace {

using nlohmann::json;

json quantity_of(double si, const char* unit, const char* si_unit) {
  return {{"value", si / to_si(1, unit, si_unit)}, {"unit", unit}};
}
json mmHg(double p) { return quantity_of(p, "mmHg", "Pa"); }
json mL(double v) { return quantity_of(v, "mL", "m3"); }
json output_of(double q) { return quantity_of(q, "L/min", "m3/s"); }
json ratio(double x) { return {{"value", x}, {"unit", "1"}}; }

std::string flow_in(const Element& e) { return "q:" + e.name + "_m3_s"; }
std::string flow_out(const Element& e) { return "q:" + e.name + ".q_out_m3_s"; }
bool is_chamber(const Element& e) { return e.type.ends_with("_chamber"); }

std::string node_of(const lumped::Block& block, const std::string& key) {
  for (const auto& t : block.terminals())
    if (t.key == key) return t.node;
  return {};
}

json shares(const std::vector<std::pair<std::string, double>>& flows) {
  double sum = 0;
  json all = json::object();
  for (const auto& [name, q] : flows) sum += q;
  for (const auto& [name, q] : flows) all[name] = ratio(q / sum);
  return all;
}

}  // namespace

std::vector<Element> elements_of(const network::Model& model) {
  std::vector<Element> all;
  for (const auto& e : model.entries)
    all.push_back({e.name, e.block->type(), node_of(*e.block, "from"), node_of(*e.block, "to")});
  return all;
}

void CycleSums::add(double from, double to, double increment) {
  const double tiny = 1e-9 * period_, length = to - from;
  while (from < to) {
    const auto cycle = period_ > 0 ? static_cast<std::size_t>(std::floor((from + tiny) / period_)) : 0;
    double end = period_ > 0 ? std::min(to, static_cast<double>(cycle + 1) * period_) : to;
    if (to - end < tiny) end = to;
    if (cycle >= sums_.size()) sums_.resize(cycle + 1);
    sums_[cycle] += increment * (end - from) / length;
    from = end;
  }
}

double CycleSums::last_complete(double reached) const {
  if (sums_.empty()) return 0;
  const bool cut = period_ > 0 && reached < static_cast<double>(sums_.size()) * period_ * (1 - 1e-6);
  return cut && sums_.size() > 1 ? sums_[sums_.size() - 2] : sums_.back();
}

void CycleSums::archive(Archive& a) {
  a("period", period_);
  a("sums", sums_);
}

Derived::Derived(std::vector<Element> elements, std::vector<std::string> ports,
                 const std::vector<std::string>& series, double period)
    : elements_(std::move(elements)), ports_(std::move(ports)), period_(period) {
  std::unordered_map<std::string, std::size_t> place;
  for (std::size_t i = 0; i < series.size(); ++i) place.emplace(series[i], i);
  const auto index = [&](const std::string& name) {
    const auto found = place.find(name);
    return found == place.end() ? series.size() : found->second;
  };
  std::unordered_set<std::string> ends;
  for (const auto& e : elements_) ends.insert({e.from, e.to});
  for (const auto& name : series)
    if (name.starts_with("p:") && name.ends_with("_Pa") && ends.contains(name.substr(2, name.size() - 5)))
      nodes_.push_back(name.substr(2, name.size() - 5));
  for (int i = 0; i < static_cast<int>(elements_.size()); ++i) {
    const auto& e = elements_[i];
    const std::size_t p = index("p:" + e.from + "_Pa"), V = index("v:" + e.name + ".V_m3");
    if (is_chamber(e) && p < series.size() && V < series.size())
      loops_.push_back({i, p, V}), state_.work.emplace_back(period);
  }
}

void Derived::row(double time, std::span<const double> series) {
  auto& [before, last, work] = state_;
  if (!last.empty() && time > before)
    for (std::size_t i = 0; i < loops_.size(); ++i) {
      const auto [element, p, V] = loops_[i];
      work[i].add(before, time, -(last[p] + series[p]) / 2 * (series[V] - last[V]));
    }
  before = time;
  if (!loops_.empty()) last.assign(series.begin(), series.end());
}

json Derived::results(const Lookup& cycle) const {
  return {{"pressures", pressures(cycle)},
          {"chambers", chambers(cycle)},
          {"sources", sources(cycle)},
          {"flow_splits", flow_splits(cycle)},
          {"outlets", outlets(cycle)}};
}

json Derived::pressures(const Lookup& cycle) const {
  json all = json::object();
  const auto add = [&](const std::string& name, const std::string& series) {
    if (const auto c = cycle(series))
      all[name] = {{"systolic", mmHg(c->max)},
                   {"diastolic", mmHg(c->min)},
                   {"mean", mmHg(c->mean)},
                   {"pulse", mmHg(c->max - c->min)}};
  };
  for (const auto& node : nodes_) add(node, "p:" + node + "_Pa");
  for (const auto& port : ports_) add(port, "pressure " + port);
  return all;
}

/// Mean flow that leaves a node into an element, m3/s.
double Derived::leaving(const std::string& node, int element, const Lookup& cycle) const {
  const auto& e = elements_[element];
  if (e.from != node && e.to != node) return 0;
  const auto in = cycle(flow_in(e)), out = cycle(flow_out(e));
  double q = 0;
  if (e.from == node && in) q += in->mean;
  if (e.to == node && (out || in)) q -= (out ? out : in)->mean;
  return q;
}

json Derived::chambers(const Lookup& cycle) const {
  json all = json::object();
  for (std::size_t n = 0; n < loops_.size(); ++n) {
    const auto& loop = loops_[n];
    const auto& e = elements_[loop.element];
    const auto V = cycle("v:" + e.name + ".V_m3");
    if (!V) continue;
    double q = 0;
    if (const auto out = cycle(flow_out(e)); out && !e.to.empty()) q += out->mean;
    for (int i = 0; i < static_cast<int>(elements_.size()); ++i)
      if (i != loop.element && elements_[i].from == e.from) q += leaving(e.from, i, cycle);
    all[e.name] = {{"end_diastolic_volume", mL(V->max)},
                   {"end_systolic_volume", mL(V->min)},
                   {"stroke_volume", mL(V->max - V->min)},
                   {"ejection_fraction", ratio((V->max - V->min) / V->max)},
                   {"cardiac_output", output_of(q)},
                   {"stroke_work", quantity_of(state_.work[n].last_complete(state_.time), "J", "J")}};
  }
  return all;
}

json Derived::sources(const Lookup& cycle) const {
  json all = json::object();
  for (const auto& e : elements_) {
    const auto q = cycle(flow_in(e));
    if (e.type != "flow_source" || !q) continue;
    all[e.name] = {{"cardiac_output", output_of(q->mean)}};
    if (period_ > 0) all[e.name]["stroke_volume"] = mL(q->mean * period_);
  }
  return all;
}

json Derived::flow_splits(const Lookup& cycle) const {
  json all = json::object();
  for (const auto& node : nodes_) {
    std::vector<std::pair<std::string, double>> flows;
    for (int i = 0; i < static_cast<int>(elements_.size()); ++i)
      if (const double q = leaving(node, i, cycle); q > 0 && !is_chamber(elements_[i]))
        flows.emplace_back(elements_[i].name, q);
    if (flows.size() > 1) all[node] = shares(flows);
  }
  return all;
}

json Derived::outlets(const Lookup& cycle) const {
  std::vector<std::pair<std::string, double>> flows;
  for (const auto& port : ports_)
    if (const auto q = cycle("flow_out " + port); q && q->mean > 0) flows.emplace_back(port, q->mean);
  for (const auto& e : elements_) {
    if (!ports_.empty() || is_chamber(e) || e.type == "capacitor" || e.from.empty() || !e.to.empty())
      continue;
    const auto out = cycle(flow_out(e)), in = cycle(flow_in(e));
    if (const double q = out ? out->mean : in ? in->mean : 0; q > 0) flows.emplace_back(e.name, q);
  }
  json all = json::object(), share = shares(flows);
  for (const auto& [name, q] : flows)
    all[name] = {{"mean_flow", quantity_of(q, "mL/s", "m3/s")}, {"share", share[name]}};
  return all;
}

void Derived::recall(const DerivedState& state) {
  OSTIUM_ASSERT(state.work.size() == loops_.size(), "{} loops saved, {} chambers", state.work.size(),
                loops_.size());
  state_ = state;
}

void archive(Archive& a, DerivedState& state) {
  a("time", state.time);
  a("last", state.last);
  a.list("work", state.work, [&](CycleSums& sums) { sums.archive(a); });
}

}  // namespace ostium::app
