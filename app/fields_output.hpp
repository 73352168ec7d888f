/// The time series for ParaView: fields/fluid.pvd, fields/wall.pvd and fields/surface.pvd with one .vtp per time each, and the
/// fields of whole cycles.
///
///   fluid             velocity m/s, pressure Pa, density deviation -      at the particles (those in the ducts left out)
///   wall and surface  see wall_output.hpp
#pragma once
#include <filesystem>
#include <optional>

#include "app/results/series.hpp"
#include "app/wall_output.hpp"

namespace ostium::app {

/// What a run goes on from: when the next fields are due, and what the wall has felt in this cycle.
template <int D>
struct SavedFields {
  Thinning thinning;
  SavedWall<D> wall;
};

template <int D>
void archive(Archive& a, SavedFields<D>& saved);

struct FieldsTimes {
  double every = 0;   // s between two sets of fields; 0: nothing is written
  double period = 0;  // s; 0: the run is one cycle
  double end = 0;     // s
};

template <int D>
class FieldsOutput {
 public:
  FieldsOutput(const std::filesystem::path& results, const sph3d::Vessel<D>& vessel,
               sph3d::WallSampler<D>& sampler, const FieldsTimes& times);
  /// After every step.
  void follow(const sph3d::Vessel<D>& vessel);
  /// The run has come to its end.
  void finish();
  /// Tells the user what the fields are not good for.
  void judge(double spacing) const;

  SavedFields<D> save() const;
  /// Goes on with the series of an earlier sitting that reached `time`, s.
  void resume(const SavedFields<D>& saved, double time);
  std::size_t times() const { return fluid_.size(); }

 private:
  void write_fluid(const sph3d::Vessel<D>& vessel, const std::filesystem::path& file) const;

  std::filesystem::path folder_;
  Thinning thinning_;
  sph3d::PvdSeries fluid_;
  std::optional<WallOutput<D>> wall_;  // none where nothing is written
};

}  // namespace ostium::app
