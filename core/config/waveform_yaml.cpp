// The forms in which a case gives a waveform:
//   flow: 5 L/min
//   flow: {file: inflow.csv, period: 0.66 s}
//   flow: {times: [0, 0.3, 0.66], time_unit: s, values: [0, 80, 0], unit: mL/s, period: 0.66 s}
//   flow: {fourier: {mean: 5, cos: [1], sin: [2]}, unit: L/min, period: 0.66 s}
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/config/waveform_form.hpp"
#include "core/did_you_mean.hpp"
#include "core/log.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace ostium::config {
namespace {

std::size_t column_index(const std::string& wanted, const Table& table, const Node& node) {
  std::vector<std::string> names;
  for (const auto& cell : table.names) names.push_back(column_name(cell).name);
  const std::size_t count = table.columns.size();
  const auto named = std::find(names.begin(), names.end(), wanted);
  if (const auto k = static_cast<std::size_t>(named - names.begin()); named != names.end() && k < count)
    return k;
  if (named != names.end())
    node.error(
        "the header has {} names, the rows below have {} columns, so that \"{}\" is none of them; correct "
        "the "
        "file",
        names.size(), count, shown(wanted));
  for (std::size_t k = 0; k < count; ++k)
    if (wanted == std::to_string(k + 1)) return k;
  node.error("the file has no column \"{}\"; it has {} columns, counted from 1{}", shown(wanted), count,
             did_you_mean(wanted, names));
}

struct Columns {
  std::vector<double> times, values;
  std::string time_unit, unit;
};

Columns pick_columns(const Table& table, const WaveformForm& form) {
  const Node file = form.origin.at("file");
  if (table.columns.size() < 2)
    file.error("the file needs a column of times and one of values, found one column");
  const Node at = form.columns.empty() ? file : form.origin.at("columns");
  if (!form.columns.empty() && form.columns.size() != 2) at.error("expected two columns, [time, value]");
  const std::size_t t = form.columns.empty() ? 0 : column_index(form.columns[0], table, at);
  const std::size_t w = form.columns.empty() ? 1 : column_index(form.columns[1], table, at);
  Columns c{table.columns[t], table.columns[w], {}, {}};
  if (t < table.names.size()) c.time_unit = column_name(table.names[t]).unit;
  if (w < table.names.size()) c.unit = column_name(table.names[w]).unit;
  return c;
}

void convert(std::vector<double>& values, const std::string& unit, const std::string& si, const Node& node) {
  try {
    for (double& v : values) v = to_si(v, unit, si);
  } catch (const UserError& e) {
    node.error("{}", e.what());
  }
}

Waveform::Table samples_of_file(const WaveformForm& form, const std::string& si, const TableReader& content) {
  const Node node = form.origin.at("file");
  try {
    const Table table = content(*form.file, form.skip);
    Columns c = pick_columns(table, form);
    const std::string unit = form.unit.value_or(c.unit.empty() && si == "1" ? "1" : c.unit);
    if (unit.empty())
      form.origin.error("the unit of the values in {} is missing; add for example \"unit: {}\"",
                        form.file->string(), si);
    convert(c.times, form.time_unit.value_or(c.time_unit.empty() ? "s" : c.time_unit), "s", node);
    convert(c.values, unit, si, node);
    Waveform::Table samples{std::move(c.times), std::move(c.values), form.period.value_or(0),
                            form.interpolation};
    Waveform::check(samples,
                    [&](std::size_t i) { return fmt::format("{}:{}", form.file->string(), table.lines[i]); });
    return samples;
  } catch (const UserError& e) {
    const std::string text = e.what();
    text.starts_with(node.file() + ":") ? throw : node.error("{}", text);
  }
}

/// A list of numbers whose unit stands beside them or behind each of them.
std::vector<double> values_of(const Node& list, const std::optional<std::string>& unit, const char* key,
                              const std::string& si) {
  std::vector<double> values;
  for (const Node& item : list.items()) try {
      const Measure m = parse_measure(item.text());
      if (m.unit.empty() && !unit && si != "1")
        item.error(
            "expected a value with a unit of dimension {0}, found the bare number {1}; add \"{2}: {0}\"", si,
            item.text(), key);
      values.push_back(to_si(m.value, !m.unit.empty() ? m.unit : unit.value_or("1"), si));
    } catch (const UserError& e) {
      const std::string text = e.what();
      text.starts_with(item.file() + ":") ? throw : item.error("{}", text);
    }
  return values;
}

Waveform::Table samples_inline(const WaveformForm& form, const std::string& si) {
  return {values_of(*form.times, form.time_unit, "time_unit", "s"),
          values_of(*form.values, form.unit, "unit", si), form.period.value_or(0), form.interpolation};
}

/// Ends that disagree are no error: the first sample counts for both.
void warn_of_open_period(const Waveform::Table& s, const Node& node, const std::string& si) {
  const double span = s.times.back() - s.times.front(), period = s.period;
  if (period <= 0 || std::abs(span - period) > 1e-6 * period) return;
  const auto [low, high] = std::minmax_element(s.values.begin(), s.values.end());
  if (std::abs(s.values.back() - s.values.front()) > 1e-3 * (*high - *low))
    log::warn(
        "{}",
        node.message(fmt::format(
            "the first and the last value of the period differ ({} and {} {}); the first is used for both",
            shortest(s.values.front()), shortest(s.values.back()), si)));
}

Waveform waveform_of_table(const WaveformForm& form, const std::string& si, const TableReader& content) {
  const Waveform::Table samples = form.file ? samples_of_file(form, si, content) : samples_inline(form, si);
  const Waveform w = form.modes ? Waveform::fourier_of(samples, *form.modes) : Waveform::table(samples);
  warn_of_open_period(samples, form.origin, si);
  return w;
}

Waveform waveform_of_series(const WaveformForm& form, const std::string& si) {
  const Node series = *form.fourier;
  series.check_keys({"mean", "cos", "sin"});
  Waveform::Fourier f;
  f.period = form.period.value_or(0);
  if (f.period <= 0) form.origin.error("a Fourier series needs a period; add for example \"period: 0.8 s\"");
  const auto list = [&](const char* key) {
    const auto node = series.find(key);
    return node ? values_of(*node, form.unit, "unit", si) : std::vector<double>{};
  };
  if (const auto mean = series.find("mean")) {
    const auto has_unit = [&] {
      try {
        return !parse_measure(mean->text()).unit.empty();
      } catch (const UserError&) {
        return true;  // its reader says what is wrong with it
      }
    };
    const std::string text = mean->text() + (form.unit && !has_unit() ? " " + *form.unit : "");
    f.mean = read_quantity(Node(*mean).with_text(text), {.unit = si});
  }
  f.cos = list("cos"), f.sin = list("sin");
  return Waveform::fourier(std::move(f));
}

}  // namespace

