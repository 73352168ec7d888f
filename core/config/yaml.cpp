// Builds the tree from the parser's events: unlike a loaded YAML::Node these show keys given twice and the
// position of each key, and an alias stays one shared tree however often it is used. Whoever walks the tree meets that
// one each time, so that a few lines of aliases of aliases could stand for billions of values: these are counted.
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <unordered_set>

#include "core/config/tree.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace ostium::config {
namespace {

constexpr int deepest = 64;         // a case has some ten levels
constexpr long most_aliased = 1e5;  // values

/// Of a tree: values, those of them met through aliases, levels.
struct Size {
  long values = 1, aliased = 0;
  int depth = 1;
};

class TreeBuilder final : public YAML::EventHandler {
 public:
  explicit TreeBuilder(const std::string& file) : file_(file) {}
  TreePtr root() const { return root_; }

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    put(start(mark, Tree::Kind::null), anchor);
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    if (first_bad_byte(value) != std::string::npos)
      fail(mark, "this text holds a control character; leave it out");
    auto tree = start(mark, Tree::Kind::scalar);
    tree->text = value;
    tree->quoted = tag == "!";
    put(std::move(tree), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto known = anchors_.find(anchor);
    if (known == anchors_.end())
      fail(mark, "this alias stands inside the value it refers to; name another anchor");
    const auto& [tree, size] = known->second;
    put_value(tree, {.values = size.values, .aliased = size.values, .depth = size.depth}, mark);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, Tree::Kind::list, anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, Tree::Kind::map, anchor);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapEnd() override {
    merge_defaults(*frames_.back().tree);
    close();
  }

 private:
  struct Frame {
    std::shared_ptr<Tree> tree;
    YAML::anchor_t anchor;
    YAML::Mark mark;
    Size size = {};
    std::unordered_set<std::string> keys = {};
    bool has_key = false;
  };

  static std::shared_ptr<Tree> start(const YAML::Mark& mark, Tree::Kind kind) {
    auto tree = std::make_shared<Tree>();
    tree->kind = kind, tree->line = mark.line + 1, tree->column = mark.column + 1;
    return tree;
  }

  void open(const YAML::Mark& mark, Tree::Kind kind, YAML::anchor_t anchor) {
    frames_.push_back({.tree = start(mark, kind), .anchor = anchor, .mark = mark});
    check_depth(static_cast<int>(frames_.size()), mark);
  }

  void close() {
    const Frame frame = std::move(frames_.back());
    frames_.pop_back();
    put(frame.tree, frame.anchor, frame.size);
  }

  void put(std::shared_ptr<Tree> tree, YAML::anchor_t anchor, const Size& size = {}) {
    if (anchor) anchors_[anchor] = {tree, size};
    YAML::Mark mark;
    mark.line = tree->line - 1, mark.column = tree->column - 1;
    put_value(std::move(tree), size, mark);
  }

  void grow(Size& around, const Size& size, const YAML::Mark& mark) const {
    around.values += size.values, around.aliased += size.aliased;
    around.depth = std::max(around.depth, size.depth + 1);
    check_depth(static_cast<int>(frames_.size()) + size.depth, mark);
    if (around.aliased > most_aliased)
      fail(mark,
           fmt::format("the aliases up to here stand for more than {} values; write fewer", most_aliased));
  }

  void check_depth(int depth, const YAML::Mark& mark) const {
    if (depth > deepest) fail(mark, fmt::format("nested more than {} deep; a case needs far less", deepest));
  }

  void put_value(TreePtr tree, const Size& size, const YAML::Mark& mark) {
    if (frames_.empty()) {
      root_ = std::move(tree);
      return;
    }
    Frame& frame = frames_.back();
    grow(frame.size, size, mark);
    if (frame.tree->kind == Tree::Kind::list) {
      frame.tree->items.push_back(std::move(tree));
    } else if (frame.has_key) {
      frame.tree->entries.back().value = std::move(tree);
      frame.has_key = false;
    } else {
      put_key(frame, *tree, mark);
    }
  }

