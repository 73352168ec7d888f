#include "app/fields_output.hpp"

#include <fmt/format.h>

#include "sph3d/io/fields.hpp"

namespace ostium::app {

template <int D>
FieldsOutput<D>::FieldsOutput(const std::filesystem::path& results, const sph3d::Model<D>& model,
                              double every)
    : folder_(results / "fields"),
      on_(every > 0.0),
      thinning_(every),
      fluid_(folder_ / "fluid.pvd"),
      wall_(folder_ / "wall.pvd"),
      surface_(folder_ / "surface.pvd") {
  if (!on_) return;
  std::filesystem::create_directories(folder_);
  wall_points_ = sph3d::sample_wall(model.lumen, model.options.dp);
}

template <int D>
void FieldsOutput<D>::resume(const Thinning& saved, double time) {
  thinning_.go_on(saved);
  for (auto* series : {&fluid_, &wall_, &surface_})
    series->resume(time * (1.0 + 1e-9));  // the series has its times in twelve digits
}

template <int D>
void FieldsOutput<D>::write_if_due(const sph3d::Vessel<D>& vessel) {
  if (!on_ || !thinning_.due(vessel.time())) return;
  const std::string number = fmt::format("{:05d}.vtp", fluid_.size());
  const auto fluid = folder_ / ("fluid_" + number), wall = folder_ / ("wall_" + number),
             surface = folder_ / ("surface_" + number);
  write_fluid(vessel, fluid);
  write_wall(vessel, wall, surface);
  fluid_.add(vessel.time(), fluid);
  wall_.add(vessel.time(), wall);
  surface_.add(vessel.time(), surface);
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

template <int D>
void FieldsOutput<D>::write_wall(const sph3d::Vessel<D>& vessel, const std::filesystem::path& file,
                                 const std::filesystem::path& surface_file) const {
  const auto loads = sph3d::wall_loads(vessel, wall_points_);
  std::vector<Vec<D>> points;
  std::vector<double> area;
  for (const auto& point : wall_points_) points.push_back(point.position), area.push_back(point.area);
  const std::vector<sph3d::Field> fields{sph3d::field("pressure", loads.pressure),
                                         sph3d::field<D>("wall_shear_stress", loads.shear_stress),
                                         sph3d::field("area", area)};
  sph3d::write_particles_vtp<D>(file, points, fields);
  const auto mapped = sph3d::mapped_to_surface(vessel.model(), wall_points_, loads);
  const std::vector<sph3d::Field> corners{sph3d::field("pressure", mapped.pressure),
                                          sph3d::field<D>("wall_shear_stress", mapped.shear_stress)};
  sph3d::write_surface_vtp<D>(surface_file, vessel.model().lumen.surface, corners);
}

template class FieldsOutput<2>;
template class FieldsOutput<3>;

}  // namespace ostium::app
