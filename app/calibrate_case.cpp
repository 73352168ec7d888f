#include "app/calibrate_case.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/effective.hpp"
#include "app/measured.hpp"
#include "core/csv.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "network/calibrate.hpp"
#include "network/model.hpp"
#include "network/network.hpp"
#include "network/simulate.hpp"

namespace ostium::app {
namespace {

using network::Calibration;
using network::FreeParameter;
using network::Target;
using nlohmann::json;

std::vector<Target> targets_of(const CalibrationCase& asked, const network::Model& model) {
  const auto series = network::Network(model).series_names();
  std::vector<Target> all;
  for (const auto& t : asked.targets) {
    const auto index = network::read_index(t.of, series, t.origin.at("of").where() + ": of");
    all.push_back({.index = index,
                   .value = measured(t.origin.at("value"), t.value, index.unit),
                   .tolerance = measured(t.origin.at("tolerance"), t.tolerance, index.unit),
                   .weight = t.weight});
    if (!(all.back().tolerance > 0))
      t.origin.at("tolerance").error("{} is not allowed; it must be > 0", t.tolerance);
  }
  return all;
}

std::vector<FreeParameter> free_of(const CalibrationCase& asked, const network::Model& model) {
  std::vector<FreeParameter> all;
  for (const auto& p : asked.parameters) {
    const auto found = network::parameter(model, p.name, p.origin.at("name").where() + ": name");
    all.push_back({.parameter = found,
                   .low = measured(p.origin.at("low"), p.low, found.unit),
                   .high = measured(p.origin.at("high"), p.high, found.unit),
                   .logarithmic = p.logarithmic});
    if (!(all.back().low < all.back().high))
      p.origin.at("low").error("{} is not below \"high\", which is {}", p.low, p.high);
    if (p.logarithmic && !(all.back().low > 0))
      p.origin.at("low").error(
          "{} is not > 0, which a logarithmic scale needs; raise it, or write \"scale: linear\"", p.low);
  }
  return all;
}

json finite_or_null(double x) { return std::isfinite(x) ? json(x) : json(nullptr); }

json report_of(const Calibration& c, const std::vector<Target>& targets,
               const std::vector<FreeParameter>& free) {
  json all = {{"status", "finished"},
              {"stopped", c.stopped},
              {"runs", c.runs},
              {"steps", c.steps},
              {"misfit_before", c.misfit_before},
              {"misfit", c.misfit}};
  for (std::size_t i = 0; i < targets.size(); ++i)
    all["targets"].push_back({{"of", targets[i].index.text},
                              {"unit", targets[i].index.unit},
                              {"wanted", targets[i].value},
                              {"tolerance", targets[i].tolerance},
                              {"before", c.before[i]},
                              {"after", c.after[i]},
                              {"residual", c.residuals[static_cast<Eigen::Index>(i)]}});
  for (std::size_t j = 0; j < free.size(); ++j)
    all["parameters"].push_back({{"name", free[j].parameter.name},
                                 {"unit", free[j].parameter.unit},
                                 {"before", free[j].parameter.value},
                                 {"after", c.values[j]},
                                 {"relative_uncertainty", finite_or_null(c.uncertainty[j])},
                                 {"at_bound", bool(c.at_bound[j])}});
  all["singular_values"] = std::vector<double>(c.singular_values.begin(), c.singular_values.end());
  for (Eigen::Index k = 0; k < c.directions.cols(); ++k)
    all["directions"].push_back(std::vector<double>(c.directions.col(k).begin(), c.directions.col(k).end()));
  all["correlated_pairs"] = json::array();
  for (const auto& pair : c.correlations)
    all["correlated_pairs"].push_back({{"first", free[pair.first].parameter.name},
                                       {"second", free[pair.second].parameter.name},
                                       {"correlation", pair.value}});
  return all;
}

void tell(const Calibration& c, const std::vector<Target>& targets, const std::vector<FreeParameter>& free) {
  log::info("{} runs, {} steps ({}); misfit {:.3g} -> {:.3g} tolerances", c.runs, c.steps, c.stopped,
            c.misfit_before, c.misfit);
  log::info("{:<32} {:>12} {:>12} {:>12}  {}", "target", "before", "after", "wanted", "unit");
  for (std::size_t i = 0; i < targets.size(); ++i)
    log::info("{:<32} {:>12.5g} {:>12.5g} {:>12.5g}  {}", targets[i].index.text, c.before[i], c.after[i],
              targets[i].value, targets[i].index.unit);
  log::info("{:<32} {:>12} {:>12} {:>12}  {}", "parameter", "before", "after", "uncertain", "unit");
  for (std::size_t j = 0; j < free.size(); ++j) {
    const auto& p = free[j].parameter;
    const std::string uncertain =
        std::isfinite(c.uncertainty[j]) ? fmt::format("{:.2g} %", 100 * c.uncertainty[j]) : "not told";
    log::info("{:<32} {:>12.5g} {:>12.5g} {:>12}  {}{}", p.name, p.value, c.values[j], uncertain, p.unit,
              c.at_bound[j] ? "  at its bound" : "");
  }
  for (const auto& pair : c.correlations)
    log::warn("the targets hardly tell {} from {} (correlation {:.3f}); fix one of them or add a target",
              free[pair.first].parameter.name, free[pair.second].parameter.name, pair.value);
}

void write_series(const Case& study, const network::Model& model, const std::filesystem::path& file) {
  std::unique_ptr<CsvWriter> csv;
  network::simulate(model,
                    {.end = study.time.final(),
                     .every = study.output.every,
                     .initial = study.initial(),
                     .period = study.time.period.value_or(0)},
                    {.begin =
                         [&](std::vector<std::string> names) {
                           names.insert(names.begin(), "time_s");
                           csv = std::make_unique<CsvWriter>(file, names);
                         },
                     .row =
                         [&](double t, std::span<const double> values) {
                           *csv << t;
                           for (const double v : values) *csv << v;
                           csv->end_row();
                           return true;
                         }});
}

}  // namespace

void check_calibration(const Case& study, const network::Model& model) {
  if (!study.calibration) return;
  if (study.vessel)
    study.calibration->origin.error(
        "a calibration is that of a network alone, this case has a vessel; leave one of the two out");
  targets_of(*study.calibration, model), free_of(*study.calibration, model);
}

void calibrate_case(const Case& study, const ResultsFolder& folder) {
  if (!study.calibration)
    study.origin.error(
        "a calibration needs the section \"calibration\" with targets and parameters; add for example "
        "\"calibration: {{targets: [{{of: mean p:Ao, value: 93 mmHg, tolerance: 1 mmHg}}], parameters: "
        "[{{name: body.Rd, "
        "low: 1e7 Pa.s/m3, high: 1e9 Pa.s/m3}}]}}\"");
  const network::Model model = network::read_model(study.network.blocks);
  check_calibration(study, model);
  const auto targets = targets_of(*study.calibration, model);
  const auto free = free_of(*study.calibration, model);
  const Calibration c = network::calibrate(
      model, targets, free,
      {.end = study.time.final(), .period = study.time.period.value_or(0), .initial = study.initial()},
      {.most_runs = study.calibration->most_runs, .progress = [](int run, double misfit, bool helps) {
         log::info("run {:>3}  misfit {:.4g} tolerances{}", run, misfit, helps ? "" : "  (step too long)");
       }});
  folder.create();
  Case found = study;
  found.calibration.reset();
  write_text(folder.file("calibrated.yaml"), effective_case(found, c.model));
  write_text(folder.file("summary.json"), report_of(c, targets, free).dump(2) + "\n");
  write_series(study, model, folder.file("network_before.csv"));
  write_series(study, c.model, folder.file("network_after.csv"));
  tell(c, targets, free);
  log::info("written: {}; run it with: ostium run {}", folder.file("calibrated.yaml").string(),
            folder.file("calibrated.yaml").string());
}

}  // namespace ostium::app