  void put_key(Frame& frame, const Tree& key, const YAML::Mark& mark) {
    if (key.kind != Tree::Kind::scalar && key.kind != Tree::Kind::null)
      fail(mark, "a key must be a single word");
    const std::string word = key.kind == Tree::Kind::null ? "~" : key.text;
    constexpr std::size_t longest = 200;
    if (word.empty() || word.size() > longest || word.find('\n') != std::string::npos)
      fail(mark,
           fmt::format("\"{}\" is no name; a name is one line of 1 to {} characters", shown(word), longest));
    if (!frame.keys.insert(word).second) refuse_second(frame, word, mark);
    frame.tree->entries.push_back({word, mark.line + 1, mark.column + 1, nullptr});
    frame.has_key = true;
  }

  [[noreturn]] void refuse_second(const Frame& frame, const std::string& word, const YAML::Mark& mark) const {
    const auto& entries = frame.tree->entries;
    const auto first =
        std::find_if(entries.begin(), entries.end(), [&](const TreeEntry& e) { return e.key == word; });
    fail(mark,
         fmt::format("{}: the name \"{}\" is given twice, first at {}:{}:{}; rename or delete one of them",
                     path_to(shown(word)), shown(word), file_, first->line, first->column));
  }

  std::string path_to(const std::string& key) const {
    std::string path;
    for (std::size_t i = 0; i + 1 < frames_.size(); ++i) path += step_of(*frames_[i].tree) + ".";
    return path + key;
  }
  static std::string step_of(const Tree& tree) {
    if (tree.kind == Tree::Kind::list) return std::to_string(tree.items.size());
    return tree.entries.empty() ? "?" : tree.entries.back().key;  // empty: within its first key
  }

  /// `<<: *defaults` takes over the keys of another mapping that are not given here.
  static void merge_defaults(Tree& map) {
    const Tree* merge = map.find("<<");
    if (!merge || merge->kind != Tree::Kind::map) return;
    const auto inherited = merge->entries;
    std::erase_if(map.entries, [](const TreeEntry& e) { return e.key == "<<"; });
    for (const auto& entry : inherited)
      if (!map.find(entry.key)) map.entries.push_back(entry);
  }

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    user_error("{}:{}:{}: {}", file_, mark.line + 1, mark.column + 1, what);
  }

  std::string file_;
  TreePtr root_;
  std::vector<Frame> frames_;
  std::map<YAML::anchor_t, std::pair<TreePtr, Size>> anchors_;
};

/// The library says of them what they lead to, not what they are.
std::string hint_of_tabulators(const std::string& text) {
  std::istringstream stream(text);
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number)
    if (const auto first = line.find_first_not_of(' '); first != std::string::npos && line[first] == '\t')
      return fmt::format("; line {} is indented with a tabulator, write blanks", number);
  return {};
}

/// The library takes the control character 4 for the end of the file and passes on what is no UTF-8.
void check_bytes(const std::string& text, const std::string& file_name) {
  const std::size_t at = first_bad_byte(text);
  if (at == std::string::npos) return;
  const auto line_end = [](char c) { return c == '\n'; };
  const auto line = std::count_if(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), line_end);
  const auto begin = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  user_error("{}:{}:{}: the byte 0x{:02x} belongs to no text; save the file as text in UTF-8", file_name,
             line + 1, at - (begin == std::string::npos ? 0 : begin + 1) + 1,
             static_cast<unsigned char>(text[at]));
}

/// What yaml-cpp says. It shows the end of the text as the character 4, which stands in no text that is parsed, and the
/// first byte only of a character that has several.
std::string printable_message(std::string message) {
  for (std::size_t at; (at = message.find('\x04')) != std::string::npos;)
    message.replace(at, 1, "the end of the text");
  return printable(message);
}

}  // namespace

TreePtr parse_yaml(const std::string& text, const std::string& file_name) {
  check_bytes(text, file_name);
  std::istringstream stream(text);
  TreeBuilder builder(file_name), rest(file_name);
  try {
    YAML::Parser parser(stream);
    parser.HandleNextDocument(builder);
    if (parser.HandleNextDocument(rest) && rest.root() && rest.root()->kind != Tree::Kind::null)
      user_error("{}:{}:1: a second YAML document begins here; one file holds one document", file_name,
                 rest.root()->line);
  } catch (const YAML::Exception& e) {
    user_error("{}:{}:{}: this is not valid YAML: {}{}", file_name, e.mark.line + 1, e.mark.column + 1,
               printable_message(e.msg), hint_of_tabulators(text));
  }
  return builder.root() ? builder.root() : std::make_shared<Tree>();
}

}  // namespace ostium::config
