#include "app/import/svzerod_circuit.hpp"

#include <cmath>
#include <numeric>

#include "core/units.hpp"

namespace ostium::app::svzerod {

using config::Tree;

namespace {

constexpr double step_width = 1e-9;  // of the period: what a jump of a table takes

Tree numbers(const std::vector<double>& values) {
  Tree list = Tree::list();
  for (double v : values) list.items.push_back(std::make_shared<Tree>(Tree::scalar(shortest(v))));
  return list;
}

struct Samples {
  std::vector<double> t, v;
  void add(double time, double value) { t.push_back(time), v.push_back(value); }
};

Tree table(const Samples& s, const std::string& unit, double period) {
  Tree tree = Tree::map();
  tree.add("times", numbers(s.t)).add("time_unit", Tree::scalar("s"));
  tree.add("values", numbers(s.v)).add("unit", Tree::scalar(unit));
  if (period > 0) tree.add("period", Tree::scalar(UnitSystem::text(period, "s")));
  return tree;
}

/// Jumps are given a width, because a table is a function of time; so is one at the end of the period.
Samples with_jumps(const Series& series, bool periodic) {
  const double width = step_width * series.period();
  Samples s;
  for (std::size_t i = 0; i < series.t.size(); ++i)
    s.add(i > 0 && series.t[i] <= s.t.back() ? s.t.back() + width : series.t[i], series.values[i]);
  if (periodic && series.values.back() != series.values.front()) s.t.back() -= width;
  return s;
}

bool is_periodic(const Series& series, const Source& source) {
  for (const auto& part : source.parts)
    if (part.kind == Kind::coupling && series.where.path().starts_with(part.node.path()))
      return part.node.flag("periodic", true);
  return true;
}

}  // namespace

Circuit::Circuit(const Source& source, const UnitSystem& units, Stage stage, const Values* steady)
    : source(source), units(units), stage(stage), steady_(steady), parent_(source.connections.size()) {
  std::iota(parent_.begin(), parent_.end(), 0);
}

int Circuit::root(int c) const {
  while (parent_[c] != c) c = parent_[c];
  return c;
}

void Circuit::join(int a, int b) { parent_[std::max(root(a), root(b))] = std::min(root(a), root(b)); }
void Circuit::name_node(int connection, const std::string& name) {
  names_.try_emplace(root(connection), name);
}

std::string Circuit::node(int connection) const {
  const auto named = names_.find(root(connection));
  return named == names_.end() ? source.connections[root(connection)].name : named->second;
}

std::vector<const Part*> Circuit::parts_at(int connection) const {
  std::vector<const Part*> all;
  for (const auto& part : source.parts)
    for (const auto* ends : {&part.in, &part.out})
      for (int c : *ends)
        if (same_node(c, connection) && (all.empty() || all.back() != &part)) all.push_back(&part);
  return all;
}

void Circuit::block(const std::string& name, const std::string& type, Tree fields) {
  Tree tree = Tree::map();
  tree.add("type", Tree::scalar(type));
  for (auto& entry : fields.entries) tree.add(entry.key, *entry.value);
  blocks.add(name, std::move(tree));
}

Tree Circuit::value(double v, const std::string& unit) const {
  return Tree::scalar(UnitSystem::text(v, unit));
}

double Circuit::si(double v, const std::string& unit) const { return v * UnitSystem::si(unit); }

Tree Circuit::waveform(const Series& series, const std::string& unit, double factor) const {
  if (stage == Stage::steady) return value(factor * series.mean(), unit);
  if (series.constant()) return value(factor * series.values.front(), unit);
  const bool periodic = is_periodic(series, source);
  Samples s = with_jumps(series, periodic);
  for (double& v : s.v) v *= factor;
  return table(s, unit, periodic ? series.period() : 0);
}

Tree Circuit::rate(const Series& series, const std::string& unit, double factor) const {
  if (stage == Stage::steady || series.constant()) return value(0, unit);
  const double width = step_width * series.period();
  const auto slope = [&](std::size_t i) {
    return factor * (series.values[i + 1] - series.values[i]) / (series.t[i + 1] - series.t[i]);
  };
  Samples s;
  const std::size_t n = series.t.size() - 1;
  s.add(0, slope(n - 1));
  for (std::size_t i = 0; i < n; ++i) s.add(series.t[i] + width, slope(i)), s.add(series.t[i + 1], slope(i));
  return table(s, unit, is_periodic(series, source) ? series.period() : 0);
}

double Circuit::start(const Expression& in_steady_stage, double from_file) const {
  if (!steady_) return from_file;
  return in_steady_stage.value([this](const std::string& series) {
    const auto at = steady_->find(series);
    OSTIUM_ASSERT(at != steady_->end(), "the steady stage has no series {}", series);
    return at->second;
  });
}

Tree Circuit::start_value(const Expression& e, double from_file, const std::string& unit) const {
  const double factor = si(1, unit);
  return value(start(e, from_file) / factor, unit);
}

double Circuit::from_file(const std::string& unknown, const std::string& unit) const {
  return si(source.start(unknown), unit);
}

void Circuit::internal(const Part& part, const std::string& variable, const std::string& unit, Expression e) {
  internals_.push_back({variable + ":" + part.name, unit, std::move(e)});
}

/// Kirchhoff's law where a single flow of the junction is open.
bool Circuit::balance(const Part& junction, std::vector<std::optional<Expression>>& flows) const {
  int open = -1;
  Expression sum;  // of what comes in
  for (int sign : {1, -1})
    for (int c : sign > 0 ? junction.in : junction.out) {
      if (!flows[c] && open >= 0) return false;
      if (!flows[c]) open = c;
      if (flows[c]) sum += sign * *flows[c];
    }
  if (open < 0) return false;
  const bool leaves = std::count(junction.out.begin(), junction.out.end(), open) > 0;
  flows[open] = (leaves ? 1 : -1) * sum;
  return true;
}

std::vector<std::optional<Expression>> Circuit::flows() const {
  std::vector<std::optional<Expression>> all(source.connections.size());
  for (std::size_t c = 0; c < all.size(); ++c) {
    const auto& [up, down, name] = source.connections[c];
    if (const auto out = out_.find(source.parts[up].name); out != out_.end())
      all[c] = out->second;
    else if (const auto in = in_.find(source.parts[down].name); in != in_.end())
      all[c] = in->second;
  }
  for (bool more = true; more;) {
    more = false;
    for (const auto& part : source.parts)
      if (part.kind == Kind::junction) more = balance(part, all) || more;
  }
  return all;
}

Tree Circuit::variables() const {
  Tree all = Tree::map();
  const auto add = [&](const std::string& name, const std::string& unit, const Expression& e) {
    Tree list = Tree::list();
    list.items.push_back(std::make_shared<Tree>(Tree::scalar(unit)));
    for (const auto& text : e.texts()) list.items.push_back(std::make_shared<Tree>(Tree::scalar(text)));
    all.add(name, std::move(list));
  };
  const auto flow = flows();
  for (std::size_t c = 0; c < flow.size(); ++c) {
    const auto& name = source.connections[c].name;
    if (!flow[c])
      source.root.error(
          "junctions: nothing says the flow of the connection {}: it lies in a ring of junctions; put a "
          "vessel between two of them",
          name);
    add("flow:" + name, units.flow, *flow[c]);
    add("pressure:" + name, units.pressure, Expression::pressure(node(static_cast<int>(c))));
  }
  for (const auto& i : internals_) add(i.name, i.unit, i.value);
  return all;
}

}  // namespace ostium::app::svzerod
