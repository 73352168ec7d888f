#include "app/import/svzerod_source.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "core/did_you_mean.hpp"
#include "core/units.hpp"

namespace ostium::app::svzerod {
namespace {

/// Every series of the model that says something about the period.
void each_period(const Source& source, const std::function<void(double, const JsonNode&)>& visit) {
  for (const auto& part : source.parts) {
    if (part.kind == Kind::heart && part.node.find("cardiac_cycle_period"))
      visit(part.node.at("cardiac_cycle_period").positive(), part.node.at("cardiac_cycle_period"));
    if (!part.values.find("t")) continue;
    for (const char* key : {"Q", "P", "Pim"})
      if (part.values.find(key))
        if (const Series s = read_series(part.values, key); s.t.size() > 1) visit(s.period(), s.where);
  }
  const auto run = source.root.at("simulation_parameters");
  if (const auto given = run.find("cardiac_period"); given && given->number() > 0)
    visit(given->number(), *given);
}

void find_period(Source& source) {
  std::optional<std::pair<double, std::string>> first;
  each_period(source, [&](double period, const JsonNode& where) {
    if (!first) first = {period, where.path()};
    constexpr double round_off = 1e-9;
    if (std::abs(period - first->first) > round_off * first->first)
      where.error("the period is {} here and {} at {}; all series and periods of a model must agree",
                  shortest(period), shortest(first->first), first->second);
  });
  source.period = first ? first->first : 1;
  constexpr double shortest_period = 1e-6, longest = 1e6;
  if (source.period < shortest_period || source.period > longest)
    source.root.error("{}: the period of {} s must be from {:g} s to {:g} s", first->second,
                      shortest(source.period), shortest_period, longest);
}

std::map<std::string, double> values_of(const JsonNode& root, const char* key) {
  std::map<std::string, double> all;
  if (const auto given = root.find(key))
    for (const auto& [name, value] : given->entries())
      if (!name.starts_with("_")) all[name] = value.number();
  return all;
}

}  // namespace

bool Series::constant() const {
  return std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
}

double Series::mean() const {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Series read_series(const JsonNode& values, const std::string& key) {
  Series s{values.at("t").numbers(), values.at(key).numbers(), values.at(key)};
  if (s.t.size() != s.values.size())
    s.where.error("has {} values for {} times in \"t\"; both lists need the same length", s.values.size(),
                  s.t.size());
  if (s.t.empty()) s.where.error("has no values; give at least one");
  const auto t = values.at("t");
  if (s.t.front() != 0) t.error("begins at {}; the times of a series must begin at 0", shortest(s.t.front()));
  for (std::size_t i = 1; i < s.t.size(); ++i)
    if (!(s.t[i] >= s.t[i - 1]))
      t.error("goes back from {} to {} at item {}; times must increase", shortest(s.t[i - 1]),
              shortest(s.t[i]), i);
  if (s.t.size() > 1 && !(s.period() > 0)) t.error("spans no time; the last time must be > 0");
  return s;
}

const Part& Source::part(const std::string& name) const {
  return *std::find_if(parts.begin(), parts.end(), [&](const Part& p) { return p.name == name; });
}

bool Source::has(const std::string& type) const {
  return std::any_of(parts.begin(), parts.end(), [&](const Part& p) { return p.type == type; });
}

double Source::start(const std::string& unknown) const {
  const auto value = [this](const std::string& name) {
    const auto at = initial.find(name);
    return at == initial.end() ? std::nullopt : std::optional(at->second);
  };
  if (const auto own = value(unknown)) return *own;
  if (unknown.starts_with("pressure:") || unknown.starts_with("P_c:"))
    return value("pressure_all").value_or(0);
  return unknown.starts_with("flow:") ? value("flow_all").value_or(0) : 0;
}

void read_run(Source& source, std::vector<std::string>& notes) {
  const auto given = source.root.at("simulation_parameters");
  if (given.flag("coupled_simulation", false))
    given.at("coupled_simulation")
        .error(
            "this model is one half of a coupled run, its time and flows come from a 3D solver; set it to "
            "false "
            "and give \"number_of_cardiac_cycles\" and \"number_of_time_pts_per_cardiac_cycle\", then join "
            "the "
            "imported network to the openings of a vessel");
  Run& run = source.run;
  const auto bounded = [&](const char* key, int least, int most) {
    const int n = given.at(key).integer_at_least(least);
    if (n > most) given.at(key).error("must be at most {}, found {}", most, n);
    return n;
  };
  run.cycles = bounded("number_of_cardiac_cycles", 1, 100000);
  run.points = bounded("number_of_time_pts_per_cardiac_cycle", 2, 1000000);
  if (const auto interval = given.find("output_interval")) run.interval = interval->integer_at_least(1);
  run.steady_initial = given.flag("steady_initial", true);
  run.all_cycles = given.flag("output_all_cycles", false);
  run.mean_only = given.flag("output_mean_only", false);
  if (given.flag("output_derivative", false))
    notes.push_back("output_derivative: the rates of the unknowns are not written");
  if (given.flag("use_cycle_to_cycle_error", false))
    run.cycle_error = given.find("sim_cycle_to_cycle_percent_error")
                          ? given.at("sim_cycle_to_cycle_percent_error").positive() / 100
                          : 0.01;
  for (const char* key : {"absolute_tolerance", "maximum_nonlinear_iterations", "rho_infty"})
    if (given.find(key))
      notes.push_back(std::string(key) + ": of no use here, the integrator controls its own error");
}

namespace {

/// A misspelt section is an error; one with a name of its own belongs to somebody else.
void check_sections(const JsonNode& root, std::vector<std::string>& notes) {
  const std::vector<std::string> known{"simulation_parameters",
                                       "boundary_conditions",
                                       "vessels",
                                       "junctions",
                                       "closed_loop_blocks",
                                       "valves",
                                       "chambers",
                                       "external_solver_coupling_blocks",
                                       "initial_condition",
                                       "initial_condition_d",
                                       "calibration_parameters"};
  const std::vector<std::string> others{"description", "y", "dy"};
  for (const auto& [key, node] : root.entries()) {
    if (key.starts_with("_") || std::count(known.begin(), known.end(), key) ||
        std::count(others.begin(), others.end(), key))
      continue;
    if (const auto near = nearest_name(key, known))
      node.error("there is no such section; did you mean \"{}\"? (a name that begins with _ is a comment)",
                 *near);
    notes.push_back(key + ": a section of no meaning here");
  }
}

}  // namespace

Source read_source(const JsonNode& root, std::vector<std::string>& notes) {
  Source source(root);
  check_sections(root, notes);
  root.at("simulation_parameters");
  read_parts(source);
  read_run(source, notes);
  find_period(source);
  source.initial = values_of(root, "initial_condition");
  source.initial_rates = values_of(root, "initial_condition_d");
  if (!source.initial_rates.empty())
    notes.push_back("initial_condition_d: of no use here, the rates follow from the equations");
  return source;
}

}  // namespace ostium::app::svzerod
