// Uses of subnetworks become their blocks.
#include <algorithm>
#include <set>

#include "core/did_you_mean.hpp"
#include "lumped/registry.hpp"
#include "network/parameter_values.hpp"
#include "network/subnetwork.hpp"

namespace ostium::network {
namespace {

using config::Node;
using config::Tree;
using config::TreeEntry;

bool is_block_type(const std::string& name) {
  const auto& types = lumped::block_types();
  return std::any_of(types.begin(), types.end(), [&](const auto& t) { return t.name == name; });
}

const Subnetwork* find(const Subnetworks& all, const std::string& name) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const auto& s) { return s.first == name; });
  return at == all.end() ? nullptr : &at->second;
}

/// Those of the case behind the shipped ones.
Subnetworks known(const std::optional<Node>& definitions) {
  Subnetworks all = shipped_subnetworks();
  if (!definitions || definitions->is_null()) return all;
  for (const auto& [name, node] : definitions->entries()) {
    if (is_block_type(name) || find(all, name))
      node.error("\"{}\" is the name of a block that the program has; choose another one", name);
    all.emplace_back(name, config::read<Subnetwork>(node));
  }
  return all;
}

[[noreturn]] void unknown_type(const Node& type, const Subnetworks& all) {
  std::vector<std::string> names;
  for (const auto& t : lumped::block_types()) names.push_back(t.name);
  for (const auto& s : all) names.push_back(s.first);
  type.error("there is no block type \"{}\"{}", type.text(), did_you_mean(type.text(), names));
}

/// One use: the node of its mapping, and what it means.
class Use {
 public:
  Use(std::string name, const Node& node, const Subnetwork& definition)
      : name_(std::move(name)), node_(node), definition_(definition), ports_(definition.port_names()) {
    check_keys();
    for (const auto& [parameter, p] : definition.parameters) values_[parameter] = value(parameter, p);
  }

  /// The inner block `key` with its parameters, its overrides and the names of the outside.
  Node block(const std::string& key, const Node& inner, const Node& blocks) {
    Tree one = Tree::map();
    TreeEntry entry = inner.with_tree(evaluated(inner, values_)).grafted(name_ + "." + key, used_at());
    one.entries.push_back(std::move(entry));
    return blocks.with_tree(std::make_shared<Tree>(std::move(one))).at(name_ + "." + key);
  }

  /// Replaces what the use says of the inner block `key`: "key.R" becomes its R.
  Node overridden(Node block, const std::string& key, bool is_subnetwork) const {
    for (const auto& [path, value] : node_.entries())
      if (path.starts_with(key + "."))
        block = replaced(block, path.substr(key.size() + 1), value, is_subnetwork);
    return block;
  }

  /// The node `inner` by the name it has outside.
  std::string outer(const std::string& inner) {
    if (std::find(ports_.begin(), ports_.end(), inner) == ports_.end()) return name_ + "." + inner;
    joined_.insert(inner);
    return node_.at(inner).text();
  }

  void check_ports_joined() const {
    for (const auto& port : ports_)
      if (!joined_.count(port))
        definition_.origin.error("no block is at the port \"{}\"; join one to it, or drop the port", port);
  }

 private:
  std::string used_at() const { return " (used at " + node_.where() + ")"; }

  void check_keys() const {
    std::vector<std::string> allowed{"type"};
    allowed.insert(allowed.end(), ports_.begin(), ports_.end());
    for (const auto& [parameter, p] : definition_.parameters) allowed.push_back(parameter);
    const auto blocks = definition_.blocks.keys();
    for (const auto& [key, value] : node_.entries()) {
      const auto dot = key.find('.');
      if (dot == std::string::npos && std::find(allowed.begin(), allowed.end(), key) == allowed.end())
        value.error("unknown key \"{}\"{}", key, did_you_mean(key, allowed));
      const std::string block = key.substr(0, dot);
      if (dot != std::string::npos && std::find(blocks.begin(), blocks.end(), block) == blocks.end())
        value.error("the subnetwork \"{}\" has no block \"{}\"{}", node_.at("type").text(), block,
                    did_you_mean(block, blocks));
    }
    for (const auto& port : ports_)
      if (!node_.find(port))
        node_.error("the key \"{}\" is missing: name the node that the port \"{}\"{} is joined to", port,
                    port, definition_.port_doc(port).empty() ? "" : " (" + definition_.port_doc(port) + ")");
  }

  ParameterValue value(const std::string& name, const SubnetworkParameter& p) const {
    ParameterValue v{node_, p.unit};
    if (const auto given = node_.find(name))
      v.node = *given;
    else if (p.value)
      v.node = p.origin.at("default");
    else
      node_.error("the key \"{}\" is missing: {} [{}]", name,
                  p.doc.empty() ? "a parameter without default" : p.doc, p.unit);
    if (v.node.is_scalar()) read(v);  // its dimension
    return v;
  }

