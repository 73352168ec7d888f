#include <algorithm>
#include <numeric>
#include <optional>

#include "core/did_you_mean.hpp"
#include "core/error.hpp"
#include "lumped/block.hpp"
#include "network/graph.hpp"

namespace ostium::network {

namespace {

using lumped::Nature;

/// A branch between nodes of the graph; `outside` stands for the ground and comes last.
struct Edge {
  int entry;
  int a, b;
  Nature nature;
};

/// Disjoint sets of nodes; the ground is node n.
class Sets {
 public:
  explicit Sets(int n) : parent_(n + 1) { std::iota(parent_.begin(), parent_.end(), 0); }
  int of(int i) {
    if (i == outside) i = ground();
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  bool join(int a, int b) {
    a = of(a), b = of(b);
    parent_[a] = b;
    return a != b;
  }
  bool grounded(int i) { return of(i) == of(ground()); }

 private:
  int ground() const { return static_cast<int>(parent_.size()) - 1; }
  std::vector<int> parent_;
};

std::vector<Edge> edges_of(const Model& model, const Graph& g) {
  std::vector<Edge> edges;
  for (size_t i = 0; i < model.entries.size(); ++i)
    for (const auto& b : model.entries[i].block->branches()) {
      const int to = b.b == lumped::ground ? outside : g.node_of[i][b.b];
      edges.push_back({static_cast<int>(i), g.node_of[i][b.a], to, b.nature});
    }
  return edges;
}

/// The first of a long list stand for all.
std::string quoted(const std::vector<std::string>& names) {
  constexpr size_t most = 8;
  const size_t count = names.size() > most + 1 ? most : names.size();
  std::string text;
  for (size_t i = 0; i < count; ++i)
    text += (i == 0 ? "\"" : i + 1 == names.size() ? " and \"" : ", \"") + names[i] + "\"";
  return text + (count < names.size() ? fmt::format(" and {} more", names.size() - count) : "");
}

struct Check {
  const Model& model;
  const Graph& g;
  std::vector<Edge> edges = edges_of(model, g);

  int node_count() const { return static_cast<int>(g.nodes.size()); }
  bool is_opening(int node) const {
    return std::count(g.port_node.begin(), g.port_node.end(), node) && g.junction == Junction::separate;
  }
  const Entry& entry(const Edge& e) const { return model.entries[e.entry]; }

  /// Entries with a terminal at one of the nodes that `chosen` says yes to.
  template <class F>
  std::vector<int> entries_at(F chosen) const {
    std::vector<int> found;
    for (size_t i = 0; i < g.node_of.size(); ++i)
      if (std::any_of(g.node_of[i].begin(), g.node_of[i].end(),
                      [&](int n) { return n != outside && chosen(n); }))
        found.push_back(static_cast<int>(i));
    return found;
  }
  /// How many blocks are at each node.
  std::vector<int> blocks_at() const {
    std::vector<int> count(node_count());
    for (auto row : g.node_of) {
      std::sort(row.begin(), row.end());
      row.erase(std::unique(row.begin(), row.end()), row.end());
      for (int n : row)
        if (n != outside) ++count[n];
    }
    return count;
  }
  std::vector<std::string> names(const std::vector<int>& entries) const {
    std::vector<std::string> all;
    for (int i : entries) all.push_back(model.entries[i].name);
    return all;
  }
  template <class F>
  std::vector<std::string> node_names(F chosen) const {
    std::vector<std::string> all;
    for (int n = 0; n < node_count(); ++n)
      if (chosen(n)) all.push_back(g.nodes[n]);
    return all;
  }

