#include "app/sweep/plan.hpp"

#include "app/measured.hpp"
#include "network/network.hpp"

namespace ostium::app {
namespace {

using network::Sampling;
using network::Variation;

/// What `make` returns; its errors get the position of a place in the case unless they have one.
template <class Make>
auto at(const config::Node& place, Make make) {
  try {
    return make();
  } catch (const UserError& error) {
    const std::string text = error.what();
    text.starts_with(place.file() + ":") ? throw : place.error("{}", text);
  }
}

std::string place_of(const config::Node& node) { return node.where() + ": " + node.path(); }

double value_of(const SweptParameterCase& p, const char* key, const std::optional<std::string>& text,
                const network::Parameter& found) {
  if (!text)
    p.origin.error(
        "\"{}\" is missing; give \"low\" and \"high\", \"mean\" and \"standard_deviation\" of a "
        "normal distribution, or \"values\"",
        key);
  return measured(p.origin.at(key), *text, found.unit);
}

void read_values(const SweptParameterCase& p, Variation& v) {
  const auto places = p.origin.at("values").items();
  v.law = Variation::Law::listed;
  for (std::size_t i = 0; i < places.size(); ++i)
    v.values.push_back(measured(places[i], (*p.values)[i], v.parameter.unit));
}

void read_distribution(const SweptParameterCase& p, Variation& v) {
  using Law = Variation::Law;
  v.law = p.normal ? Law::normal : p.logarithmic ? Law::log_uniform : Law::uniform;
  if (p.normal) {
    v.mean = value_of(p, "mean", p.mean, v.parameter);
    v.deviation = value_of(p, "standard_deviation", p.standard_deviation, v.parameter);
  }
  if (!p.normal || p.low) v.low = value_of(p, "low", p.low, v.parameter);
  if (!p.normal || p.high) v.high = value_of(p, "high", p.high, v.parameter);
}

void place_on_grid(const SweptParameterCase& p, Variation& v) {
  if (v.law == Variation::Law::normal)
    p.origin.error("a grid has no normal distribution; give \"low\", \"high\" and \"count\", or \"values\"");
  if (!p.count)
    p.origin.error("in a grid \"count\" is missing; add for example \"count: 10\", or give \"values\"");
  v.values = evenly(v, *p.count), v.law = Variation::Law::listed;
}

Variation variation_of(const SweptParameterCase& p, Sampling sampling, const network::Model& model) {
  Variation v{.parameter = network::parameter(model, p.name, place_of(p.origin.at("name")))};
  p.values ? read_values(p, v) : read_distribution(p, v);
  at(p.origin, [&] { check(v); });
  if (sampling == Sampling::grid && !p.values) place_on_grid(p, v);
  if (sampling != Sampling::grid && p.count)
    p.origin.at("count").error(
        "values from low to high are counted in a grid; leave it out, or choose `sample: grid`");
  return v;
}

std::vector<Variation> variations_of(const SweepCase& asked, Sampling sampling, const network::Model& model) {
  std::vector<Variation> all;
  if (!asked.file) {
    for (const auto& p : asked.parameters) all.push_back(variation_of(p, sampling, model));
    return all;
  }
  std::vector<std::string> names;
  for (const auto& p : asked.parameters) {
    if (p.low || p.high || p.values || p.normal || p.logarithmic || p.count)
      p.origin.error("the file gives the values; leave all but \"name\" out");
    names.push_back(p.name);
  }
  return at(asked.origin.at("file"), [&] { return read_samples(*asked.file, model, names); });
}

network::Design design_of(const SweepCase& asked, const network::Model& model) {
  const Sampling sampling = asked.sample.value_or(Sampling::table);
  const auto variations = variations_of(asked, sampling, model);
  return at(asked.origin, [&] {
    return network::Design({.sampling = sampling,
                            .count = asked.count.value_or(0),
                            .seed = static_cast<std::uint64_t>(asked.seed),
                            .parameters = variations});
  });
}

/// All results are kept until the end, for their statistics.
void check_size(const SweepCase& asked, const network::Design& design) {
  constexpr double most = 2e8;  // 1.6 GB
  const double rows = static_cast<double>(design.rows()), each = static_cast<double>(asked.results.size());
  if (rows * each > most)
    asked.origin.error(
        "{:.3g} samples of {} results each are {:.2g} numbers, at most {:.0e} are allowed; choose fewer "
        "values, or "
        "`sample: latin_hypercube` with a \"count\"",
        rows, asked.results.size(), rows * each, most);
}

std::vector<network::Index> results_of(const SweepCase& asked, const network::Model& model) {
  const auto series = network::Network(model).series_names();
  const auto places = asked.origin.at("results").items();
  std::vector<network::Index> all;
  for (std::size_t i = 0; i < asked.results.size(); ++i)
    all.push_back(network::read_index(asked.results[i], series, place_of(places[i])));
  return all;
}

std::string column(const std::string& name, const std::string& unit) {
  return unit == "1" ? name : name + " [" + unit + "]";
}

}  // namespace

std::vector<std::string> SweepPlan::parameter_columns() const {
  std::vector<std::string> all;
  for (const auto& p : design.parameters()) all.push_back(column(p.name, p.unit));
  return all;
}

std::vector<std::string> SweepPlan::result_columns() const {
  std::vector<std::string> all;
  for (const auto& r : results) all.push_back(column(r.text, r.unit));
  return all;
}

SweepPlan sweep_plan(const Case& study) {
  if (!study.sweep)
    study.origin.error(
        "a sweep needs the section \"sweep\" with samples and results; add for example \"sweep: {{sample: "
        "latin_hypercube, count: 1000, parameters: [{{name: body.Rd, low: 1e8 Pa.s/m3, high: 2e8 Pa.s/m3}}], "
        "results: [mean p:Ao]}}\"");
  const SweepCase& asked = *study.sweep;
  if (study.vessel)
    asked.origin.error(
        "a sweep is that of a network alone, this case has a vessel; leave one of the two out");
  const network::Model model = network::read_model(study.network.blocks);
  auto results = results_of(asked, model);
  network::Design design = design_of(asked, model);
  check_size(asked, design);
  return {.model = model,
          .design = std::move(design),
          .results = std::move(results),
          .run = {.end = study.time.final(),
                  .every = study.output.every,
                  .period = study.time.period.value_or(0),
                  .initial = study.initial()}};
}

}  // namespace ostium::app
