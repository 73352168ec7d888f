#include "app/fields_output.hpp"

#include <fmt/format.h>

#include "sph3d/io/fields.hpp"

namespace ostium::app {

template <int D>
void archive(Archive& a, SavedFields<D>& saved) {
  a.part("thinning", [&] { saved.thinning.archive(a); });
  a.part("cycle", [&] { archive(a, saved.wall.cycle); });
  a.part("agreement", [&] { archive(a, saved.wall.agreement); });
}

template <int D>
FieldsOutput<D>::FieldsOutput(const std::filesystem::path& results, const sph3d::Vessel<D>& vessel,
                              sph3d::WallSampler<D>& sampler, const FieldsTimes& times)
    : folder_(results / "fields"), thinning_(times.every), fluid_(folder_ / "fluid.pvd") {
  if (times.every <= 0.0) return;
  std::filesystem::create_directories(folder_);
  wall_.emplace(folder_, vessel, sampler, times.period, times.end);
}

template <int D>
SavedFields<D> FieldsOutput<D>::save() const {
  return {thinning_, wall_ ? wall_->save() : SavedWall<D>()};
}

template <int D>
void FieldsOutput<D>::resume(const SavedFields<D>& saved, double time) {
  const double until = time * (1.0 + 1e-9);  // the series has its times in twelve digits
  thinning_.go_on(saved.thinning);
  fluid_.resume(until);
  if (wall_) wall_->resume(saved.wall, until);
}

template <int D>
void FieldsOutput<D>::follow(const sph3d::Vessel<D>& vessel) {
  if (!wall_) return;
  wall_->follow(vessel);
  if (!thinning_.due(vessel.time())) return;
  const std::string number = fmt::format("{:05d}", fluid_.size());
  const auto fluid = folder_ / ("fluid_" + number + ".vtp");
  write_fluid(vessel, fluid);
  wall_->write(vessel, number);
  fluid_.add(vessel.time(), fluid);
}

template <int D>
void FieldsOutput<D>::finish() {
  if (wall_) wall_->finish();
}

template <int D>
void FieldsOutput<D>::judge(double spacing) const {
  if (wall_) wall_->judge(spacing);
}

template <int D>
void FieldsOutput<D>::write_fluid(const sph3d::Vessel<D>& vessel, const std::filesystem::path& file) const {
  const auto& fluid = vessel.state().fluid;
  const auto& ducts = vessel.model().ducts;
  const auto& o = vessel.model().options;
  std::vector<Vec<D>> points, velocity;
  std::vector<double> pressure, deviation;
  for (std::size_t i = 0; i < fluid.places(); ++i) {
    if (!fluid.filled[i]) continue;
    const auto& x = fluid.position[i];
    if (std::any_of(ducts.begin(), ducts.end(), [&](const auto& duct) { return duct.holds(x); })) continue;
    points.push_back(x);
    velocity.push_back(fluid.velocity(i));
    deviation.push_back(fluid.psi(i));
    pressure.push_back(o.density * o.sound_speed * o.sound_speed * fluid.psi(i) +
                       vessel.state().datum.reference);
  }
  const std::vector<sph3d::Field> fields{sph3d::field<D>("velocity", velocity),
                                         sph3d::field("pressure", pressure),
                                         sph3d::field("density_deviation", deviation)};
  sph3d::write_particles_vtp<D>(file, points, fields);
}

template void archive(Archive&, SavedFields<2>&);
template void archive(Archive&, SavedFields<3>&);
template class FieldsOutput<2>;
template class FieldsOutput<3>;

}  // namespace ostium::app
