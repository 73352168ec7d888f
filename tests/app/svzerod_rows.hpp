/// Imports a model, runs it and reads svzerod.csv.
#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "program.hpp"

namespace ostium::test {

struct SvzerodSeries {
  std::vector<double> time, y;

  double at(double t) const {  // linear
    const auto k = std::lower_bound(time.begin(), time.end(), t - 1e-9) - time.begin();
    if (k == 0 || std::abs(time[k] - t) < 1e-9) return y[k];
    const double s = (t - time[k - 1]) / (time[k] - time[k - 1]);
    return y[k - 1] + s * (y[k] - y[k - 1]);
  }
};
using SvzerodRows = std::map<std::string, SvzerodSeries>;

inline SvzerodRows read_svzerod(const std::filesystem::path& file) {
  SvzerodRows rows;
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "name,time,y");
  while (std::getline(stream, line)) {
    const auto comma = line.find(','), next = line.find(',', comma + 1);
    const auto time = line.substr(comma + 1, next - comma - 1);
    auto& series = rows[line.substr(0, comma)];
    series.time.push_back(time.empty() ? NAN : std::stod(time));
    series.y.push_back(std::stod(line.substr(next + 1)));
  }
  return rows;
}

class SvzerodTest : public ProgramTest {
 protected:
  /// Empty where the program refused; `refusal` then has its text.
  SvzerodRows import_and_run(const std::filesystem::path& model, const std::string& options = "") {
    const Outcome imported =
        ostium("import svzerod '" + model.string() + "' -o case.yaml --force " + options);
    if (imported.code != 0) return refusal = imported.text, SvzerodRows{};
    const Outcome ran = ostium("run case.yaml --format svzerod -q --force -o results");
    if (ran.code != 0) return refusal = ran.text, SvzerodRows{};
    return read_svzerod(folder() / "results/svzerod.csv");
  }
  std::string refusal;
};

}  // namespace ostium::test
