#include "network/graph.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "core/did_you_mean.hpp"
#include "core/error.hpp"
#include "lumped/block.hpp"

namespace ostium::network {

namespace {

using lumped::Nature;

void check_names(const Model& model) {
  if (model.entries.empty()) user_error("{}: a network needs at least one block", model.where);
  std::map<std::string, std::string> seen;
  for (const auto& e : model.entries)
    if (auto [first, fresh] = seen.emplace(e.name, e.where); !fresh)
      user_error("{}: there are two blocks named \"{}\" (the other one: {}); rename one of them", e.where,
                 e.name, first->second);
}

/// Index of each port by the name of its opening.
std::map<std::string, int> index_of(const std::vector<Port>& ports) {
  std::map<std::string, int> index;
  for (const auto& port : ports) index.emplace(port.opening, static_cast<int>(index.size()));
  OSTIUM_ASSERT(index.size() == ports.size(), "openings share a name among {}", ports.size());
  return index;
}

std::vector<std::vector<int>> ports_of(const Model& model, const std::map<std::string, int>& index) {
  std::vector<std::vector<int>> all;
  for (const auto& e : model.entries) {
    auto& row = all.emplace_back();
    for (const auto& t : e.block->terminals()) {
      const auto found = index.find(t.node);
      row.push_back(found == index.end() ? outside : found->second);
    }
  }
  return all;
}

std::vector<std::string> other_nodes(const Model& model, const std::map<std::string, int>& openings) {
  std::set<std::string> names;
  for (const auto& e : model.entries)
    for (const auto& t : e.block->terminals())
      if (!t.grounded() && !openings.count(t.node)) names.insert(t.node);
  return {names.begin(), names.end()};
}

void refuse_bare_opening(const Model& model, const Port& port, const std::vector<std::string>& nodes) {
  const auto near = nearest_name(port.opening, nodes);
  user_error(
      "{}: the opening \"{}\" has no block{}; end it with one, for example "
      "`{}: {{type: pressure_source, from: {}, pressure: 80 mmHg}}`",
      model.where, port.opening, near ? " (did you mean it by the node \"" + *near + "\"?)" : "", "outlet",
      port.opening);
}

bool is_flow_source(const lumped::Block& block) {
  const auto branches = block.branches();
  return branches.size() == 1 && branches[0].nature == Nature::flow;
}

/// Entries with a terminal at the port.
std::vector<int> entries_at(int port, const Graph& g) {
  std::vector<int> found;
  for (int i = 0; i < static_cast<int>(g.port_of.size()); ++i)
    if (std::count(g.port_of[i].begin(), g.port_of[i].end(), port)) found.push_back(i);
  return found;
}

void classify_port(int port, const Model& model, Graph& g) {
  const auto at = entries_at(port, g);
  const bool only_sources =
      std::all_of(at.begin(), at.end(), [&](int i) { return is_flow_source(*model.entries[i].block); });
  if (only_sources && at.size() > 1)
    user_error(
        "{}: two flow sources, \"{}\" and \"{}\", prescribe the flow of the opening \"{}\"; one opening has "
        "one flow: "
        "keep one of them, or add their flows into one",
        model.entries[at[1]].where, model.entries[at[0]].name, model.entries[at[1]].name, g.port_name[port]);
  g.port_kind[port] = only_sources ? PortKind::flow : PortKind::pressure;
  g.port_source[port] = only_sources ? at[0] : outside;
}

void classify_ports(const Model& model, Graph& g) {
  const int m = static_cast<int>(g.port_name.size());
  for (int k = 0; k < m; ++k) classify_port(k, model, g);
  if (m && std::count(g.port_kind.begin(), g.port_kind.end(), PortKind::flow) == m)
    user_error(
        "{}: every opening of the vessel has a prescribed flow, so nothing says its pressure and the flows "
        "would have "
        "to agree exactly; give at least one opening a pressure, for example a windkessel or a "
        "pressure_source",
        model.where);
}

void place_velocity_sources(Model& model, const std::vector<Port>& ports, const Graph& g) {
  for (size_t i = 0; i < model.entries.size(); ++i) {
    auto& e = model.entries[i];
    if (!e.block->needs_opening()) continue;
    const auto port = std::max_element(g.port_of[i].begin(), g.port_of[i].end());
    if (*port == outside)
      user_error(
          "{}: `velocity` is the mean velocity over an opening of the vessel, and \"{}\" is at none; give "
          "its `flow`",
          e.where, e.name);
    e.block = e.block->at_opening(ports[*port].area);
  }
}

/// Names become numbers, in the order of their first appearance.
class Nodes {
 public:
  explicit Nodes(Graph& g) : g_(g) {}
  int index(const std::string& name) {
    const auto [at, fresh] = index_.emplace(name, static_cast<int>(g_.nodes.size()));
    if (fresh) g_.nodes.push_back(name);
    return at->second;
  }

 private:
  Graph& g_;
  std::map<std::string, int> index_;
};

int place(const lumped::Terminal& t, int port, const Graph& g, Nodes& nodes) {
  if (t.grounded()) return outside;
  if (port == outside) return nodes.index(t.node);
  if (g.junction == Junction::merged) return nodes.index("(openings)");
  return g.port_kind[port] == PortKind::flow ? outside : nodes.index(t.node);
}

void number_nodes(const Model& model, Graph& g) {
  Nodes nodes(g);
  for (size_t i = 0; i < model.entries.size(); ++i) {
    const auto& terminals = model.entries[i].block->terminals();
    auto& row = g.node_of.emplace_back();
    for (size_t k = 0; k < terminals.size(); ++k) {
      row.push_back(place(terminals[k], g.port_of[i][k], g, nodes));
      if (g.port_of[i][k] != outside) g.port_node[g.port_of[i][k]] = row.back();
    }
  }
}

}  // namespace

Graph make_graph(Model& model, const std::vector<Port>& ports, Junction junction) {
  check_names(model);
  const auto index = index_of(ports);
  Graph g;
  g.junction = junction;
  g.port_of = ports_of(model, index);
  for (const auto& port : ports) g.port_name.push_back(port.opening);
  for (size_t k = 0; k < ports.size(); ++k)
    if (entries_at(static_cast<int>(k), g).empty())
      refuse_bare_opening(model, ports[k], other_nodes(model, index));
  g.port_kind.resize(ports.size());
  g.port_source.resize(ports.size(), outside);
  g.port_node.resize(ports.size(), outside);
  classify_ports(model, g);
  place_velocity_sources(model, ports, g);
  number_nodes(model, g);
  check_graph(model, g);
  return g;
}

}  // namespace ostium::network
