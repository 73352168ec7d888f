#include "app/sweep/table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "core/error.hpp"

namespace ostium::app {
namespace {

using network::Outcome;

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (std::size_t begin = 0; begin <= line.size();) {
    const auto end = std::min(line.find(',', begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return cells;
}

/// Not a number where it is none.
double number_of(std::string_view cell) {
  double value = NAN;
  std::from_chars(cell.data(), cell.data() + cell.size(), value);
  return value;
}

std::string joined(const std::vector<std::string>& cells) {
  std::string line;
  for (const auto& cell : cells) line += (line.empty() ? "" : ",") + cell;
  return line;
}

}  // namespace

const std::string& word(Outcome outcome) {
  static const std::string words[] = {"ok", "failed", "refused", "open"};
  return words[static_cast<std::size_t>(outcome)];
}

SweepTable::SweepTable(std::filesystem::path file, const SweepPlan& plan, bool resumes)
    : file_(std::move(file)), plan_(plan), values_(static_cast<std::size_t>(plan.design.columns())) {
  const auto bytes = resumes ? take_up() : 0;
  if (bytes > 0)
    csv_.emplace(file_, header(), bytes);
  else
    csv_.emplace(file_, header());
  csv_->flush();
}

std::vector<std::string> SweepTable::header() const {
  std::vector<std::string> all{"sample"};
  for (const auto& columns : {plan_.parameter_columns(), plan_.result_columns()})
    all.insert(all.end(), columns.begin(), columns.end());
  all.push_back("status");
  return all;
}

void SweepTable::add(const network::SampleResult& sample) {
  const std::int64_t row = rows();
  plan_.design.row(row, values_);
  *csv_ << std::to_string(row);
  for (const double v : values_) *csv_ << v;
  for (const double v : sample.results) *csv_ << v;
  *csv_ << word(sample.outcome);
  csv_->end_row();
  outcomes_.push_back(sample.outcome);
  results_.insert(results_.end(), sample.results.begin(), sample.results.end());
}

std::int64_t SweepTable::count(Outcome outcome) const {
  return std::count(outcomes_.begin(), outcomes_.end(), outcome);
}

/// Reads the rows that are whole; returns how many bytes they and the header take, 0 where not even that is there.
std::uintmax_t SweepTable::take_up() {
  std::ifstream stream(file_, std::ios::binary);
  std::string line;
  std::uintmax_t whole = 0;
  for (bool first = true; std::getline(stream, line) && !stream.eof(); first = false) {
    if (first && line != joined(header()))
      user_error(
          "{}:1: the table has other columns than the sweep of this case; start anew in another folder (-o) "
          "without "
          "--resume",
          file_.string());
    if (!first) take_up_row(line);
    whole += line.size() + 1;
  }
  return whole;
}

void SweepTable::take_up_row(const std::string& line) {
  const std::int64_t row = rows();
  const auto cells = cells_of(line);
  const std::size_t columns = values_.size(), results = plan_.results.size();
  const auto refuse = [&] {
    user_error(
        "{}:{}: this row is not that of sample {} of this sweep; start anew in another folder (-o) without "
        "--resume",
        file_.string(), row + 2, row);
  };
  if (row >= plan_.design.rows() || cells.size() != columns + results + 2 || cells[0] != std::to_string(row))
    refuse();
  plan_.design.row(row, values_);
  for (std::size_t k = 0; k < columns; ++k)
    if (number_of(cells[1 + k]) != values_[k]) refuse();
  const Outcome known[] = {Outcome::ok, Outcome::failed, Outcome::refused};
  const auto outcome =
      std::find_if(std::begin(known), std::end(known), [&](Outcome o) { return word(o) == cells.back(); });
  if (outcome == std::end(known)) refuse();
  outcomes_.push_back(*outcome);
  for (std::size_t k = 0; k < results; ++k) results_.push_back(number_of(cells[1 + columns + k]));
}

}  // namespace ostium::app
