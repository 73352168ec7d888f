#include "app/sweep/report.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace ostium::app {
namespace {

using network::Outcome;
using network::Sampling;
using nlohmann::json;

const char* name_of(Sampling sampling) {
  switch (sampling) {
    case Sampling::grid:
      return "grid";
    case Sampling::random:
      return "random";
    case Sampling::latin_hypercube:
      return "latin_hypercube";
    case Sampling::saltelli:
      return "saltelli";
    case Sampling::table:
      return "file";
  }
  return "";
}

json finite_or_null(double x) { return std::isfinite(x) ? json(x) : json(nullptr); }

json sobol_json(const SweepPlan& plan, const network::Sobol& s) {
  json all = {{"base_samples", s.base_samples}, {"variance", finite_or_null(s.variance)}};
  const auto names = plan.design.parameters();
  for (std::size_t k = 0; k < names.size(); ++k) {
    const auto& i = s.parameters[k];
    all["parameters"][names[k].name] = {{"first_order", finite_or_null(i.first)},
                                        {"first_order_half_width", finite_or_null(i.first_half)},
                                        {"total", finite_or_null(i.total)},
                                        {"total_half_width", finite_or_null(i.total_half)}};
  }
  return all;
}

}  // namespace

Spread spread_of(const SweepTable& table, std::size_t k) {
  double n = 0, squares = 0;
  Spread s{.min = INFINITY, .max = -INFINITY};
  for (std::int64_t i = 0; i < table.rows(); ++i) {
    if (table.outcome(i) != Outcome::ok) continue;
    const double x = table.result(i, k), from_mean = x - s.mean;
    s.mean += from_mean / ++n, squares += from_mean * (x - s.mean);
    s.min = std::min(s.min, x), s.max = std::max(s.max, x);
  }
  s.deviation = n > 1 ? std::sqrt(squares / (n - 1)) : 0;
  return s;
}

std::vector<network::Sobol> sobol_of(const SweepPlan& plan, const SweepTable& table) {
  const auto& options = plan.design.options();
  if (options.sampling != Sampling::saltelli) return {};
  std::vector<network::Sobol> all;
  for (std::size_t k = 0; k < plan.results.size(); ++k)
    all.push_back(network::sobol(options.count, plan.design.columns(),
                                 [&](std::int64_t row) { return table.result(row, k); }));
  const bool enough = std::all_of(all.begin(), all.end(), [](const auto& s) { return s.base_samples > 1; });
  return enough ? all : std::vector<network::Sobol>{};
}

void write_sobol(const std::filesystem::path& file, const SweepPlan& plan,
                 const std::vector<network::Sobol>& all) {
  CsvWriter csv(
      file, {"result", "parameter", "first_order", "first_order_half_width", "total", "total_half_width"});
  const auto parameters = plan.design.parameters();
  for (std::size_t r = 0; r < all.size(); ++r)
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const auto& i = all[r].parameters[k];
      csv << plan.results[r].text << parameters[k].name << i.first << i.first_half << i.total << i.total_half;
      csv.end_row();
    }
  csv.flush();
}

json sweep_json(const SweepPlan& plan, const SweepTable& table, const std::vector<network::Sobol>& sobol) {
  const auto& options = plan.design.options();
  json all = {{"samples",
               {{"design", name_of(options.sampling)},
                {"seed", options.seed},
                {"planned", plan.design.rows()},
                {"done", table.rows()},
                {"failed", table.count(Outcome::failed)},
                {"refused", table.count(Outcome::refused)}}}};
  for (const auto& p : plan.design.parameters())
    all["parameters"].push_back({{"name", p.name}, {"unit", p.unit}});
  for (std::size_t k = 0; k < plan.results.size(); ++k) {
    const Spread s = spread_of(table, k);
    all["results"].push_back({{"name", plan.results[k].text},
                              {"unit", plan.results[k].unit},
                              {"mean", s.mean},
                              {"standard_deviation", s.deviation},
                              {"min", finite_or_null(s.min)},
                              {"max", finite_or_null(s.max)}});
    if (!sobol.empty()) all["results"].back()["sobol"] = sobol_json(plan, sobol[k]);
  }
  return all;
}

std::vector<std::string> sweep_lines(const SweepPlan& plan, const SweepTable& table,
                                     const std::vector<network::Sobol>& sobol) {
  std::vector<std::string> lines{fmt::format("{:<32} {:>12} {:>12} {:>12} {:>12}  {}", "result", "mean",
                                             "deviation", "min", "max", "unit")};
  for (std::size_t k = 0; k < plan.results.size(); ++k) {
    const Spread s = spread_of(table, k);
    lines.push_back(fmt::format("{:<32} {:>12.5g} {:>12.5g} {:>12.5g} {:>12.5g}  {}", plan.results[k].text,
                                s.mean, s.deviation, s.min, s.max, plan.results[k].unit));
  }
  const auto parameters = plan.design.parameters();
  for (std::size_t r = 0; r < sobol.size(); ++r) {
    lines.push_back(fmt::format("{:<32} {:>22} {:>22}", plan.results[r].text, "first order", "total"));
    for (std::size_t k = 0; k < parameters.size(); ++k) {
      const auto& i = sobol[r].parameters[k];
      lines.push_back(fmt::format("  {:<30} {:>12.4f} +- {:>6.4f} {:>12.4f} +- {:>6.4f}", parameters[k].name,
                                  i.first, i.first_half, i.total, i.total_half));
    }
  }
  return lines;
}

}  // namespace ostium::app
