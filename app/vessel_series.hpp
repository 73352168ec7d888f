/// The series of the vessel itself: wall.csv, and probes.csv where the case has probes
/// (results/vessel_csv.hpp). One row per `output.every`, of that moment; what they show is computed for these
/// rows only.
///
/// A probe on the wall takes its values from the wall points around it, with the weights of fields on the
/// surface (sph3d/fields/surface_map).
#pragma once
#include "app/probes.hpp"
#include "app/results/vessel_csv.hpp"
#include "sph3d/fields/point_weights.hpp"

namespace ostium::app {

/// What the series go on from. Bytes: 0 where there was no such file.
struct SavedVesselSeries {
  Thinning rows;
  std::int64_t wall_bytes = 0, probes_bytes = 0;
};
void archive(Archive& a, SavedVesselSeries& saved);

template <int D>
class VesselSeries {
 public:
  /// The sampler is this vessel's, shared with others. With `saved` the files are cut back to what they were
  /// and continued.
  VesselSeries(const OutputCase& output, std::vector<Probe<D>> probes, const std::filesystem::path& results,
               const sph3d::Vessel<D>& vessel, sph3d::WallSampler<D>& sampler,
               const SavedVesselSeries* saved);
  /// After every step.
  void follow(const sph3d::Vessel<D>& vessel);
  void flush();
  SavedVesselSeries save();

 private:
  WallRow<D> wall_row(const sph3d::Vessel<D>& vessel) const;
  ProbeRow<D> in_blood(const sph3d::Vessel<D>& vessel, const Probe<D>& probe) const;
  ProbeRow<D> on_wall(const sph3d::Vessel<D>& vessel, std::size_t probe) const;

  double from_;
  Thinning rows_;
  std::vector<Probe<D>> probes_;
  sph3d::WallSampler<D>& sampler_;
  sph3d::PointWeights weights_;  // of the wall points, for every probe
  WallCsv<D> wall_;
  std::optional<ProbesCsv<D>> probes_csv_;
};

}  // namespace ostium::app
