#include "app/vessel_output.hpp"

namespace ostium::app {

template <int D>
void archive(Archive& a, SavedVesselOutput<D>& saved) {
  a.part("fields", [&] { archive(a, saved.fields); });
  a.part("series", [&] { archive(a, saved.series); });
}

namespace {

FieldsTimes times_of(const Case& study) {
  const double end = study.time.final(), period = study.time.period.value_or(0.0);
  return {.every = study.output.fields_every.value_or(study.time.period.value_or(end) / 10.0),
          .period = period,
          .end = end};
}

}  // namespace

template <int D>
VesselOutput<D>::VesselOutput(const Case& study, const std::vector<Probe<D>>& probes,
                              const std::filesystem::path& results, const sph3d::Vessel<D>& vessel,
                              const SavedVesselOutput<D>* saved)
    : sampler_(vessel),
      fields_(results, vessel, sampler_, times_of(study)),
      series_(study.output, probes, results, vessel, sampler_, saved ? &saved->series : nullptr) {
  if (saved) fields_.resume(saved->fields, vessel.time());
}

template <int D>
void VesselOutput<D>::follow(const sph3d::Vessel<D>& vessel) {
  series_.follow(vessel);
  fields_.follow(vessel);
}

template <int D>
void VesselOutput<D>::finish() {
  series_.flush();
  fields_.finish();
}

template void archive(Archive&, SavedVesselOutput<2>&);
template void archive(Archive&, SavedVesselOutput<3>&);
template class VesselOutput<2>;
template class VesselOutput<3>;

}  // namespace ostium::app
