#include <algorithm>

#include "app/sweep/plan.hpp"
#include "core/csv.hpp"
#include "core/did_you_mean.hpp"
#include "core/error.hpp"
#include "core/units.hpp"

namespace ostium::app {
namespace {

using network::Variation;

/// The cells of the header. Of a single column the blank in front of the unit has separated the two.
std::vector<ColumnName> header_of(const Table& table, const std::string& file) {
  std::vector<std::string> cells = table.names;
  if (cells.size() == 2 && table.columns.size() == 1) cells = {cells[0] + " " + cells[1]};
  if (cells.empty())
    user_error("{}: the samples need a header line that names the parameters, such as \"body.Rd [Pa.s/m3]\"",
               file);
  if (cells.size() != table.columns.size())
    user_error("{}: the header names {} columns, the rows have {}", file, cells.size(), table.columns.size());
  std::vector<ColumnName> all;
  for (const auto& cell : cells) all.push_back(column_name(cell));
  return all;
}

std::size_t find(const std::string& name, const std::vector<ColumnName>& header, const std::string& file) {
  std::vector<std::string> names;
  for (const auto& cell : header) names.push_back(cell.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    user_error("{}: the samples have no column \"{}\"{}", file, name, did_you_mean(name, names));
  return static_cast<std::size_t>(found - names.begin());
}

std::string unit_of(const ColumnName& column, const network::Parameter& p, const std::string& file) {
  if (column.unit.empty() && p.unit != "1")
    user_error("{0}: the column \"{1}\" has no unit; write for example \"{1} [{2}]\"", file, p.name, p.unit);
  return column.unit.empty() ? "1" : column.unit;
}

std::vector<double> values_of(const Table& table, std::size_t k, const std::string& unit,
                              const network::Parameter& p, const std::string& file) {
  std::vector<double> values = table.columns[k];
  for (std::size_t i = 0; i < values.size(); ++i) try {
      values[i] = to_si(values[i], unit, p.unit);
      check_value(p, values[i]);
    } catch (const UserError& error) {
      user_error("{}:{}: column \"{}\": {}", file, table.lines[i], p.name, error.what());
    }
  return values;
}

}  // namespace

std::vector<Variation> read_samples(const std::filesystem::path& path, const network::Model& model,
                                    const std::vector<std::string>& names) {
  const std::string file = path.string();
  const Table table = read_table(path);
  const auto header = header_of(table, file);
  std::vector<std::string> wanted = names;
  if (wanted.empty())
    for (const auto& cell : header) wanted.push_back(cell.name);
  std::vector<Variation> all;
  for (const auto& name : wanted) {
    const std::size_t k = find(name, header, file);
    Variation v{.parameter = network::parameter(model, name, file), .law = Variation::Law::listed};
    v.values = values_of(table, k, unit_of(header[k], v.parameter, file), v.parameter, file);
    all.push_back(std::move(v));
  }
  return all;
}

}  // namespace ostium::app