  void floating_nodes() const;
  void references() const;
  void conflict(const std::vector<int>& entries, const std::vector<std::string>& nodes) const;
  void cut_sets() const;
  void loops() const;
  [[noreturn]] void refuse_loop(const std::vector<Edge>& tree, const Edge& last) const;
};

void Check::floating_nodes() const {
  const auto blocks = blocks_at();
  for (int n = 0; n < node_count(); ++n) {
    if (blocks[n] > 1 || is_opening(n) || g.junction == Junction::merged) continue;
    const auto at = entries_at([n](int i) { return i == n; });
    auto others = g.nodes;
    others.insert(others.end(), g.port_name.begin(), g.port_name.end());
    std::erase(others, g.nodes[n]);
    const auto near = nearest_name(g.nodes[n], others);
    user_error(
        "{}: the node \"{}\" has no other block than \"{}\", so its flow has nowhere to go{}; join a second "
        "block to it "
        "or end the block at a ground pressure",
        model.entries[at[0]].where, g.nodes[n], model.entries[at[0]].name,
        near ? "; did you mean \"" + *near + "\"?" : "");
  }
}

/// Only flow sources may be told apart here: what they tie has no level of pressure.
void Check::references() const {
  Sets sets(node_count());
  for (const auto& e : edges)
    if (e.nature != Nature::flow) sets.join(e.a, e.b);
  for (int n = 0; n < node_count(); ++n) {
    if (sets.grounded(n)) continue;
    const auto same = [&](int i) { return sets.of(i) == sets.of(n); };
    const auto at = entries_at(same);
    conflict(at, node_names(same));
    user_error(
        "{}: nothing says the level of pressure at {}: no block there ends at a ground, a distal pressure or "
        "a pressure "
        "source; add one, for example `ground: 0 mmHg` or a capacitor to the surroundings",
        model.entries[at[0]].where, quoted(node_names(same)));
  }
}

void Check::conflict(const std::vector<int>& at, const std::vector<std::string>& nodes) const {
  const bool only_sources = std::all_of(at.begin(), at.end(), [&](int i) {
    const auto b = model.entries[i].block->branches();
    return b.size() == 1 && b[0].nature == Nature::flow;
  });
  if (only_sources)
    user_error(
        "{}: the flow sources {} meet at {} and nothing there can take the difference of their flows; add a "
        "block that "
        "can, for example a windkessel, or drop one source",
        model.entries[at[0]].where, quoted(names(at)), quoted(nodes));
}

/// Nodes that hang on inductors and prescribed flows alone: the sum of those flows is a constraint on states.
void Check::cut_sets() const {
  Sets sets(node_count());
  for (const auto& e : edges)
    if (e.nature != Nature::flow && e.nature != Nature::inductive) sets.join(e.a, e.b);
  for (int n = 0; n < node_count(); ++n) {
    if (sets.grounded(n)) continue;
    const auto same = [&](int i) { return sets.of(i) == sets.of(n); };
    const auto nodes = node_names(same);
    const bool opening =
        std::any_of(g.port_node.begin(), g.port_node.end(), [&](int p) { return p != outside && same(p); });
    const auto at = entries_at(same);
    user_error(
        "{}: only inductors{} meet at {} (blocks {}): each wants its own flow and none can give way, which "
        "makes the "
        "equations of index 2; give the node a way out, for example a small compliance "
        "`{}_c: {{type: capacitor, from: {}, C: 1e-11 m3/Pa}}`",
        model.entries[at[0]].where,
        opening ? ", prescribed flows or the vessel's flow" : " or prescribed flows", quoted(nodes),
        quoted(names(at)), nodes[0], nodes[0]);
  }
}

/// Loops of blocks that each fix a pressure difference.
void Check::loops() const {
  Sets sets(node_count());
  std::vector<Edge> tree;
  for (const auto& e : edges) {
    if (e.nature != Nature::capacitive && e.nature != Nature::pressure) continue;
    if (!sets.join(e.a, e.b)) refuse_loop(tree, e);
    tree.push_back(e);
  }
}

/// Edges of the tree between two nodes, `ground` being the number of the outside.
std::vector<Edge> path(const std::vector<Edge>& tree, int from, int to, int ground) {
  const auto number = [ground](int node) { return node == outside ? ground : node; };
  std::vector<std::vector<const Edge*>> at(ground + 1);
  for (const auto& e : tree) at[number(e.a)].push_back(&e), at[number(e.b)].push_back(&e);
  std::vector<const Edge*> came_by(ground + 1, nullptr);
  std::vector<int> found{number(from)};
  for (size_t i = 0; i < found.size(); ++i)
    for (const Edge* e : at[found[i]]) {
      const int next = number(e->a) + number(e->b) - found[i];
      if (next == number(from) || came_by[next]) continue;
      came_by[next] = e;
      found.push_back(next);
    }
  std::vector<Edge> way;
  for (int node = number(to); came_by[node]; node = number(way.back().a) + number(way.back().b) - node)
    way.push_back(*came_by[node]);
  return way;
}

void Check::refuse_loop(const std::vector<Edge>& tree, const Edge& last) const {
  auto loop = path(tree, last.a, last.b, node_count());
  loop.push_back(last);
  std::vector<int> at;
  for (const auto& e : loop) at.push_back(e.entry);
  std::sort(at.begin(), at.end());
  at.erase(std::unique(at.begin(), at.end()), at.end());
  if (std::all_of(loop.begin(), loop.end(), [](const Edge& e) { return e.nature == Nature::pressure; }))
    user_error(
        "{}: the pressure sources {} prescribe the same pressure twice; drop one of them, or put a resistor "
        "between them",
        entry(last).where, quoted(names(at)));
  user_error(
      "{}: the blocks {} form a loop in which each fixes a pressure difference (a capacitor's is a state), "
      "which makes "
      "the equations of index 2; put a small resistor in series with one of them: give \"{}\" a node of its "
      "own, "
      "`{}_r`, and join that to the old one with `{}_r: {{type: resistor, from: {}_r, to: .., R: 1e5 "
      "Pa.s/m3}}`",
      entry(last).where, quoted(names(at)), entry(last).name, entry(last).name, entry(last).name,
      entry(last).name);
}

}  // namespace

void check_graph(const Model& model, const Graph& graph) {
  const Check check{.model = model, .g = graph};
  check.floating_nodes();
  check.references();
  check.cut_sets();
  check.loops();
}

}  // namespace ostium::network
