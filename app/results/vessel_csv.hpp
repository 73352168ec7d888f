/// The series of the vessel itself as CSV files. All values SI; a vessel in 2D is one metre deep.
///
///   wall.csv     pressure_force, friction_force    N   of the blood on the wall between the caps, see
///                sph3d/fields/wall_sums; where it moves: largest_displacement m, of the wall point that is
///                now at (at_x, at_y, at_z) m; strain_energy J
///   probes.csv   a row per probe: where it is, m; velocity m/s and physical pressure Pa of the blood there
///                on the wall: displacement from where it was at first m, wall_shear_stress Pa
///
/// What a probe does not have is left empty.
#pragma once
#include <string>

#include "app/results/series.hpp"
#include "sph3d/fields/wall_sums.hpp"

namespace ostium::app {

template <int D>
struct WallRow {
  double time = 0;  // s
  sph3d::WallForce<D> force;
  sph3d::Furthest<D> furthest = {};  // from here on where the wall moves
  double strain_energy = 0;          // J
};

template <int D>
class WallCsv {
 public:
  WallCsv(const std::filesystem::path& file, bool moves, Keep keep = {});
  void row(const WallRow<D>& row);
  void flush() { csv_.flush(); }
  std::uintmax_t bytes() { return csv_.bytes(); }

 private:
  bool moves_;
  CsvWriter csv_;
};

template <int D>
struct ProbeRow {
  Vec<D> position;
  std::optional<Vec<D>> velocity = {};
  std::optional<double> pressure = {};
  std::optional<Vec<D>> displacement = {}, shear_stress = {};
};

template <int D>
class ProbesCsv {
 public:
  explicit ProbesCsv(const std::filesystem::path& file, Keep keep = {});
  void row(double time, const std::string& probe, const ProbeRow<D>& row);
  void flush() { csv_.flush(); }
  std::uintmax_t bytes() { return csv_.bytes(); }

 private:
  void vector(const std::optional<Vec<D>>& v);
  CsvWriter csv_;
};

}  // namespace ostium::app
