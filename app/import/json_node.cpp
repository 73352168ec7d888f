#include "app/import/json_node.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "core/did_you_mean.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace ostium::app {
namespace {

using Json = JsonNode::Json;

/// Remembers the keys of the open objects: the library itself keeps the last of two equal ones without a word.
class DoubledKeys {
 public:
  bool operator()(int, Json::parse_event_t event, Json& parsed) {
    using Event = Json::parse_event_t;
    if (event == Event::value || event == Event::object_start || event == Event::array_start) count();
    if (event == Event::object_start || event == Event::array_start)
      open_.push_back({.list = event == Event::array_start});
    if (event == Event::object_end || event == Event::array_end) open_.pop_back();
    if (event == Event::key) enter(parsed.get<std::string>());
    return true;
  }
  std::optional<std::string> doubled;  // its path

 private:
  struct Open {
    bool list;
    int items = 0;
    std::set<std::string> keys = {};
    std::string key = {};
  };

  void count() {
    if (!open_.empty()) ++open_.back().items;
  }
  void enter(const std::string& key) {
    open_.back().key = key;
    const bool comment = key.starts_with("_");
    if (!open_.back().keys.insert(key).second && !comment && !doubled) doubled = path();
  }
  std::string path() const {
    std::string text;
    for (const auto& o : open_)
      text += o.list ? fmt::format("[{}]", o.items - 1) : (text.empty() ? "" : ".") + o.key;
    return text;
  }

  std::vector<Open> open_;
};

/// "line 3, column 5: .." of the library's sentence, which begins with its own name.
std::string reason(const std::string& what) {
  const auto line = what.find("line "), name = what.find("] ");
  return line != std::string::npos   ? what.substr(line)
         : name != std::string::npos ? what.substr(name + 2)
                                     : what;
}

/// Of the brackets outside texts; the parser itself has no bound.
int depth_of(const std::string& text) {
  int depth = 0, most = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') quoted = !quoted;
    if (quoted && c == '\\') ++i;
    if (!quoted) most = std::max(most, depth += (c == '{' || c == '[') - (c == '}' || c == ']'));
  }
  return most;
}

}  // namespace

JsonNode JsonNode::load(const std::filesystem::path& file) {
  return parse(read_text_file(file), file.string());
}

JsonNode JsonNode::parse(const std::string& text, const std::string& file_name) {
  constexpr int deepest = 64;  // the format has six levels
  if (const int depth = depth_of(text); depth > deepest)
    user_error("{}: nested {} deep, at most {} is allowed", file_name, depth, deepest);
  DoubledKeys keys;
  JsonNode root;
  root.file_ = file_name;
  try {
    root.document_ = std::make_shared<const Json>(Json::parse(text, std::ref(keys)));
  } catch (const Json::exception& e) {
    user_error("{}: this is no valid JSON: {}", file_name, printable(reason(e.what())));
  }
  root.value_ = root.document_.get();
  if (keys.doubled) root.error("{}: this key is given twice in one object; drop one of them", *keys.doubled);
  if (!root.is_object()) root.error("expected an object {{..}} at the top, found {}", root.describe());
  return root;
}

bool JsonNode::is_object() const { return value_->is_object(); }
bool JsonNode::is_list() const { return value_->is_array(); }

JsonNode JsonNode::child(const std::string& step, const Json& value) const {
  JsonNode node = *this;
  node.value_ = &value;
  node.path_ = path_.empty() || step[0] == '[' ? path_ + step : path_ + "." + step;
  return node;
}

std::optional<JsonNode> JsonNode::find(const std::string& key) const {
  if (!is_object()) error("expected an object {{..}} with the key \"{}\", found {}", key, describe());
  const auto at = value_->find(key);
  if (at == value_->end()) return std::nullopt;
  return child(key, *at);
}

