#include "app/case.hpp"

namespace ostium::app {

network::Initial Case::initial() const {
  return network.initial.value_or(time.period ? network::Initial::periodic : network::Initial::rest);
}

Case read_case(const std::filesystem::path& file, const Overrides& overrides) {
  config::Node node = config::Node::load(file);
  if (overrides.surface)
    node = node.with_value("vessel.surface", config::to_yaml(config::write_path(*overrides.surface)));
  for (const auto& [path, value] : overrides.values) node = node.with_value(path, value);
  const Case study = config::read<Case>(node);
  if (study.network.initial == network::Initial::periodic && !study.time.period)
    study.origin.at("network").at("initial").error(
        "a start from the periodic state needs \"time.period\"; add it, or choose \"rest\"");
  return study;
}

std::string case_name(const std::filesystem::path& file) {
  const auto absolute = std::filesystem::absolute(file).lexically_normal();
  return (absolute.stem() == "case" ? absolute.parent_path().filename() : absolute.stem()).string();
}

}  // namespace ostium::app
