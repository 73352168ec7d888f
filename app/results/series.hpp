/// The series of a run as CSV files: ports.csv, network.csv, balance.csv. All values SI.
///
///   flow_out    m3/s  positive when leaving the vessel (an inlet shows negative values)
///   pressure    Pa    physical, the datum of the fluid solver added back
///   volume_out  m3    that has left since the start
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/archive.hpp"
#include "core/csv.hpp"

namespace ostium::app {

/// Thins a series to one row per interval: true at the first call, then whenever the next multiple of `every` is reached.
class Thinning {
 public:
  explicit Thinning(double every = 0) : every_(every) {}
  bool due(double time);
  void archive(Archive& a);
  /// Counts on from an earlier sitting, whose interval may have been another one.
  void go_on(const Thinning& saved);

 private:
  double every_;
  long next_ = 0;
};

/// Bytes of a file to go on with; nothing: a new file.
using Keep = std::optional<std::uintmax_t>;
CsvWriter csv_writer(const std::filesystem::path& file, const std::vector<std::string>& header, Keep keep);

struct PortRow {
  double flow_out = 0, pressure = 0, volume_out = 0;
};

class PortsCsv {
 public:
  PortsCsv(const std::filesystem::path& file, std::vector<std::string> ports, Keep keep = {});
  void rows(double time, std::span<const PortRow> ports);  // one per port
  void flush() { csv_.flush(); }
  std::uintmax_t bytes() { return csv_.bytes(); }

 private:
  std::vector<std::string> ports_;
  CsvWriter csv_;
};

class NetworkCsv {
 public:
  NetworkCsv(const std::filesystem::path& file, const std::vector<std::string>& series, Keep keep = {});
  void row(double time, std::span<const double> values);
  void flush() { csv_.flush(); }
  std::uintmax_t bytes() { return csv_.bytes(); }

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
  explicit BalanceCsv(const std::filesystem::path& file, Keep keep = {});
  void row(const BalanceRow& row);
  void flush() { csv_.flush(); }
  std::uintmax_t bytes() { return csv_.bytes(); }

 private:
  CsvWriter csv_;
};

}  // namespace ostium::app
