/// Runs the cases of the project by the program itself and reads what they wrote.
#pragma once
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/program.hpp"
#include "core/csv.hpp"

namespace ostium::test {

/// A signal in time: times s, increasing.
struct Signal {
  std::vector<double> time, value;

  double at(double t) const;                   // linear, end values held
  Signal between(double t0, double t1) const;  // samples of the interval, both ends interpolated
  double mean() const;                         // trapezoids
  double min() const, max() const;
};

/// rms over the samples of a of a(t) - b(t mod period).
double rms_difference(const Signal& a, const Signal& b, double period);

/// One opening of ports.csv.
struct PortSignals {
  Signal flow_out, pressure, volume_out;
};
std::map<std::string, PortSignals> read_ports(const std::filesystem::path& file);

/// A column of a table with a header, against its first column.
Signal column(const Table& table, const std::string& name);
/// The same of a file that also has columns of words (balance.csv).
Signal column(const std::filesystem::path& file, const std::string& name);

class CaseRun : public ProgramTest {
 protected:
  static std::filesystem::path case_file(const std::string& name) {
    return std::filesystem::path(OSTIUM_SOURCE_DIR) / "cases" / name / "case.yaml";
  }
  static Table reference(const std::string& name) {
    return read_table(case_file(name).parent_path() / "reference.csv");
  }
  /// A surface of the reference data; nothing where that is absent.
  static std::optional<std::filesystem::path> data(const std::string& name) {
    const auto file = std::filesystem::path(OSTIUM_DATA_DIR) / "vessels" / name;
    return std::filesystem::exists(file) ? std::optional(file) : std::nullopt;
  }
  /// `ostium geometry` into the folder of the test.
  std::filesystem::path geometry(const std::string& shape_and_options) const;

  /// Runs the case into results/ of the test's folder; expects it to finish, with all that a run must keep.
  void run(const std::string& name, const std::string& options);

  nlohmann::json summary() const { return nlohmann::json::parse(content("results/summary.json")); }
  /// The value, printed: what a test has found, beside what it requires.
  static double noted(const std::string& what, double value);
  std::map<std::string, PortSignals> ports() const { return read_ports(folder() / "results/ports.csv"); }

 private:
  void expect_vessel_results() const;
};

}  // namespace ostium::test
