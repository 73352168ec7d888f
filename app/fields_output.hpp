/// The time series for ParaView: fields/fluid.pvd, fields/wall.pvd and fields/surface.pvd with one .vtp per time each.
///
///   fluid   velocity m/s, pressure Pa, density deviation -      at the particles (those in the ducts left out)
///   wall    pressure Pa, wall shear stress Pa                    at the wall points
///   surface the same, mapped to the corners of the input surface
#pragma once
#include <filesystem>

#include "app/results/series.hpp"
#include "sph3d/fields/wall_loads.hpp"
#include "sph3d/io/pvd_series.hpp"

namespace ostium::app {

template <int D>
class FieldsOutput {
 public:
  /// every: s between two times; 0: nothing is written.
  FieldsOutput(const std::filesystem::path& results, const sph3d::Model<D>& model, double every);
  void write_if_due(const sph3d::Vessel<D>& vessel);
  /// When the next fields are due.
  Thinning save() const { return thinning_; }
  /// Goes on with the series of an earlier sitting that reached `time`, s.
  void resume(const Thinning& saved, double time);
  std::size_t times() const { return fluid_.size(); }

 private:
  void write_fluid(const sph3d::Vessel<D>& vessel, const std::filesystem::path& file) const;
  void write_wall(const sph3d::Vessel<D>& vessel, const std::filesystem::path& file,
                  const std::filesystem::path& surface_file) const;

  std::filesystem::path folder_;
  bool on_;
  Thinning thinning_;
  std::vector<sph3d::WallPoint<D>> wall_points_;
  sph3d::PvdSeries fluid_, wall_, surface_;
};

}  // namespace ostium::app
