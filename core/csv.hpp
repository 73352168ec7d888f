/// Reading and writing of tables as comma-separated values, independent of the locale.
#pragma once
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <span>
#include <string>
#include <vector>

namespace ostium {

/// Puts a number behind a text, in the shortest form that reads back exactly.
void append_number(std::string& text, double value);

/// Rows of numbers and names behind a header line; numbers in that form.
class CsvWriter {
 public:
  CsvWriter(const std::filesystem::path& file, const std::vector<std::string>& header);
  /// Goes on with a file: its first `bytes` are kept, what comes after them is cut off. Throws UserError where it is shorter.
  CsvWriter(const std::filesystem::path& file, const std::vector<std::string>& header, std::uintmax_t bytes);
  ~CsvWriter();
  CsvWriter(const CsvWriter&) = delete;
  CsvWriter& operator=(const CsvWriter&) = delete;

  CsvWriter& operator<<(double value);
  CsvWriter& operator<<(const std::string& text);
  void end_row();  // asserts that the row has as many cells as the header
  void row(std::span<const double> cells);
  void flush();
  std::uintmax_t bytes();  // of the file, with everything written so far

 private:
  void separate();
  std::filesystem::path file_;
  std::ofstream stream_;
  std::string buffer_;
  std::size_t columns_, cell_ = 0;
};

/// A table of numbers: columns separated by comma, semicolon, tabulator or blanks; lines beginning with # are
/// skipped; leading lines that are no numbers are header lines.
struct Table {
  std::vector<std::string> names;            // cells of the last header line; empty if there is none
  std::vector<std::vector<double>> columns;  // all of one length
  std::vector<int> lines;                    // line number of each row in the file, from 1
};

/// A cell of a header with what it says of the unit: "flow [mL/s]", "flow (mL/s)"; empty where it says nothing.
struct ColumnName {
  std::string name, unit;
};
ColumnName column_name(const std::string& cell);

/// Reads a table, leaving out the first `skip` lines; throws UserError naming file, line and cell.
Table read_table(const std::filesystem::path& file, int skip = 0);
/// The same of what stands in the file.
Table parse_table(const std::string& text, const std::string& file_name, int skip = 0);

}  // namespace ostium
