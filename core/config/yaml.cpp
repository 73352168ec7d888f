// Builds the tree from the parser's events: unlike a loaded YAML::Node these show keys given twice and the
// position of each key, and an alias stays one shared tree however often it is used.
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <map>
#include <sstream>

#include "core/config/tree.hpp"
#include "core/error.hpp"

namespace ostium::config {
namespace {

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
    auto tree = start(mark, Tree::Kind::scalar);
    tree->text = value;
    tree->quoted = tag == "!";
    put(std::move(tree), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto known = anchors_.find(anchor);
    if (known == anchors_.end())
      fail(mark, "this alias stands inside the value it refers to; name another anchor");
    put_value(known->second, mark);
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
    bool has_key = false;
  };

  static std::shared_ptr<Tree> start(const YAML::Mark& mark, Tree::Kind kind) {
    auto tree = std::make_shared<Tree>();
    tree->kind = kind, tree->line = mark.line + 1, tree->column = mark.column + 1;
    return tree;
  }

  void open(const YAML::Mark& mark, Tree::Kind kind, YAML::anchor_t anchor) {
    frames_.push_back({start(mark, kind), anchor, mark});
  }

  void close() {
    const Frame frame = std::move(frames_.back());
    frames_.pop_back();
    put(frame.tree, frame.anchor);
  }

  void put(std::shared_ptr<Tree> tree, YAML::anchor_t anchor) {
    if (anchor) anchors_[anchor] = tree;
    YAML::Mark mark;
    mark.line = tree->line - 1, mark.column = tree->column - 1;
    put_value(std::move(tree), mark);
  }

  void put_value(TreePtr tree, const YAML::Mark& mark) {
    if (frames_.empty()) {
      root_ = std::move(tree);
      return;
    }
    Frame& frame = frames_.back();
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
    for (const auto& other : frame.tree->entries)
      if (other.key == word)
        fail(mark, fmt::format(
                       "{}: the name \"{}\" is given twice, first at {}:{}:{}; rename or delete one of them",
                       path_to(word), word, file_, other.line, other.column));
    frame.tree->entries.push_back({word, mark.line + 1, mark.column + 1, nullptr});
    frame.has_key = true;
  }

  std::string path_to(const std::string& key) const {
    std::string path;
    for (std::size_t i = 0; i + 1 < frames_.size(); ++i) path += step_of(*frames_[i].tree) + ".";
    return path + key;
  }
  static std::string step_of(const Tree& tree) {
    return tree.kind == Tree::Kind::map ? tree.entries.back().key : std::to_string(tree.items.size());
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
  std::map<YAML::anchor_t, TreePtr> anchors_;
};

}  // namespace

TreePtr parse_yaml(const std::string& text, const std::string& file_name) {
  std::istringstream stream(text);
  TreeBuilder builder(file_name), rest(file_name);
  try {
    YAML::Parser parser(stream);
    parser.HandleNextDocument(builder);
    if (parser.HandleNextDocument(rest) && rest.root() && rest.root()->kind != Tree::Kind::null)
      user_error("{}:{}:1: a second YAML document begins here; one file holds one document", file_name,
                 rest.root()->line);
  } catch (const YAML::Exception& e) {
    user_error("{}:{}:{}: this is not valid YAML: {}", file_name, e.mark.line + 1, e.mark.column + 1, e.msg);
  }
  return builder.root() ? builder.root() : std::make_shared<Tree>();
}

}  // namespace ostium::config
