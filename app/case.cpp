#include "app/case.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/log.hpp"
#include "network/subnetwork.hpp"

namespace ostium::app {

network::Initial Case::initial() const {
  if (network.initial) return *network.initial;
  return network.periodic.value_or(time.period.has_value()) ? network::Initial::periodic
                                                            : network::Initial::rest;
}

namespace {

config::Node output_key(const Case& study, const char* key) {
  const auto output = study.origin.find("output");
  const auto given = output && output->is_map() ? output->find(key) : std::nullopt;
  return given.value_or(study.origin);
}

/// An interval mistaken by orders of magnitude fills a disk before anybody notices.
void check_rows(const Case& study) {
  if (study.output.from >= study.time.final())  // no error: sensitivities need no rows
    log::warn("{}",
              output_key(study, "from")
                  .message(fmt::format("{:g} s is not before the end of the run at {:g} s: no row is written",
                                       study.output.from, study.time.final())));
  constexpr double most = 1e8;  // some 10 GB of text
  const double rows = study.time.final() / study.output.every;
  if (rows <= most) return;
  output_key(study, "every")
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

/// The integration stops at every kink of a waveform: a period mistaken by orders of magnitude would never end.
void check_period(const config::Node& node, double length, std::optional<double> beat) {
  constexpr double most = 1e6, round_off = 1e-6;
  const double period = config::read_quantity(node, {.unit = "s"});
  if (!(period > 0)) return;  // its reader refuses it
  if (length > most * period)
    node.error(
        "{} goes {:.2g} times into the run of {:g} s, at most {:g} times are allowed; look at its unit",
        node.text(), length / period, length, most);
  if (const double n = beat.value_or(0) / period; std::abs(n - std::round(n)) > round_off * n)
    node.error(
        "{} does not divide the period of the beat, {:g} s (time.period), so that no state repeats; correct "
        "one of "
        "them, or start the network from rest (network.initial)",
        node.text(), *beat);
}

void check_periods(const config::Node& blocks, double length, std::optional<double> beat) {
  if (!blocks.is_map()) return;
  for (const auto& [key, value] : blocks.entries())
    if (key == "period" && value.is_scalar())
      check_period(value, length, beat);
    else
      check_periods(value, length, beat);
}

}  // namespace

Case read_case(const std::filesystem::path& file, const Overrides& overrides) {
  return read_case(config::Node::load(file), overrides);
}

Case read_case(const config::Node& document, const Overrides& overrides) {
  config::Node node = document;
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
  const bool periodic = study.initial() == network::Initial::periodic;
  check_periods(study.network.blocks, std::max(study.time.final(), study.time.period.value_or(0)),
                periodic ? study.time.period : std::nullopt);
  return study;
}

std::string case_name(const std::filesystem::path& file) {
  const auto absolute = std::filesystem::absolute(file).lexically_normal();
  return (absolute.stem() == "case" ? absolute.parent_path().filename() : absolute.stem()).string();
}

}  // namespace ostium::app
