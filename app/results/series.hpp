/// The series of a run as CSV files: ports.csv, network.csv, balance.csv. All values SI.
///
///   flow_out    m3/s  positive when leaving the vessel (an inlet shows negative values)
///   pressure    Pa    physical, the datum of the fluid solver added back
///   volume_out  m3    that has left since the start
#pragma once
#include <span>
#include <string>
#include <vector>

#include "core/csv.hpp"

namespace ostium::app {

/// Thins a series to one row per interval: true at the first call, then whenever the next multiple of `every` is reached.
class Thinning {
 public:
  explicit Thinning(double every) : every_(every) {}
  bool due(double time);

 private:
  double every_;
  long next_ = 0;
};

struct PortRow {
  double flow_out = 0, pressure = 0, volume_out = 0;
};

class PortsCsv {
 public:
  PortsCsv(const std::filesystem::path& file, std::vector<std::string> ports);
  void rows(double time, std::span<const PortRow> ports);  // one per port
  void flush() { csv_.flush(); }

 private:
  std::vector<std::string> ports_;
  CsvWriter csv_;
};

class NetworkCsv {
 public:
  NetworkCsv(const std::filesystem::path& file, const std::vector<std::string>& series);
  void row(double time, std::span<const double> values);
  void flush() { csv_.flush(); }

 private:
  CsvWriter csv_;
};

struct BalanceRow {
  double time = 0;                            // s
  double volume_inside = 0, in = 0, out = 0;  // m3
  double discrepancy = 0;                     // m3, volume inside - start - in + out
  double kinetic_energy = 0;                  // J
  double max_density_error = 0;               // -, relative to the rest density
  long escaped = 0;                           // particles lost through the wall
  std::string bound = "none";                 // what limited the last step: sph3d/step/phases
};

class BalanceCsv {
 public:
  explicit BalanceCsv(const std::filesystem::path& file);
  void row(const BalanceRow& row);
  void flush() { csv_.flush(); }

 private:
  CsvWriter csv_;
};

}  // namespace ostium::app
