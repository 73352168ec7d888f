#include "app/import/json_node.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "core/did_you_mean.hpp"
#include "core/units.hpp"

namespace ostium::app {
namespace {

using Json = JsonNode::Json;

/// Remembers the keys of the open objects: the library itself keeps the last of two equal ones without a word.
class DoubledKeys {
 public:
  bool operator()(int, Json::parse_event_t event, Json& parsed) {
    if (event == Json::parse_event_t::object_start) open_.emplace_back();
    if (event == Json::parse_event_t::object_end) open_.pop_back();
    if (event != Json::parse_event_t::key) return true;
    const auto key = parsed.get<std::string>();
    const bool comment = key.starts_with("_");
    if (!open_.back().insert(key).second && !comment && !doubled) doubled = key;
    return true;
  }
  std::optional<std::string> doubled;

 private:
  std::vector<std::set<std::string>> open_;
};

/// "line 3, column 5: .." of the library's sentence, which begins with its own name.
std::string reason(const std::string& what) {
  const auto at = what.find("line ");
  return at == std::string::npos ? what : what.substr(at);
}

std::string content_of(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file))
    user_error("{}: there is no such file; name the JSON file of the model", file.string());
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

}  // namespace

JsonNode JsonNode::load(const std::filesystem::path& file) { return parse(content_of(file), file.string()); }

JsonNode JsonNode::parse(const std::string& text, const std::string& file_name) {
  constexpr int deepest = 64;  // the format has six levels; the parser itself has no bound
  int depth = 0, most = 0;
  for (char c : text) most = std::max(most, depth += (c == '{' || c == '[') - (c == '}' || c == ']'));
  if (most > deepest) user_error("{}: nested {} deep, at most {} is allowed", file_name, most, deepest);
  DoubledKeys keys;
  JsonNode root;
  root.file_ = file_name;
  try {
    root.document_ = std::make_shared<const Json>(Json::parse(text, std::ref(keys)));
  } catch (const Json::exception& e) {
    user_error("{}: this is no valid JSON: {}", file_name, reason(e.what()));
  }
  root.value_ = root.document_.get();
  if (keys.doubled)
    root.error("the key \"{}\" is given twice in one object; drop one of them", *keys.doubled);
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

std::string JsonNode::describe() const {
  if (value_->is_object()) return "an object";
  if (value_->is_array()) return "a list";
  if (value_->is_null()) return "null";
  return (value_->is_string()    ? "the text "
          : value_->is_boolean() ? "the value "
                                 : "the number ") +
         value_->dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace ostium::app
