/// What a run writes of the vessel itself: the fields for ParaView, and the series of wall and probes. They
/// share the wall sampler.
#pragma once
#include "app/fields_output.hpp"
#include "app/vessel_series.hpp"

namespace ostium::app {

template <int D>
struct SavedVesselOutput {
  SavedFields<D> fields;
  SavedVesselSeries series;
};

template <int D>
void archive(Archive& a, SavedVesselOutput<D>& saved);

template <int D>
class VesselOutput {
 public:
  /// Into the results folder; with `saved` it goes on from where the vessel stands.
  VesselOutput(const Case& study, const std::vector<Probe<D>>& probes, const std::filesystem::path& results,
               const sph3d::Vessel<D>& vessel, const SavedVesselOutput<D>* saved);
  /// After every step.
  void follow(const sph3d::Vessel<D>& vessel);
  void flush() { series_.flush(); }
  /// The run has come to its end.
  void finish();
  /// Tells the user where the flow beside the wall is not resolved.
  void judge(double spacing) const { fields_.judge(spacing); }
  SavedVesselOutput<D> save() { return {fields_.save(), series_.save()}; }

 private:
  sph3d::WallSampler<D> sampler_;
  FieldsOutput<D> fields_;
  VesselSeries<D> series_;
};

}  // namespace ostium::app
