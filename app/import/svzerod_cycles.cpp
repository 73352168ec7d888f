#include "app/import/svzerod_cycles.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/units.hpp"

namespace ostium::app::svzerod {
namespace {

/// Pressure and flow at one end of each vessel that has a boundary condition: at its outlet where it has two.
std::vector<Expression> caps(const Source& source, const config::Tree& variables) {
  std::vector<Expression> all;
  const auto add = [&](const std::string& connection) {
    for (const char* kind : {"flow:", "pressure:"}) {
      const config::Tree* terms = variables.find(kind + connection);
      std::vector<std::string> texts;
      for (std::size_t i = 1; i < terms->items.size(); ++i) texts.push_back(terms->items[i]->text);
      all.push_back(Expression::parse(texts));
    }
  };
  for (const auto& part : source.parts) {
    if (part.kind != Kind::vessel) continue;
    const auto ends = part.node.find("boundary_conditions");
    if (ends && ends->find("outlet"))
      add(source.connections[part.out[0]].name);
    else if (ends && ends->find("inlet"))
      add(source.connections[part.in[0]].name);
  }
  return all;
}

/// Runs one cycle; the means over its samples, both ends among them.
std::vector<double> means(network::Network& network, const Source& source,
                          const std::vector<Expression>& wanted) {
  const auto& names = network.series_names();
  std::vector<double> values(names.size()), sums(wanted.size(), 0.0);
  const auto sample = [&] {
    network.series(values);
    const auto value = [&](const std::string& s) {
      return values[std::find(names.begin(), names.end(), s) - names.begin()];
    };
    for (std::size_t k = 0; k < wanted.size(); ++k) sums[k] += wanted[k].value(value);
  };
  sample();
  for (int i = 1; i < source.run.points; ++i) {
    network.advance(source.period / (source.run.points - 1), {}, {});
    sample();
  }
  for (double& s : sums) s /= source.run.points;
  return sums;
}

/// The largest change of a mean, relative to it.
double largest_change(const std::vector<double>& before, const std::vector<double>& now) {
  double largest = 0;
  for (std::size_t k = 0; k < now.size(); ++k)
    if (now[k] != before[k]) largest = std::max(largest, std::abs((now[k] - before[k]) / before[k]));
  return largest;
}

/// Of the way from the first change to the wanted one, which is gone by the same factor each cycle.
double share_done(double first, double now, double wanted) {
  return now <= wanted ? 1 : std::clamp(std::log(first / now) / std::log(first / wanted), 0.0, 1.0);
}

[[noreturn]] void refuse_unsettled(const Source& source, const std::string& what) {
  source.root.at("simulation_parameters")
      .at("use_cycle_to_cycle_error")
      .error("{}; set it to false and give \"number_of_cardiac_cycles\"", what);
}

int run_until_settled(const Source& source, const Circuit& circuit, network::Network& network,
                      const Tell& tell) {
  const double wished = *source.run.cycle_error;
  const auto wanted = caps(source, circuit.variables());
  constexpr int most_samples = 2000000;
  const int most = std::clamp(most_samples / source.run.points, source.run.cycles + 10, 10000);
  std::vector<double> before, now = means(network, source, wanted);
  double first = 0, change = 0;
  for (int cycle = 2; cycle <= most; ++cycle) {
    before = std::move(now);
    now = means(network, source, wanted);
    change = largest_change(before, now);
    if (cycle == 2) first = change;
    tell("running until cycles repeat", share_done(first, change, wished));
    if (cycle >= source.run.cycles && change <= wished) return cycle;
  }
  refuse_unsettled(
      source,
      fmt::format("pressures and flows still change by {:.2g} from cycle to cycle after {} cycles, not by {}",
                  change, most, shortest(wished)));
}

}  // namespace

int cycles_of(const Source& source, const Circuit& circuit, network::Network network, const Tell& tell) {
  const Run& run = source.run;
  if (!run.cycle_error) return run.cycles;
  double slowest = 0;
  for (const auto& part : source.parts)
    if (part.type == "RCR")
      slowest = std::max(slowest, part.values.at("Rd").number() * part.values.at("C").number());
  if (slowest == 0) {
    try {
      return run_until_settled(source, circuit, network, tell);
    } catch (const NumericsError& e) {
      refuse_unsettled(source,
                       fmt::format("the cycles until the model repeats itself do not end: {}", e.what()));
    }
  }
  const double cycles = std::ceil(-slowest / source.period * std::log(*run.cycle_error));
  constexpr double most = 100000;
  if (cycles > most)
    source.root.at("simulation_parameters")
        .at("use_cycle_to_cycle_error")
        .error(
            "the slowest Rd C of an RCR is {:.3g} s, which makes {:.3g} cycles, at most {:g} are run; look "
            "at its "
            "values, or set it to false and give \"number_of_cardiac_cycles\"",
            slowest, cycles, most);
  return std::max(1, static_cast<int>(cycles));
}

}  // namespace ostium::app::svzerod