  /// A block takes the value at a path of keys; a subnetwork inside resolves the path itself.
  static Node replaced(const Node& block, const std::string& path, const Node& value, bool is_subnetwork) {
    const auto dot = path.find('.');
    const std::string key = is_subnetwork ? path : path.substr(0, dot);
    TreeEntry entry = value.grafted(key);
    if (!is_subnetwork && dot != std::string::npos) {
      const auto inner = block.find(key);
      const Node map =
          inner && inner->is_map() ? *inner : value.with_tree(std::make_shared<Tree>(Tree::map()));
      entry = replaced(map, path.substr(dot + 1), value, false).grafted(key);
    }
    Tree copy = block.tree();
    const auto same = [&](const TreeEntry& e) { return e.key == key; };
    const auto at = std::find_if(copy.entries.begin(), copy.entries.end(), same);
    if (at == copy.entries.end())
      copy.entries.push_back(std::move(entry));
    else
      *at = std::move(entry);
    return block.with_tree(std::make_shared<Tree>(std::move(copy)));
  }

  std::string name_;
  const Node& node_;
  const Subnetwork& definition_;
  std::vector<std::string> ports_;
  ParameterValues values_;
  std::set<std::string> joined_;
};

class Expansion {
 public:
  Expansion(const Node& blocks, const std::optional<Node>& definitions)
      : blocks_(blocks), all_(known(definitions)) {}

  Node made() {
    for (const auto& [name, node] : blocks_.entries()) place(name, node);
    return blocks_.with_tree(std::make_shared<Tree>(std::move(flat_)));
  }

 private:
  /// The subnetwork a block is a use of; nothing for an ordinary block, whose own errors its reader finds.
  const Subnetwork* use_of(const Node& node) const {
    const auto type = node.is_map() ? node.find("type") : std::nullopt;
    if (!type || !type->is_scalar() || is_block_type(type->text())) return nullptr;
    const Subnetwork* found = find(all_, type->text());
    if (!found) unknown_type(*type, all_);
    return found;
  }

  void place(const std::string& name, const Node& node) {
    const Subnetwork* definition = use_of(node);
    if (!definition) {
      add(name, node);
      return;
    }
    enter(node);
    Use use(name, node, *definition);
    for (const auto& [key, inner] : definition->blocks.entries()) place_inner(use, name, key, inner);
    use.check_ports_joined();
    within_.pop_back();
  }

  /// Subnetworks that use others twice grow without bound in few lines.
  void add(const std::string& name, const Node& node) {
    constexpr std::size_t most = 50000;
    if (flat_.entries.size() == most) node.error("the subnetworks make more than {} blocks; use fewer", most);
    flat_.entries.push_back(node.grafted(name));
  }

  void place_inner(Use& use, const std::string& name, const std::string& key, const Node& inner) {
    Node block = use.block(key, inner, blocks_);
    const Subnetwork* definition = use_of(block);
    block = use.overridden(block, key, definition);
    const auto nodes = definition ? definition->port_names() : node_keys(block);
    place(name + "." + key, renamed(block, nodes, use));
  }

  void enter(const Node& node) {
    const std::string type = node.at("type").text();
    if (std::find(within_.begin(), within_.end(), type) != within_.end())
      node.error("the subnetwork \"{}\" contains itself; a definition may use others only", type);
    constexpr std::size_t deepest = 30;
    if (within_.size() == deepest) node.error("subnetworks are nested more than {} deep; use fewer", deepest);
    within_.push_back(type);
  }

  /// The keys of a block that name nodes.
  static std::vector<std::string> node_keys(const Node& block) {
    std::vector<std::string> keys;
    const auto read = lumped::read_block(block);
    for (const auto& t : read->terminals())
      if (!t.grounded()) keys.push_back(t.key);
    return keys;
  }

  static Node renamed(const Node& block, const std::vector<std::string>& keys, Use& use) {
    Tree copy = block.tree();
    for (auto& entry : copy.entries)
      if (std::find(keys.begin(), keys.end(), entry.key) != keys.end()) {
        const Node node = block.at(entry.key);
        entry.value = node.with_text(use.outer(node.text())).shared_tree();
      }
    return block.with_tree(std::make_shared<Tree>(std::move(copy)));
  }

  const Node& blocks_;
  Subnetworks all_;
  Tree flat_ = Tree::map();
  std::vector<std::string> within_;
};

/// Nothing to do, as in most networks and in each of the thousands of a sweep.
bool all_ordinary(const Node& blocks) {
  for (const auto& [name, node] : blocks.entries()) {
    const auto type = node.is_map() ? node.find("type") : std::nullopt;
    if (type && type->is_scalar() && !is_block_type(type->text())) return false;
  }
  return true;
}

}  // namespace

Node expand(const Node& blocks, const std::optional<Node>& definitions) {
  if (!blocks.is_map() || (!definitions && all_ordinary(blocks))) return blocks;
  return Expansion(blocks, definitions).made();
}

}  // namespace ostium::network
