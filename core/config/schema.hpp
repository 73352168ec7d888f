/// JSON schema (draft 2020-12) of a struct with declared fields, for editors that complete and check YAML.
#pragma once
#include <nlohmann/json.hpp>

#include "core/config.hpp"

namespace ostium::config {

nlohmann::json schema_of(const Description& fields, const std::vector<std::string>& also_allowed = {});

template <class S>
nlohmann::json schema() {
  return schema_of(describe<S>());
}

}  // namespace ostium::config