Waveform read_waveform(const Node& node, const std::string& unit) {
  return read_waveform(node, unit, read_table);
}

Waveform read_waveform(const Node& node, const std::string& unit, const TableReader& content) {
  if (node.is_scalar()) return Waveform::constant(read_quantity(node, {.unit = unit}));
  if (!node.is_map())
    node.error(
        "expected a waveform: a constant like \"5 {}\", or a mapping with file, with times and values, or "
        "with fourier; found {}",
        unit, node.describe());
  const WaveformForm form = read<WaveformForm>(node);
  try {
    const Waveform w = form.fourier ? waveform_of_series(form, unit) : waveform_of_table(form, unit, content);
    return w.scaled(form.sign).delayed(form.delay);
  } catch (const UserError& e) {
    const std::string text = e.what();
    text.starts_with(node.file() + ":") ? throw : node.error("{}", text);
  }
}

Tree write_waveform(const Waveform& w, const std::string& unit) {
  if (w.is_constant()) return write_quantity(w.mean(), unit);
  Tree form = Tree::map();
  if (w.form() == Waveform::Form::fourier) {
    const auto series = w.series();
    Tree f = Tree::map();
    f.add("mean", write_quantity(series.mean, "")).add("cos", write_quantities(series.cos, ""));
    f.add("sin", write_quantities(series.sin, ""));
    form.add("fourier", std::move(f));
  } else {
    form.add("times", write_quantities(w.times(), "")).add("time_unit", Tree::scalar("s"));
    form.add("values", write_quantities(w.values(), ""));
    form.add("interpolation",
             Tree::scalar(w.interpolation() == Interpolation::linear ? "linear" : "monotone_cubic"));
  }
  form.add("unit", Tree::scalar(unit));
  if (w.period() > 0) form.add("period", write_quantity(w.period(), "s"));
  return form;
}

}  // namespace ostium::config
