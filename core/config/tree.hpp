/// A YAML document as plain data: scalars, lists and mappings in file order with their positions.
#pragma once
#include <memory>
#include <string>
#include <vector>

namespace ostium::config {

struct Tree;
using TreePtr = std::shared_ptr<const Tree>;

struct TreeEntry {
  std::string key;
  int line = 0, column = 0;  // of the key
  TreePtr value;
};

/// Where a value comes from that stands in another document than the one around it.
struct Origin {
  std::string file;
  std::string note;  // " (used at case.yaml:6:3)", goes behind every position
};

struct Tree {
  enum class Kind { null, scalar, list, map };
  Kind kind = Kind::null;
  std::string text;                // of a scalar
  std::vector<TreePtr> items;      // of a list
  std::vector<TreeEntry> entries;  // of a mapping
  int line = 0, column = 0;        // from 1; 0: made by the program
  bool quoted = false;
  std::shared_ptr<const Origin> origin = nullptr;  // nothing: the document around it

  static Tree scalar(std::string text);
  static Tree list(std::vector<Tree> items = {});
  static Tree map();
  Tree& add(std::string key, Tree value);  // to a mapping; returns *this
  const Tree* find(const std::string& key) const;
};

/// The first document in `text`; throws UserError "file:line:column: ..." for broken YAML and keys given
/// twice.
TreePtr parse_yaml(const std::string& text, const std::string& file_name);

/// YAML text: mappings in block style, lists of scalars on one line.
std::string to_yaml(const Tree& tree);

/// One line, as it would be written inside a flow list or mapping.
std::string to_text(const Tree& tree);

}  // namespace ostium::config
