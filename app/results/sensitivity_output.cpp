#include "app/results/sensitivity_output.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/csv.hpp"

namespace ostium::app {
namespace {

using nlohmann::json;

network::SensitivityRun run_of(const Case& study) {
  return {.end = study.time.final(), .period = study.time.period.value_or(0), .initial = study.initial()};
}

double relative(double derivative, double parameter, double index) {
  return index != 0 ? derivative * std::abs(parameter / index) : 0.0;
}

}  // namespace

Sought sought(const Case& study, const network::Model& model, const std::vector<std::string>& series) {
  Sought s;
  if (!study.sensitivities) return s;
  const auto& asked = *study.sensitivities;
  const auto where = [&](const char* key) { return asked.origin.where() + ": sensitivities." + key; };
  if (study.vessel)
    asked.origin.error(
        "sensitivities are those of a network alone, this case has a vessel; leave one of the two out");
  for (const auto& text : asked.of) s.of.push_back(network::read_index(text, series, where("of")));
  for (const auto& name : asked.to) s.to.push_back(network::parameter(model, name, where("to")));
  return s;
}

json write_sensitivities(const Case& study, const network::Model& model, const Sought& sought,
                         const ResultsFolder& folder) {
  const auto found = network::sensitivities(model, sought.of, sought.to, run_of(study));
  CsvWriter csv(folder.file("sensitivities.csv"), {"index", "unit", "value", "parameter", "parameter_unit",
                                                   "parameter_value", "derivative", "relative"});
  json all = json::array();
  for (std::size_t i = 0; i < sought.of.size(); ++i) {
    const auto& index = sought.of[i];
    json entry = {
        {"index", index.text}, {"unit", index.unit}, {"value", found.values[i]}, {"to", json::object()}};
    for (std::size_t k = 0; k < sought.to.size(); ++k) {
      const auto& p = sought.to[k];
      const double derivative = found.gradients(i, k), share = relative(derivative, p.value, found.values[i]);
      csv << index.text << index.unit << found.values[i] << p.name << p.unit << p.value << derivative
          << share;
      csv.end_row();
      entry["to"][p.name] = {{"derivative", derivative}, {"relative", share}, {"parameter_unit", p.unit}};
    }
    all.push_back(entry);
  }
  return all;
}

json periodic_json(const network::PeriodicReport& report) {
  json residuals = json::object();
  for (const auto& r : report.residuals)
    residuals[r.state] = {{"change_SI", r.change}, {"relative", r.relative}};
  return {{"method", report.method},
          {"cycle_integrations", report.cycle_integrations},
          {"change_per_cycle", report.change},
          {"conserved_quantities", report.invariants},
          {"residuals", residuals}};
}

std::string periodic_line(const network::PeriodicReport& report) {
  const network::PeriodicReport::Residual* worst = nullptr;
  for (const auto& r : report.residuals)
    if (!worst || std::abs(r.relative) > std::abs(worst->relative)) worst = &r;
  return fmt::format(
      "periodic state after {} integrated cycle{} ({}){}", report.cycle_integrations,
      report.cycle_integrations == 1 ? "" : "s", report.method,
      worst ? fmt::format("; before the last correction {} changed most, by {:.2g} of its scale per cycle",
                          worst->state, std::abs(worst->relative))
            : "");
}

}  // namespace ostium::app
