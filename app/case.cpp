#include "app/case.hpp"

#include <utility>

#include "network/subnetwork.hpp"

namespace ostium::app {

network::Initial Case::initial() const {
  if (network.initial) return *network.initial;
  return network.periodic.value_or(time.period.has_value()) ? network::Initial::periodic
                                                            : network::Initial::rest;
}

namespace {

/// An interval mistaken by orders of magnitude fills a disk before anybody notices.
void check_rows(const Case& study) {
  constexpr double most = 1e8;  // some 10 GB of text
  const double rows = study.time.final() / study.output.every;
  if (rows <= most) return;
  const auto output = study.origin.find("output");
  const auto every = output ? output->find("every") : std::nullopt;
  every.value_or(study.origin)
      .error(
          "a row every {:.3g} s until {:.3g} s makes {:.2g} rows, at most {:.0e} are allowed; choose {:.2g} "
          "s or more",
          study.output.every, study.time.final(), rows, most, study.time.final() / (0.99 * most));
}

void check_probes(const Case& study) {
  if (study.output.probes.empty() || study.vessel) return;
  study.output.probes.front().second.origin.error(
      "probes are points of a vessel, and this case has none; remove them: pressures and flows of the "
      "network are in network.csv");
}

}  // namespace

Case read_case(const std::filesystem::path& file, const Overrides& overrides) {
  config::Node node = config::Node::load(file);
  if (overrides.surface)
    node = node.with_value("vessel.surface", config::to_yaml(config::write_path(*overrides.surface)));
  for (const auto& [path, value] : overrides.values) node = node.with_value(path, value);
  Case study = config::read<Case>(node);
  study.network.blocks = network::expand(study.network.blocks, std::exchange(study.network.subnetworks, {}));
  if (study.initial() == network::Initial::periodic && !study.time.period)
    study.origin.at("network")
        .at(study.network.initial ? "initial" : "periodic")
        .error("a start from the periodic state needs \"time.period\"; add it, or choose \"rest\"");
  check_rows(study);
  check_probes(study);
  return study;
}

std::string case_name(const std::filesystem::path& file) {
  const auto absolute = std::filesystem::absolute(file).lexically_normal();
  return (absolute.stem() == "case" ? absolute.parent_path().filename() : absolute.stem()).string();
}

}  // namespace ostium::app
