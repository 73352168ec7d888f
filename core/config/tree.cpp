#include "core/config/tree.hpp"

#include <yaml-cpp/emitter.h>

#include <algorithm>
#include <string_view>

namespace ostium::config {
namespace {

bool is_flat(const Tree& list) {
  return std::none_of(list.items.begin(), list.items.end(),
                      [](const auto& i) { return i->kind == Tree::Kind::map; });
}

bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Words and numbers with units, that nothing in YAML can take for something else. What is not sure is not among them.
bool is_plain(const std::string& text) {
  constexpr std::size_t longest = 200;
  const std::size_t begin = text.starts_with('-');
  if (text.size() <= begin || text.size() > longest || !is_word(text[begin])) return false;
  if (begin && !(text[1] >= '0' && text[1] <= '9')) return false;
  for (std::size_t i = begin; i < text.size(); ++i) {
    const char c = text[i];
    const bool joins = c == ' ' || c == ':';  // a word must follow
    if (joins && (i + 1 == text.size() || !is_word(text[i + 1]))) return false;
    if (!joins && !is_word(c) && c != '.' && c != '/' && c != '+' && c != '-') return false;
  }
  return text != "null" && text != "Null" && text != "NULL";
}

/// The emitter matches every text against the grammar, at more cost than all else: it is spared what is plain.
void write_scalar(YAML::Emitter& out, const std::string& text) {
  if (is_plain(text))
    out.WriteIntegralType(std::string_view(text));  // writes what a stream would, as it is
  else
    out << text;
}

void write(YAML::Emitter& out, const Tree& tree);

void write_list(YAML::Emitter& out, const Tree& list) {
  if (is_flat(list)) out << YAML::Flow;
  out << YAML::BeginSeq;
  for (const auto& item : list.items) write(out, *item);
  out << YAML::EndSeq;
}

void write_map(YAML::Emitter& out, const Tree& map) {
  if (map.entries.empty()) out << YAML::Flow;
  out << YAML::BeginMap;
  for (const auto& entry : map.entries) {
    out << YAML::Key;
    write_scalar(out, entry.key);
    out << YAML::Value;
    write(out, *entry.value);
  }
  out << YAML::EndMap;
}

void write(YAML::Emitter& out, const Tree& tree) {
  switch (tree.kind) {
    case Tree::Kind::null:
      out << YAML::Null;
      break;
    case Tree::Kind::scalar:
      if (tree.quoted)
        out << YAML::DoubleQuoted << tree.text;
      else
        write_scalar(out, tree.text);
      break;
    case Tree::Kind::list:
      write_list(out, tree);
      break;
    case Tree::Kind::map:
      write_map(out, tree);
      break;
  }
}

}  // namespace

Tree Tree::scalar(std::string text) {
  Tree t;
  t.kind = Kind::scalar;
  t.text = std::move(text);
  return t;
}

Tree Tree::list(std::vector<Tree> items) {
  Tree t;
  t.kind = Kind::list;
  for (auto& item : items) t.items.push_back(std::make_shared<Tree>(std::move(item)));
  return t;
}

Tree Tree::map() {
  Tree t;
  t.kind = Kind::map;
  return t;
}

Tree& Tree::add(std::string key, Tree value) {
  entries.push_back({std::move(key), 0, 0, std::make_shared<Tree>(std::move(value))});
  return *this;
}

const Tree* Tree::find(const std::string& key) const {
  for (const auto& entry : entries)
    if (entry.key == key) return entry.value.get();
  return nullptr;
}

std::string to_yaml(const Tree& tree) {
  YAML::Emitter out;
  write(out, tree);
  return std::string(out.c_str()) + "\n";
}

std::string to_text(const Tree& tree) {
  YAML::Emitter out;
  out.SetMapFormat(YAML::Flow);
  out.SetSeqFormat(YAML::Flow);
  write(out, tree);
  std::string text = out.c_str();
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

}  // namespace ostium::config
