/// The wall's share of the files for ParaView: wall_NNNNN.vtp at the wall points, surface_NNNNN.vtp at the corners of the input
/// surface, displaced with the wall; and after each cycle cycle_NNN_wall.vtp and cycle_NNN_surface.vtp. Each has its series (.pvd).
///
///   wall, surface       pressure Pa, wall_shear_stress Pa, wall_shear_stress_gradient Pa
///   where it moves      displacement m, stress_{inner,middle,outer} Pa, von_mises_{inner,middle,outer} Pa, strain_energy J/m2
///   cycle               tawss Pa, osi -, rrt 1/Pa, mean_wall_shear_stress Pa, mean_pressure Pa
///   wall only           area m2, normal -
///
/// Source: sph3d/fields (wall_loads, wall_gradient, wall_cycle, structure_fields, surface_map).
#pragma once
#include <filesystem>

#include "sph3d/fields/stress_agreement.hpp"
#include "sph3d/fields/surface_map.hpp"
#include "sph3d/fields/wall_cycle.hpp"
#include "sph3d/fields/wall_loads.hpp"
#include "sph3d/io/pvd_series.hpp"

namespace ostium::app {

/// What the wall has felt in this cycle, and how far two measures of that agree.
template <int D>
struct SavedWall {
  sph3d::WallCycle<D> cycle;
  sph3d::StressAgreement agreement;
};

template <int D>
class WallOutput {
 public:
  /// The sampler is this vessel's, shared with others. period, s; 0: the whole run is one cycle, of about
  /// `end`, s.
  WallOutput(const std::filesystem::path& folder, const sph3d::Vessel<D>& vessel,
             sph3d::WallSampler<D>& sampler, double period, double end);

  /// After every step: samples the wall four times in the time of its filter and where a cycle ends, and writes
  /// that cycle.
  void follow(const sph3d::Vessel<D>& vessel);
  /// The fields of now, under this number of five digits.
  void write(const sph3d::Vessel<D>& vessel, const std::string& number);
  /// The run has come to its end: where it is one cycle, that is written.
  void finish();
  /// Tells the user where both measures of the wall shear stress differ over a large part of the wall.
  void judge(double spacing) const;

  SavedWall<D> save() const { return {cycle_, agreement_}; }
  void resume(const SavedWall<D>& saved, double time);

 private:
  void write_cycle(const sph3d::CycleFields<D>& fields);
  sph3d::CycleFields<D> take_sample(const sph3d::Vessel<D>& vessel);
  void compare(const sph3d::Vessel<D>& vessel);

  std::filesystem::path folder_;
  double period_, end_, filter_, interval_;
  sph3d::WallSampler<D>& sampler_;
  sph3d::SurfaceMap<D> map_;
  sph3d::WallCycle<D> cycle_;
  sph3d::StressAgreement agreement_;
  sph3d::PvdSeries wall_, surface_, cycles_wall_, cycles_surface_;
};

}  // namespace ostium::app
