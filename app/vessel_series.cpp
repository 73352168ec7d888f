#include "app/vessel_series.hpp"

#include "sph3d/fields/blood_probe.hpp"
#include "sph3d/fields/structure_fields.hpp"

namespace ostium::app {

void archive(Archive& a, SavedVesselSeries& saved) {
  a.part("rows", [&] { saved.rows.archive(a); });
  a("wall_bytes", saved.wall_bytes);
  a("probes_bytes", saved.probes_bytes);
}

namespace {

/// A file that was not there is begun now.
Keep keep(const SavedVesselSeries* saved, std::int64_t SavedVesselSeries::*bytes) {
  return saved && saved->*bytes > 0 ? Keep(static_cast<std::uintmax_t>(saved->*bytes)) : Keep();
}

template <int D>
sph3d::PointWeights weights_of(const std::vector<Probe<D>>& probes, const sph3d::WallSampler<D>& sampler,
                               double h) {
  std::vector<Vec<D>> at, normal;
  for (const auto& probe : probes) at.push_back(probe.at), normal.push_back(probe.normal);
  return sph3d::mapping_weights(sampler.at_rest(), at, normal, h);
}

}  // namespace

template <int D>
VesselSeries<D>::VesselSeries(const OutputCase& output, std::vector<Probe<D>> probes,
                              const std::filesystem::path& results, const sph3d::Vessel<D>& vessel,
                              sph3d::WallSampler<D>& sampler, const SavedVesselSeries* saved)
    : from_(output.from),
      rows_(output.every),
      probes_(std::move(probes)),
      sampler_(sampler),
      weights_(weights_of(probes_, sampler, vessel.model().kernel.h)),
      wall_(results / "wall.csv", vessel.wall() != nullptr, keep(saved, &SavedVesselSeries::wall_bytes)) {
  if (!probes_.empty())
    probes_csv_.emplace(results / "probes.csv", keep(saved, &SavedVesselSeries::probes_bytes));
  if (saved) rows_.go_on(saved->rows);
}

template <int D>
void VesselSeries<D>::follow(const sph3d::Vessel<D>& vessel) {
  const double time = vessel.time();
  if (time < from_ * (1 - 1e-9) || !rows_.due(time)) return;
  sampler_.sample(vessel);
  wall_.row(wall_row(vessel));
  std::vector<ProbeRow<D>> rows(probes_.size());
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t k = 0; k < rows.size(); ++k)
    rows[k] = probes_[k].on_wall ? on_wall(vessel, k) : in_blood(vessel, probes_[k]);
  for (std::size_t k = 0; k < rows.size(); ++k) probes_csv_->row(time, probes_[k].name, rows[k]);
}

template <int D>
WallRow<D> VesselSeries<D>::wall_row(const sph3d::Vessel<D>& vessel) const {
  WallRow<D> row{.time = vessel.time(), .force = sph3d::wall_force(vessel, sampler_)};
  if (!vessel.wall()) return row;
  row.furthest = sph3d::furthest_displaced(sampler_.at_rest(), sampler_.points());
  row.strain_energy = sph3d::strain_energy(*vessel.wall(), vessel.state().wall);
  return row;
}

template <int D>
ProbeRow<D> VesselSeries<D>::in_blood(const sph3d::Vessel<D>& vessel, const Probe<D>& probe) const {
  ProbeRow<D> row{.position = probe.at};
  if (const auto blood = sph3d::blood_at(vessel, probe.at))
    row.velocity = blood->velocity, row.pressure = blood->pressure;
  return row;
}

template <int D>
ProbeRow<D> VesselSeries<D>::on_wall(const sph3d::Vessel<D>& vessel, std::size_t probe) const {
  const Vec<D> zero = Vec<D>::Zero();
  const auto &rest = sampler_.at_rest(), &now = sampler_.points();
  if (weights_.begin[probe] == weights_.begin[probe + 1]) return {.position = probes_[probe].at};  // a spike
  Vec<D> displacement = zero;
  for (auto n = weights_.begin[probe]; n < weights_.begin[probe + 1]; ++n) {
    const auto [a, weight] = weights_.entry[n];
    displacement += double(weight) * (now[a].position - rest[a].position);
  }
  return {.position = probes_[probe].at + displacement,
          .velocity = vessel.wall() ? weights_.at(probe, vessel.state().wall.velocity, zero) : zero,
          .pressure = weights_.at(probe, sampler_.loads().pressure, 0.0),
          .displacement = displacement,
          .shear_stress = weights_.at(probe, sampler_.loads().shear_stress, zero)};
}

template <int D>
void VesselSeries<D>::flush() {
  wall_.flush();
  if (probes_csv_) probes_csv_->flush();
}

template <int D>
SavedVesselSeries VesselSeries<D>::save() {
  SavedVesselSeries saved{.rows = rows_, .wall_bytes = static_cast<std::int64_t>(wall_.bytes())};
  if (probes_csv_) saved.probes_bytes = static_cast<std::int64_t>(probes_csv_->bytes());
  return saved;
}

template class VesselSeries<2>;
template class VesselSeries<3>;

}  // namespace ostium::app
