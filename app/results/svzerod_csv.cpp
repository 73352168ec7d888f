#include "app/results/svzerod_csv.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <limits>

#include "app/import/unit_system.hpp"
#include "core/did_you_mean.hpp"
#include "core/units.hpp"

namespace ostium::app {
namespace {

struct Rows {
  std::vector<double> time;
  std::vector<std::vector<double>> values;
};

double start_of(const std::string& name, const config::Node& start) {
  const auto given = start.find(name);
  if (!given) return 0;
  try {
    return parse_number(given->text());
  } catch (const UserError& e) {
    given->error("{}", e.what());
  }
}

/// The rows of network.csv from `begin` on.
Rows read_rows(const std::filesystem::path& file, double begin) {
  Rows rows;
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    const char* at = line.c_str();
    char* next = nullptr;
    const double time = std::strtod(at, &next);
    if (time < begin) continue;
    rows.time.push_back(time);
    auto& values = rows.values.emplace_back();
    while (*next == ',') values.push_back(std::strtod(next + 1, &next));
  }
  return rows;
}

}  // namespace

SvzerodCsv::SvzerodCsv(const Case& study, const std::vector<std::string>& series)
    : series_(series), mean_only_(study.output.svzerod.mean_only) {
  const auto& wanted = study.output.svzerod;
  if (wanted.variables)
    for (const auto& [name, node] : wanted.variables->entries()) variables_.push_back(read(name, node));
  else
    for (const auto& name : series) variables_.push_back({name, 1, Expression::of(name), {}});
  if (wanted.start)
    for (auto& v : variables_) v.start = start_of(v.name, *wanted.start);
  if (wanted.all_cycles || !study.time.period) return;
  const double period = *study.time.period;
  shift_ = std::max(0.0, study.time.final() - period);
  begin_ = shift_ - 1e-9 * period;
}

SvzerodCsv::Variable SvzerodCsv::read(const std::string& name, const config::Node& node) const {
  std::vector<std::string> texts;
  for (const auto& item : node.items()) texts.push_back(item.text());
  if (texts.size() < 2) node.error("expected [unit, series, ..], for example [mL/s, q:heart_m3_s]");
  Variable v{name, 1, {}, {}};
  try {
    v.unit = UnitSystem::si(texts[0]);
    v.value = Expression::parse({texts.begin() + 1, texts.end()});
  } catch (const UserError& e) {
    node.error("{}", e.what());
  }
  for (const auto& [wanted, factor] : v.value.terms)
    if (std::find(series_.begin(), series_.end(), wanted) == series_.end())
      node.error("the network has no series \"{}\"{}", wanted, did_you_mean(wanted, series_));
  return v;
}

void SvzerodCsv::write(const ResultsFolder& folder) const {
  const Rows rows = read_rows(folder.file("network.csv"), begin_);
  std::map<std::string, std::size_t> column;
  for (std::size_t i = 0; i < series_.size(); ++i) column[series_[i]] = i;
  std::string text = "name,time,y\n";
  for (const auto& v : variables_) {
    double sum = 0;
    for (std::size_t k = 0; k < rows.time.size(); ++k) {
      const bool first = v.start && rows.time[k] == 0;
      const double y =
          first ? *v.start
                : v.value.value([&](const std::string& s) { return rows.values[k][column[s]]; }) / v.unit;
      sum += y;
      if (!mean_only_)
        fmt::format_to(std::back_inserter(text), "{},{:.16e},{:.16e}\n", v.name, rows.time[k] - shift_, y);
    }
    if (mean_only_)
      fmt::format_to(std::back_inserter(text), "{},,{:.16e}\n", v.name,
                     sum / static_cast<double>(rows.time.size()));
  }
  write_text(folder.file("svzerod.csv"), text);
}

}  // namespace ostium::app