JsonNode JsonNode::at(const std::string& key) const {
  if (auto found = find(key)) return *found;
  std::vector<std::string> keys;
  for (const auto& [name, value] : value_->items()) keys.push_back(name);
  const auto near = nearest_name(key, keys);
  error("the key \"{}\" is missing{}", key, near ? "; is it \"" + *near + "\"?" : "");
}

std::vector<JsonNode> JsonNode::items() const {
  if (!is_list()) error("expected a list [..], found {}", describe());
  std::vector<JsonNode> all;
  for (std::size_t i = 0; i < value_->size(); ++i) all.push_back(child(fmt::format("[{}]", i), (*value_)[i]));
  return all;
}

std::vector<std::pair<std::string, JsonNode>> JsonNode::entries() const {
  if (!is_object()) error("expected an object {{..}}, found {}", describe());
  std::vector<std::pair<std::string, JsonNode>> all;
  for (const auto& [key, value] : value_->items()) all.emplace_back(key, child(key, value));
  return all;
}

std::vector<JsonNode> JsonNode::items_at(const std::string& key) const {
  const auto list = find(key);
  return list ? list->items() : std::vector<JsonNode>{};
}

double JsonNode::number() const {
  if (!value_->is_number()) error("expected a number, found {}", describe());
  const double v = value_->get<double>();
  if (!std::isfinite(v)) error("expected a finite number, found {}", describe());
  return v;
}

double JsonNode::positive() const {
  const double v = number();
  if (!(v > 0)) error("must be > 0, found {}", shortest(v));
  return v;
}

double JsonNode::non_negative() const {
  const double v = number();
  if (!(v >= 0)) error("must be >= 0, found {}", shortest(v));
  return v;
}

int JsonNode::integer_at_least(int least) const {
  const double v = number();
  constexpr double most = 1e9;
  if (v != std::floor(v) || v > most) error("expected a whole number, found {}", describe());
  if (v < least) error("must be at least {}, found {}", least, shortest(v));
  return static_cast<int>(v);
}

bool JsonNode::flag() const {
  if (!value_->is_boolean()) error("expected true or false, found {}", describe());
  return value_->get<bool>();
}

std::string JsonNode::text() const {
  if (!value_->is_string()) error("expected a text, found {}", describe());
  if (value_->get_ref<const std::string&>().empty()) error("expected a text, found an empty one");
  return value_->get<std::string>();
}

std::vector<double> JsonNode::numbers() const {
  if (!is_list()) return {number()};
  std::vector<double> all;
  for (const auto& item : items()) all.push_back(item.number());
  return all;
}

std::vector<std::string> JsonNode::texts() const {
  std::vector<std::string> all;
  for (const auto& item : items()) all.push_back(item.text());
  return all;
}

double JsonNode::number(const std::string& key, double or_else) const {
  const auto found = find(key);
  return found ? found->number() : or_else;
}

bool JsonNode::flag(const std::string& key, bool or_else) const {
  const auto found = find(key);
  return found ? found->flag() : or_else;
}

JsonNode JsonNode::labelled(const std::string& label) const {
  JsonNode node = *this;
  node.path_ += " (" + label + ")";
  return node;
}

void JsonNode::check_keys(const std::vector<std::string>& allowed) const {
  for (const auto& [key, node] : entries())
    if (!key.starts_with("_") && std::find(allowed.begin(), allowed.end(), key) == allowed.end())
      node.error("there is no such key{}", did_you_mean(key, allowed));
}

std::string JsonNode::where() const { return path_.empty() ? file_ : file_ + ": " + path_; }

std::string JsonNode::message(const std::string& sentence) const {
  return printable(where() + ": " + sentence);
}

std::string JsonNode::describe() const {
  if (value_->is_object()) return "an object";
  if (value_->is_array()) return "a list";
  if (value_->is_null()) return "null";
  const std::string text = value_->dump(-1, ' ', false, Json::error_handler_t::replace);
  return (value_->is_string()    ? "the text "
          : value_->is_boolean() ? "the value "
                                 : "the number ") +
         shown(text);
}

}  // namespace ostium::app
