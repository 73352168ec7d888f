#include "app/results/vessel_csv.hpp"

#include <fmt/format.h>

namespace ostium::app {
namespace {

/// "NAMEx_UNIT", "NAMEy_UNIT", ..
template <int D>
void add_vector(std::vector<std::string>& header, const std::string& name, const std::string& unit) {
  for (int d = 0; d < D; ++d) header.push_back(fmt::format("{}{}_{}", name, "xyz"[d], unit));
}

template <int D>
std::vector<std::string> wall_header(bool moves) {
  std::vector<std::string> header{"time_s"};
  add_vector<D>(header, "pressure_force_", "N");
  add_vector<D>(header, "friction_force_", "N");
  if (!moves) return header;
  header.push_back("largest_displacement_m");
  add_vector<D>(header, "at_", "m");
  header.push_back("strain_energy_J");
  return header;
}

template <int D>
std::vector<std::string> probes_header() {
  std::vector<std::string> header{"time_s", "probe"};
  add_vector<D>(header, "", "m");
  add_vector<D>(header, "velocity_", "m_s");
  header.push_back("pressure_Pa");
  add_vector<D>(header, "displacement_", "m");
  add_vector<D>(header, "wall_shear_stress_", "Pa");
  return header;
}

template <int D>
CsvWriter& operator<<(CsvWriter& csv, const Vec<D>& v) {
  for (int d = 0; d < D; ++d) csv << v[d];
  return csv;
}

}  // namespace

template <int D>
WallCsv<D>::WallCsv(const std::filesystem::path& file, bool moves, Keep keep)
    : moves_(moves), csv_(csv_writer(file, wall_header<D>(moves), keep)) {}

template <int D>
void WallCsv<D>::row(const WallRow<D>& r) {
  csv_ << r.time << r.force.pressure << r.force.friction;
  if (moves_) csv_ << r.furthest.displacement << r.furthest.position << r.strain_energy;
  csv_.end_row();
}

template <int D>
ProbesCsv<D>::ProbesCsv(const std::filesystem::path& file, Keep keep)
    : csv_(csv_writer(file, probes_header<D>(), keep)) {}

template <int D>
void ProbesCsv<D>::vector(const std::optional<Vec<D>>& v) {
  for (int d = 0; d < D; ++d)
    if (v)
      csv_ << (*v)[d];
    else
      csv_ << std::string();
}

template <int D>
void ProbesCsv<D>::row(double time, const std::string& probe, const ProbeRow<D>& r) {
  csv_ << time << probe << r.position;
  vector(r.velocity);
  if (r.pressure)
    csv_ << *r.pressure;
  else
    csv_ << std::string();
  vector(r.displacement);
  vector(r.shear_stress);
  csv_.end_row();
}

template class WallCsv<2>;
template class WallCsv<3>;
template class ProbesCsv<2>;
template class ProbesCsv<3>;

}  // namespace ostium::app
