#include "app/results/svzerod_csv.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>

#include "app/import/expression.hpp"
#include "app/import/unit_system.hpp"
#include "core/csv.hpp"
#include "core/did_you_mean.hpp"
#include "core/units.hpp"

namespace ostium::app {
namespace {

double start_of(const std::string& name, const config::Node& start) {
  const auto given = start.find(name);
  if (!given) return 0;
  try {
    return parse_number(given->text());
  } catch (const UserError& e) {
    given->error("{}", e.what());
  }
}

}  // namespace

SvzerodCsv::SvzerodCsv(const Case& study, const std::vector<std::string>& series)
    : series_(series), mean_only_(study.output.svzerod.mean_only) {
  for (std::size_t i = 0; i < series.size(); ++i) place_[series[i]] = i;
  const auto& wanted = study.output.svzerod;
  if (wanted.variables)
    for (const auto& [name, node] : wanted.variables->entries()) variables_.push_back(read(name, node));
  else
    for (std::size_t i = 0; i < series.size(); ++i) variables_.push_back({series[i], 1, {{1, i}}});
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
  Variable v{name, 1, {}};
  Expression value;
  try {
    v.unit = UnitSystem::si(texts[0]);
    value = Expression::parse({texts.begin() + 1, texts.end()});
  } catch (const UserError& e) {
    node.error("{}", e.what());
  }
  v.constant = value.constant;
  for (const auto& [wanted, factor] : value.terms) {
    const auto found = place_.find(wanted);
    if (found == place_.end())
      node.error("the network has no series \"{}\"{}", wanted, did_you_mean(wanted, series_));
    v.terms.push_back({factor, found->second});
  }
  return v;
}

double SvzerodCsv::Variable::value(const double* series) const {
  double sum = constant;
  for (const auto& term : terms) sum += term.factor * series[term.series];
  return sum / unit;
}

void SvzerodCsv::recall(const ResultsFolder& folder) {
  std::ifstream stream(folder.file("network.csv"));
  std::string line;
  std::getline(stream, line);
  std::vector<double> cells;
  while (std::getline(stream, line)) {
    cells.clear();
    const char *at = line.data(), *const end = at + line.size();
    for (double number = 0; at < end; ++at)
      at = std::from_chars(at, end, number).ptr, cells.push_back(number);
    if (cells.size() == series_.size() + 1) row(cells[0], std::span(cells).subspan(1));
  }
}

void SvzerodCsv::row(double time, std::span<const double> series) {
  if (time < begin_) return;
  times_.push_back(time);
  values_.insert(values_.end(), series.begin(), series.end());
}

void SvzerodCsv::write(const ResultsFolder& folder) const {
  std::vector<std::string> times;  // as they stand in every line
  for (double time : times_) append_number(times.emplace_back(","), time - shift_), times.back() += ',';
  std::string text = "name,time,y\n";
  for (const auto& v : variables_) {
    double sum = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
      const bool first = v.start && times_[k] == 0;
      const double y = first ? *v.start : v.value(&values_[k * series_.size()]);
      sum += y;
      if (!mean_only_) text += v.name, text += times[k], append_number(text, y), text += '\n';
    }
    if (!mean_only_) continue;
    text += v.name + ",,";
    append_number(text, sum / static_cast<double>(times.size()));
    text += '\n';
  }
  write_text(folder.file("svzerod.csv"), text);
}

}  // namespace ostium::app
