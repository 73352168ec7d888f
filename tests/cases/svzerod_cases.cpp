// All models of svZeroDSolver that come with reference results: imported, run, compared, in one table (reference data
// needed). Against its results refined in time within the bar of each case; where there are none, against the stored
// results of the steady and mean cases within 1e-4; those that must be refused are.
#include <fmt/format.h>

#include <cmath>
#include <functional>

#include <nlohmann/json.hpp>

#include "app/svzerod_rows.hpp"

namespace ostium::test {
namespace {

using nlohmann::json;

const std::filesystem::path data = std::filesystem::path(OSTIUM_DATA_DIR) / "svzerod-cases";

json load(const std::string& name) { return json::parse(std::ifstream(data / name)); }

/// rms of the difference over the rms of the reference, of the worst series.
struct Worst {
  double error = 0;
  std::string series;
  void add(const std::string& name, double square, double reference) {
    const double e = std::sqrt(square / std::max(reference, 1e-300));
    if (!(e <= error)) error = e, series = name;
  }
};

class SvzerodCases : public SvzerodTest {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(data)) GTEST_SKIP() << "needs the reference data at " << data;
  }

  /// Where the last cycle begins. The reference's own last time does not tell: its grid may stop short of the end. Its
  /// period is rounded, so it only counts the cycles.
  static double last_cycle(const SvzerodSeries& series, double period) {
    const double end = series.time.back();
    return end - end / std::round(end / period);
  }

  static Worst against_refined(const std::string& name, const SvzerodRows& rows, const json& entry) {
    const json reference = load("converged/" + name + ".json"), &skipped = entry.at("not_converged_series");
    const auto times = reference.at("time").get<std::vector<double>>();
    Worst worst;
    for (const auto& [series, values] : reference.at("y").items()) {
      if (std::find(skipped.begin(), skipped.end(), series) != skipped.end()) continue;
      if (!rows.contains(series)) return {INFINITY, series + " is missing"};
      const auto& ours = rows.at(series);
      const double last = last_cycle(ours, entry.at("period"));
      double square = 0, size = 0;
      for (std::size_t k = 0; k < times.size(); ++k) {
        const double v = values[k];
        square += std::pow(ours.at(last + times[k]) - v, 2), size += v * v;
      }
      worst.add(series, square, size);
    }
    return worst;
  }

  /// The unknown behind a column of the vessel layout.
  static std::string unknown(const SvzerodRows& rows, const std::string& vessel, const std::string& column) {
    const auto cut = column.find('_');
    const bool inlet = column.substr(cut + 1) == "in";
    for (const auto& [name, series] : rows)
      if (name.starts_with(column.substr(0, cut) + ":"))
        if (inlet ? name.ends_with(":" + vessel) : name.find(":" + vessel + ":") != std::string::npos)
          return name;
    return {};
  }

  static Worst against_stored(const std::string& name, const SvzerodRows& rows) {
    const json stored = load("results/result_" + name + ".json");
    std::map<std::string, std::pair<double, double>> sums;
    for (const auto& [column, values] : stored.items()) {
      if (column == "name" || column == "time" || column.starts_with("d_")) continue;
      for (const auto& [row, value] : values.items()) {
        const std::string block = stored["name"][row];
        const auto series = column == "y" ? block : unknown(rows, block, column);
        if (!rows.contains(series)) return {INFINITY, block + " " + column + " is missing"};
        const auto& time = stored["time"][row];
        const double v = value, ours = time.is_null() ? rows.at(series).y.at(0) : rows.at(series).at(time);
        sums[series].first += std::pow(ours - v, 2), sums[series].second += v * v;
      }
    }
    Worst worst;
    for (const auto& [series, sum] : sums) worst.add(series, sum.first, sum.second);
    return worst;
  }

  bool compare(const json& entry) {
    const std::string name = entry.at("case");
    const auto rows = import_and_run(data / "cases" / (name + ".json"));
    if (entry.contains("expect")) {
      fmt::print("{:<52} refused   {}", name, refusal);
      return rows.empty() && refusal.find("the period is") != std::string::npos;
    }
    if (rows.empty()) {
      fmt::print("{:<52} FAILED    {}", name, refusal);
      return false;
    }
    const bool refined = entry.contains("converged");
    const double bar = refined ? entry["converged"]["l2_tolerance"].get<double>() : 1e-4;
    const Worst worst =
        refined ? against_refined(name, rows, entry["converged"]) : against_stored(name, rows);
    const bool good = worst.error < bar;
    fmt::print("{:<52} {:<9} {:.1e} of {:.1e}  {}\n", name, refined ? "refined" : "stored", worst.error, bar,
               worst.series);
    return good;
  }

  void compare_all(const std::function<bool(const json&)>& chosen) {
    fmt::print("{:<52} {:<9} {:<7}    {:<7}  worst series\n", "case", "against", "error", "bar");
    for (const auto& entry : load("manifest.json")) {
      if (!chosen(entry)) continue;
      EXPECT_TRUE(compare(entry)) << entry["case"];
    }
  }
};

/// Linear models: milliseconds each.
TEST_F(SvzerodCases, WithoutHeartsAndStenoses) {
  compare_all([](const json& entry) {
    const std::string name = entry.at("case"), features = entry.at("features").dump();
    return features.find("stenosis") == std::string::npos && features.find("valve") == std::string::npos &&
           features.find("chamber") == std::string::npos && features.find("closed_loop") == std::string::npos;
  });
}

class FullSvzerodCases : public SvzerodCases {};

TEST_F(FullSvzerodCases, All) {
  compare_all([](const json&) { return true; });
}

}  // namespace
}  // namespace ostium::test
