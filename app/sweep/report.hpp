/// What a sweep says at its end, beside the table.
///
///   sobol.csv      of a Saltelli design: result, parameter, indices with half the width of their 95 % intervals
///   summary.json   what was run, how many samples failed, statistics of the results, indices
#pragma once
#include <nlohmann/json_fwd.hpp>

#include "app/sweep/table.hpp"
#include "network/sobol.hpp"

namespace ostium::app {

struct Spread {
  double mean = 0, deviation = 0, min = 0, max = 0;
};
/// Of result k over the samples that are ok.
Spread spread_of(const SweepTable& table, std::size_t k);

/// One per result; nothing where the samples do not allow it: another design, or fewer than two complete base samples.
std::vector<network::Sobol> sobol_of(const SweepPlan& plan, const SweepTable& table);

void write_sobol(const std::filesystem::path& file, const SweepPlan& plan,
                 const std::vector<network::Sobol>& all);

/// "samples", "parameters", "results", "sobol" of the summary.
nlohmann::json sweep_json(const SweepPlan& plan, const SweepTable& table,
                          const std::vector<network::Sobol>& sobol);
/// The same as tables for the terminal.
std::vector<std::string> sweep_lines(const SweepPlan& plan, const SweepTable& table,
                                     const std::vector<network::Sobol>& sobol);

}  // namespace ostium::app
