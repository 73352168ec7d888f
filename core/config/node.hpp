/// A place in a YAML document that knows where it stands: file, line, column and the path of keys that leads
/// to it.
#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/config/tree.hpp"
#include "core/error.hpp"

namespace ostium::config {

class Node {
 public:
  Node() = default;                                     // an absent node: null, no file
  static Node load(const std::filesystem::path& file);  // throws UserError: missing, a folder, broken YAML
  static Node parse(const std::string& text, const std::string& file_name = "input.yaml");

  bool is_null() const { return kind() == Tree::Kind::null; }
  bool is_scalar() const { return kind() == Tree::Kind::scalar; }
  bool is_list() const { return kind() == Tree::Kind::list; }
  bool is_map() const { return kind() == Tree::Kind::map; }
  Tree::Kind kind() const { return tree_ ? tree_->kind : Tree::Kind::null; }
  const Tree& tree() const;
  const TreePtr& shared_tree() const { return tree_; }

  std::string where() const;                         // "case.yaml:12:5"
  const std::string& path() const { return path_; }  // "network.blocks.dao.Rp"
  std::string key() const;                           // "Rp"
  const std::string& file() const { return file_; }
  std::filesystem::path folder() const;  // what relative paths in the document refer to

  const std::string& text() const;  // of a scalar; throws UserError otherwise
  std::vector<Node> items() const;  // of a list; throws UserError otherwise
  std::vector<std::pair<std::string, Node>> entries()
      const;  // of a mapping, file order; throws UserError otherwise
  std::vector<std::string> keys() const;
  std::optional<Node> find(const std::string& key) const;  // in a mapping; throws UserError if it is none
  Node at(const std::string& key) const;                   // throws UserError when missing

  /// The same place holding another scalar, or another value.
  Node with_text(const std::string& text) const;
  Node with_tree(TreePtr tree) const;

  /// This value for a mapping of another document, where it keeps its position; `note` goes behind that.
  TreeEntry grafted(std::string key, const std::string& note = {}) const;

  /// The document with the value at a dotted path of keys replaced or added: with_value("time.cycles", "1").
  Node with_value(const std::string& dotted, const std::string& yaml) const;

  /// Throws UserError "case.yaml:12:5: network.blocks.dao.Rp: <sentence>".
  template <class... Args>
  [[noreturn]] void error(fmt::format_string<Args...> sentence, Args&&... args) const {
    throw UserError(message(fmt::format(sentence, std::forward<Args>(args)...)));
  }
  std::string message(const std::string& sentence) const;

  /// Throws UserError when a key of this mapping is not among `allowed`, with the nearest valid name.
  void check_keys(const std::vector<std::string>& allowed) const;

  /// "a mapping", "a list", "the value "5 mmHg"", "nothing": for error texts.
  std::string describe() const;

 private:
  Node child(const std::string& step, TreePtr tree, int line, int column) const;
  TreePtr tree_;
  std::string file_, path_, note_;
  int line_ = 1, column_ = 1;
};

}  // namespace ostium::config
