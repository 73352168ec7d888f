#include "core/config/node.hpp"

#include <algorithm>

#include "core/did_you_mean.hpp"
#include "core/text.hpp"

namespace ostium::config {

Node Node::load(const std::filesystem::path& file) { return parse(read_text_file(file), file.string()); }

Node Node::parse(const std::string& text, const std::string& file_name) {
  Node node;
  node.tree_ = parse_yaml(text, file_name);
  node.file_ = file_name;
  if (node.tree_->line > 0) node.line_ = node.tree_->line, node.column_ = node.tree_->column;
  return node;
}

const Tree& Node::tree() const {
  static const Tree nothing;
  return tree_ ? *tree_ : nothing;
}

std::string Node::where() const { return fmt::format("{}:{}:{}{}", file_, line_, column_, note_); }

std::string Node::key() const {
  const auto dot = path_.rfind('.');
  return dot == std::string::npos ? path_ : path_.substr(dot + 1);
}

std::filesystem::path Node::folder() const { return std::filesystem::path(file_).parent_path(); }

const std::string& Node::text() const {
  if (!is_scalar()) error("expected a single value, found {}", describe());
  return tree_->text;
}

Node Node::child(const std::string& step, TreePtr tree, int line, int column) const {
  Node node;
  node.tree_ = std::move(tree);
  const Origin* origin = node.tree_ ? node.tree_->origin.get() : nullptr;
  node.file_ = origin ? origin->file : file_;
  node.note_ = origin ? origin->note : note_;
  node.path_ = path_.empty() ? step : path_ + "." + step;
  node.line_ = line, node.column_ = column;
  return node;
}

Node Node::with_text(const std::string& text) const {
  Tree tree = Tree::scalar(text);
  tree.line = line_, tree.column = column_;
  return with_tree(std::make_shared<Tree>(std::move(tree)));
}

Node Node::with_tree(TreePtr tree) const {
  Node node = *this;
  node.tree_ = std::move(tree);
  return node;
}

TreeEntry Node::grafted(std::string key, const std::string& note) const {
  Tree copy = tree();
  copy.origin = std::make_shared<Origin>(Origin{file_, note_ + note});
  return {std::move(key), line_, column_, std::make_shared<Tree>(std::move(copy))};
}

namespace {

/// A copy of `tree` down to the replaced value; all else stays shared.
TreePtr replaced(const TreePtr& tree, const std::string& path, const TreePtr& value) {
  if (path.empty()) return value;
  const auto dot = path.find('.');
  const std::string key = path.substr(0, dot), rest = dot == std::string::npos ? "" : path.substr(dot + 1);
  auto copy = std::make_shared<Tree>(tree && tree->kind == Tree::Kind::map ? *tree : Tree::map());
  for (auto& entry : copy->entries)
    if (entry.key == key) return entry.value = replaced(entry.value, rest, value), copy;
  copy->entries.push_back({key, value->line, value->column, replaced(nullptr, rest, value)});
  return copy;
}

}  // namespace

Node Node::with_value(const std::string& dotted, const std::string& yaml) const {
  Node node = *this;
  node.tree_ = replaced(tree_, dotted, parse_yaml(yaml, dotted));
  return node;
}

std::vector<Node> Node::items() const {
  if (!is_list()) error("expected a list like [a, b], found {}", describe());
  std::vector<Node> all;
  for (const auto& item : tree_->items)
    all.push_back(child(std::to_string(all.size() + 1), item, item->line, item->column));
  return all;
}

std::vector<std::pair<std::string, Node>> Node::entries() const {
  if (!is_map()) error("expected a mapping like {{name: value}}, found {}", describe());
  std::vector<std::pair<std::string, Node>> all;
  for (const auto& e : tree_->entries) all.emplace_back(e.key, child(e.key, e.value, e.line, e.column));
  return all;
}

std::vector<std::string> Node::keys() const {
  std::vector<std::string> names;
  for (const auto& entry : entries()) names.push_back(entry.first);
  return names;
}

std::optional<Node> Node::find(const std::string& key) const {
  if (!is_map()) error("expected a mapping like {{name: value}}, found {}", describe());
  for (const auto& e : tree_->entries)
    if (e.key == key) return child(e.key, e.value, e.line, e.column);
  return {};
}

Node Node::at(const std::string& key) const {
  auto node = find(key);
  if (!node) error("the key \"{}\" is missing", key);
  return *node;
}

std::string Node::message(const std::string& sentence) const {
  const std::string place = file_.empty() ? "" : where() + ": ";
  return printable(place + (path_.empty() ? "" : path_ + ": ") + sentence);
}

void Node::check_keys(const std::vector<std::string>& allowed) const {
  for (const auto& [key, node] : entries())
    if (std::find(allowed.begin(), allowed.end(), key) == allowed.end())
      node.error("unknown key \"{}\"{}", shown(key), did_you_mean(key, allowed));
}

std::string Node::describe() const {
  switch (kind()) {
    case Tree::Kind::null:
      return "nothing";
    case Tree::Kind::list:
      return "a list";
    case Tree::Kind::map:
      return "a mapping";
    case Tree::Kind::scalar:
      break;
  }
  return fmt::format("the value \"{}\"", shown(tree_->text));
}

}  // namespace ostium::config
