#include "app/results/series.hpp"

#include <cmath>

namespace ostium::app {
namespace {

std::vector<std::string> with_time(const std::vector<std::string>& series) {
  std::vector<std::string> header{"time_s"};
  header.insert(header.end(), series.begin(), series.end());
  return header;
}

}  // namespace

CsvWriter csv_writer(const std::filesystem::path& file, const std::vector<std::string>& header, Keep keep) {
  if (keep) return CsvWriter(file, header, *keep);
  return CsvWriter(file, header);
}

bool Thinning::due(double time) {
  if (time < next_ * every_ * (1 - 1e-9)) return false;
  next_ = static_cast<long>(std::floor(time / every_ * (1 + 1e-9))) + 1;
  return true;
}

void Thinning::archive(Archive& a) {
  std::int64_t next = next_;
  a("every", every_);
  a("next", next);
  next_ = static_cast<long>(next);
}

void Thinning::go_on(const Thinning& saved) {
  next_ = saved.next_;
  if (saved.every_ == every_ || every_ <= 0) return;
  next_ = static_cast<long>(std::ceil(static_cast<double>(saved.next_) * saved.every_ / every_ - 1e-9));
}

PortsCsv::PortsCsv(const std::filesystem::path& file, std::vector<std::string> ports, Keep keep)
    : ports_(std::move(ports)),
      csv_(csv_writer(file, {"time_s", "port", "flow_out_m3_s", "pressure_Pa", "volume_out_m3"}, keep)) {}

void PortsCsv::rows(double time, std::span<const PortRow> ports) {
  for (std::size_t k = 0; k < ports_.size(); ++k) {
    csv_ << time << ports_[k] << ports[k].flow_out << ports[k].pressure << ports[k].volume_out;
    csv_.end_row();
  }
}

NetworkCsv::NetworkCsv(const std::filesystem::path& file, const std::vector<std::string>& series, Keep keep)
    : csv_(csv_writer(file, with_time(series), keep)) {}

void NetworkCsv::row(double time, std::span<const double> values) {
  csv_ << time;
  csv_.row(values);
}

BalanceCsv::BalanceCsv(const std::filesystem::path& file, Keep keep)
    : csv_(csv_writer(file,
                      {"time_s", "volume_inside_m3", "volume_in_m3", "volume_out_m3", "discrepancy_m3",
                       "kinetic_energy_J", "max_density_error", "escaped_particles", "step_bound"},
                      keep)) {}

void BalanceCsv::row(const BalanceRow& r) {
  csv_ << r.time << r.volume_inside << r.in << r.out << r.discrepancy << r.kinetic_energy
       << r.max_density_error << static_cast<double>(r.escaped) << r.bound;
  csv_.end_row();
}

}  // namespace ostium::app
