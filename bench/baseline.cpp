#include "bench/baseline.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

namespace ostium::bench {

namespace {

constexpr double usual_tolerance = 0.15;

std::string sentence(const Ratio& ratio, double stored, double tolerance) {
  return fmt::format("warning: {} is {:.2f}, {} than the baseline's {:.2f} by more than {:.0f} %", ratio.name,
                     ratio.value, ratio.larger_is_better ? "smaller" : "larger", stored, 100 * tolerance);
}

bool worse(const Ratio& ratio, double stored, double tolerance) {
  return ratio.larger_is_better ? ratio.value < stored * (1 - tolerance)
                                : ratio.value > stored * (1 + tolerance);
}

}  // namespace

Ratios ratios_of(const Results& r) {
  Ratios ratios{.kernels = r.kernels.rows.front().who};
  std::string done;
  for (const auto& row : r.kernels.rows)  // the fastest kernels come first
    if (row.what != done) {
      ratios.all.push_back(
          {.name = row.what + ", times faster than plain", .value = row.times_faster, .of_kernels = true});
      done = row.what;
    }
  ratios.all.push_back({.name = "advection step over acoustic step",
                        .value = r.step.advection_over_acoustic,
                        .larger_is_better = false});
  const auto& rows = r.engine.rows;
  if (rows.size() > 1)
    ratios.all.push_back({.name = "two threads over one",
                          .value = rows[0].per_particle_step.median / rows[1].per_particle_step.median});
  return ratios;
}

void write_baseline(const Ratios& ratios, const std::filesystem::path& file) {
  nlohmann::ordered_json json{{"tolerance", usual_tolerance}, {"kernels", ratios.kernels}};
  for (const auto& ratio : ratios.all) json["ratios"][ratio.name] = std::round(100 * ratio.value) / 100;
  std::ofstream out(file);
  out << json.dump(2) << "\n";
  if (!out) throw std::runtime_error(fmt::format("{}: cannot be written", file.string()));
}

std::vector<std::string> worse_than(const std::filesystem::path& baseline, const Ratios& ratios) {
  std::ifstream in(baseline);
  if (!in) return {fmt::format("no baseline to compare with: {} cannot be read", baseline.string())};
  const auto json = nlohmann::json::parse(in, nullptr, false);
  if (json.is_discarded() || !json.contains("ratios"))
    return {fmt::format("no baseline to compare with: {} holds no \"ratios\"", baseline.string())};
  const double tolerance = json.value("tolerance", usual_tolerance);
  const bool same_kernels = json.value("kernels", "") == ratios.kernels;
  std::vector<std::string> sentences;
  for (const auto& ratio : ratios.all) {
    const auto& stored = json["ratios"];
    if (!stored.contains(ratio.name) || (ratio.of_kernels && !same_kernels)) continue;
    if (const double value = stored[ratio.name]; worse(ratio, value, tolerance))
      sentences.push_back(sentence(ratio, value, tolerance));
  }
  return sentences;
}

}  // namespace ostium::bench
