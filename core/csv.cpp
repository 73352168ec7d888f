#include "core/csv.hpp"

#include <fmt/compile.h>

#include <array>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/error.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace ostium {
namespace {

constexpr std::size_t buffer_size = 1 << 16;

bool is_separator(char c, bool blanks) { return c == ',' || c == ';' || c == '\t' || (blanks && c == ' '); }

/// Cells of a line. Blanks separate only where no other separator does ("time (s), flow (mL/s)").
std::vector<std::string> cells_of(const std::string& line) {
  const bool blanks = line.find_first_of(",;\t") == std::string::npos;
  std::vector<std::string> cells;
  std::string cell;
  const auto close = [&] {
    const auto first = cell.find_first_not_of(" \""), last = cell.find_last_not_of(" \"");
    cells.push_back(first == std::string::npos ? "" : cell.substr(first, last - first + 1));
    cell.clear();
  };
  for (char c : line) {
    if (!is_separator(c, blanks))
      cell += c;
    else if (!blanks || !cell.empty())
      close();
  }
  if (!cell.empty()) close();
  return cells;
}

/// NaN and infinities are numbers here: who reads the table says which row holds them.
bool to_number(const std::string& cell, double& value) {
  const char* begin = cell.data() + (!cell.empty() && cell[0] == '+');
  const auto [end, status] = std::from_chars(begin, cell.data() + cell.size(), value);
  return status == std::errc{} && end == cell.data() + cell.size();
}

std::vector<double> numbers_of(const std::vector<std::string>& cells, const std::string& place,
                               std::size_t columns) {
  if (cells.size() != columns)
    user_error("{}: expected {} columns as in the first row, found {}", place, columns, cells.size());
  std::vector<double> row(cells.size());
  for (std::size_t k = 0; k < cells.size(); ++k)
    if (!to_number(cells[k], row[k]))
      user_error("{}: column {}: \"{}\" is no number", place, k + 1, shown(cells[k]));
  return row;
}

bool is_header(const std::vector<std::string>& cells) {
  double x;
  return cells.empty() || !to_number(cells[0], x);
}

void add_row(Table& table, const std::vector<std::string>& cells, const std::string& file, int line) {
  if (table.columns.empty()) table.columns.resize(cells.size());
  const auto row = numbers_of(cells, fmt::format("{}:{}", file, line), table.columns.size());
  for (std::size_t k = 0; k < row.size(); ++k) table.columns[k].push_back(row[k]);
  table.lines.push_back(line);
}

}  // namespace

void append_number(std::string& text, double value) {
  std::array<char, 40> digits;
  const auto* const end = fmt::format_to(digits.data(), FMT_COMPILE("{}"), value);
  text.append(digits.data(), static_cast<std::size_t>(end - digits.data()));
}

CsvWriter::CsvWriter(const std::filesystem::path& file, const std::vector<std::string>& header)
    : file_(file), stream_(file, std::ios::binary | std::ios::trunc), columns_(header.size()) {
  if (!stream_) user_error("{}: this file cannot be written", file.string());
  for (const auto& name : header) *this << name;
  end_row();
}

CsvWriter::CsvWriter(const std::filesystem::path& file, const std::vector<std::string>& header,
                     std::uintmax_t bytes)
    : file_(file), columns_(header.size()) {
  std::error_code failed;
  const auto found = std::filesystem::file_size(file, failed);
  if (failed || found < bytes)
    user_error(
        "{}: this file {}, so the run cannot go on with it; start the run anew without --resume",
        file.string(),
        failed ? "is missing" : fmt::format("has {} bytes, at the checkpoint it had {}", found, bytes));
  std::filesystem::resize_file(file, bytes, failed);
  stream_.open(file, std::ios::binary | std::ios::app);
  if (failed || !stream_) user_error("{}: this file cannot be written", file.string());
}

CsvWriter::~CsvWriter() { stream_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size())); }

void CsvWriter::separate() {
  if (cell_++) buffer_ += ',';
}

CsvWriter& CsvWriter::operator<<(double value) {
  separate();
  append_number(buffer_, value);
  return *this;
}

CsvWriter& CsvWriter::operator<<(const std::string& text) {
  separate();
  if (text.find_first_of(",\"\n") == std::string::npos) {
    buffer_ += text;
    return *this;
  }
  buffer_ += '"';
  for (char c : text) buffer_ += c == '"' ? std::string("\"\"") : std::string(1, c);
  buffer_ += '"';
  return *this;
}

void CsvWriter::end_row() {
  OSTIUM_ASSERT(cell_ == columns_, "{}: {} cells in a row of {} columns", file_.string(), cell_, columns_);
  buffer_ += '\n';
  cell_ = 0;
  if (buffer_.size() > buffer_size) flush();
}

void CsvWriter::row(std::span<const double> cells) {
  for (double cell : cells) *this << cell;
  end_row();
}

void CsvWriter::flush() {
  stream_.write(buffer_.data(), static_cast<std::streamsize>(buffer_.size()));
  stream_.flush();
  buffer_.clear();
  if (!stream_) user_error("{}: writing failed; is the disk full?", file_.string());
}

std::uintmax_t CsvWriter::bytes() {
  flush();
  return std::filesystem::file_size(file_);
}

ColumnName column_name(const std::string& cell) {
  const auto open = cell.find_first_of("[("), close = cell.find_last_of("])");
  const std::string name = cell.substr(0, open);
  const bool has_unit = open != std::string::npos && close != std::string::npos && close > open;
  return {name.substr(0, name.find_last_not_of(' ') + 1),
          has_unit ? cell.substr(open + 1, close - open - 1) : ""};
}

Table read_table(const std::filesystem::path& file, int skip) {
  return parse_table(read_text_file(file), file.string(), skip);
}

Table parse_table(const std::string& text, const std::string& file_name, int skip) {
  std::istringstream stream(text);
  Table table;
  std::string line;
  for (int number = 1; std::getline(stream, line); ++number) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const auto first = line.find_first_not_of(" \t");
    if (number <= skip || first == std::string::npos || line[first] == '#') continue;
    const auto cells = cells_of(line.substr(first));
    if (table.columns.empty() && is_header(cells))
      table.names = cells;
    else
      add_row(table, cells, file_name, number);
  }
  if (table.columns.empty()) user_error("{}: there is no row of numbers in this file", file_name);
  return table;
}

}  // namespace ostium
