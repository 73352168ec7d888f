/// A place in a JSON document that knows its path, for files other programs wrote: every error names file and path.
///
///   const auto file = JsonNode::load("model.json");
///   const double Rp = file.at("boundary_conditions").items()[1].at("bc_values").at("Rp").number();
///   // UserError: model.json: boundary_conditions[1].bc_values.Rp: expected a number, found the text "high"
///
/// Refused: broken JSON and keys given twice (with line and column), missing keys, wrong kinds, numbers that are not
/// finite. Not checked here: ranges and units, which the format does not have.
#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace ostium::app {

class JsonNode {
 public:
  using Json = nlohmann::ordered_json;

  static JsonNode load(const std::filesystem::path& file);
  static JsonNode parse(const std::string& text, const std::string& file_name = "model.json");

  const std::string& path() const { return path_; }
  const Json& json() const { return *value_; }
  bool is_object() const;
  bool is_list() const;

  std::optional<JsonNode> find(const std::string& key) const;  // in an object
  JsonNode at(const std::string& key) const;
  std::vector<JsonNode> items() const;                            // of a list
  std::vector<std::pair<std::string, JsonNode>> entries() const;  // of an object, file order
  /// The items of the list at `key`; none where the key is absent.
  std::vector<JsonNode> items_at(const std::string& key) const;

  double number() const;
  double positive() const;
  double non_negative() const;
  int integer_at_least(int least) const;
  bool flag() const;
  std::string text() const;  // not empty
  std::vector<double> numbers() const;
  std::vector<std::string> texts() const;

  double number(const std::string& key, double or_else) const;
  bool flag(const std::string& key, bool or_else) const;

  /// The same place with a label behind its path: vessels[3] (branch0_seg0).
  JsonNode labelled(const std::string& label) const;

  /// Throws UserError where a key is not among `allowed`; keys that begin with `_` are comments.
  void check_keys(const std::vector<std::string>& allowed) const;

  template <class... Args>
  [[noreturn]] void error(fmt::format_string<Args...> sentence, Args&&... args) const {
    throw UserError(message(fmt::format(sentence, std::forward<Args>(args)...)));
  }
  std::string where() const;
  std::string message(const std::string& sentence) const;
  /// "the number 3", "a list": for error texts.
  std::string describe() const;

 private:
  JsonNode child(const std::string& step, const Json& value) const;
  std::shared_ptr<const Json> document_;
  const Json* value_ = nullptr;
  std::string file_, path_;
};

}  // namespace ostium::app
