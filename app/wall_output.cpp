#include "app/wall_output.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/log.hpp"
#include "sph3d/fields/structure_fields.hpp"
#include "sph3d/fields/wall_gradient.hpp"
#include "sph3d/io/fields.hpp"
#include "sph3d/shell/lateral.hpp"
#include "sph3d/walls/smallest_rotation.hpp"

namespace ostium::app {

namespace {

/// Fields at the wall points and the same on the input surface.
template <int D>
class WallAndSurface {
 public:
  explicit WallAndSurface(const sph3d::SurfaceMap<D>& map) : map_(map) {}

  template <class T>
  void add(const std::string& name, const std::vector<T>& values) {
    wall.push_back(field_of(name, values));
    surface.push_back(field_of(name, map_(values)));
  }
  void write(const std::filesystem::path& wall_file, const std::vector<sph3d::WallPoint<D>>& points,
             const std::filesystem::path& surface_file, const sph3d::Surface<D>& moved) {
    std::vector<Vec<D>> position, normal;
    std::vector<double> area;
    for (const auto& p : points)
      position.push_back(p.position), normal.push_back(p.normal), area.push_back(p.area);
    wall.push_back(field_of("area", area));
    wall.push_back(field_of("normal", normal));
    sph3d::write_particles_vtp<D>(wall_file, position, wall);
    sph3d::write_surface_vtp<D>(surface_file, moved, surface);
  }

 private:
  static sph3d::Field field_of(const std::string& name, const std::vector<double>& values) {
    return sph3d::field(name, values);
  }
  template <int N>
  static sph3d::Field field_of(const std::string& name, const std::vector<Vec<N>>& values) {
    return sph3d::field<N>(name, values);
  }

  const sph3d::SurfaceMap<D>& map_;
  std::vector<sph3d::Field> wall, surface;
};

}  // namespace

template <int D>
WallOutput<D>::WallOutput(const std::filesystem::path& folder, const sph3d::Vessel<D>& vessel,
                          sph3d::WallSampler<D>& sampler, double period, double end)
    : folder_(folder),
      period_(period),
      end_(end),
      filter_((period > 0.0 ? period : end) / (2.0 * pi * 20.0)),
      interval_(filter_ / 4.0),
      sampler_(sampler),
      map_(vessel.model().lumen.surface, sampler_.at_rest(), vessel.model().kernel.h),
      wall_(folder / "wall.pvd"),
      surface_(folder / "surface.pvd"),
      cycles_wall_(folder / "cycles_wall.pvd"),
      cycles_surface_(folder / "cycles_surface.pvd") {}

template <int D>
void WallOutput<D>::resume(const SavedWall<D>& saved, double time) {
  cycle_ = saved.cycle, agreement_ = saved.agreement;
  for (auto* series : {&wall_, &surface_, &cycles_wall_, &cycles_surface_}) series->resume(time);
}

template <int D>
void WallOutput<D>::follow(const sph3d::Vessel<D>& vessel) {
  const double t = vessel.time();
  if (!cycle_.stress.empty() && t < cycle_.time + interval_ && !sph3d::ends(cycle_, t, period_)) return;
  sampler_.sample(vessel);
  write_cycle(take_sample(vessel));
  compare(vessel);
}

/// The stress in the frame of the material.
template <int D>
sph3d::CycleFields<D> WallOutput<D>::take_sample(const sph3d::Vessel<D>& vessel) {
  const auto& loads = sampler_.loads();
  const auto& rest = sampler_.at_rest();
  const auto& now = sampler_.points();
  if (!vessel.wall())
    return sph3d::take(cycle_, vessel.time(), loads.shear_stress, loads.pressure, period_, filter_);
  std::vector<Vec<D>> at_rest(rest.size());
#pragma omp parallel for schedule(static)
  for (std::size_t a = 0; a < rest.size(); ++a)
    at_rest[a] = sph3d::smallest_rotation<D>(now[a].normal, rest[a].normal) * loads.shear_stress[a];
  return sph3d::take(cycle_, vessel.time(), at_rest, loads.pressure, period_, filter_);
}

/// Thirty-two times in a cycle; where the run is one cycle, in its second half, when the start is over.
template <int D>
void WallOutput<D>::compare(const sph3d::Vessel<D>& vessel) {
  const double t = vessel.time(), gap = (period_ > 0.0 ? period_ : 0.5 * end_) / 32.0;
  if (t < agreement_.time + gap || (period_ <= 0.0 && t < 0.5 * end_)) return;
  sph3d::take<D>(agreement_, cycle_.number, t, cycle_.stress,
                 sph3d::shear_stress_from_gradient(vessel, sampler_.points()));
}

template <int D>
void WallOutput<D>::write(const sph3d::Vessel<D>& vessel, const std::string& number) {
  sampler_.sample(vessel);
  const auto& rest = sampler_.at_rest();
  const auto& now = sampler_.points();
  WallAndSurface<D> fields(map_);
  fields.add("pressure", sampler_.loads().pressure);
  fields.add("wall_shear_stress", sampler_.loads().shear_stress);
  fields.add("wall_shear_stress_gradient", sph3d::shear_stress_from_gradient(vessel, now));
  if (vessel.wall()) {
    std::vector<Vec<D>> displacement;
    for (std::size_t a = 0; a < now.size(); ++a) displacement.push_back(now[a].position - rest[a].position);
    fields.add("displacement", displacement);
    const auto structure = sph3d::structure_fields(*vessel.wall(), vessel.state().wall);
    for (const auto& [name, depth] :
         {std::pair("inner", &structure.inner), {"middle", &structure.middle}, {"outer", &structure.outer}}) {
      fields.add(std::string("stress_") + name, depth->stress);
      fields.add(std::string("von_mises_") + name, depth->von_mises);
    }
    fields.add("strain_energy", structure.energy);
  }
  const auto wall = folder_ / ("wall_" + number + ".vtp"), surface = folder_ / ("surface_" + number + ".vtp");
  fields.write(wall, now, surface, map_.moved(rest, now));
  wall_.add(vessel.time(), wall);
  surface_.add(vessel.time(), surface);
}

/// A cycle that was not seen from its beginning is not written.
template <int D>
void WallOutput<D>::write_cycle(const sph3d::CycleFields<D>& cycle) {
  if (cycle.number < 0 || cycle.duration < 0.999 * period_) return;
  const auto& rest = sampler_.at_rest();
  const auto& now = sampler_.points();
  std::vector<Vec<D>> stress(now.size());
  std::vector<double> osi(now.size()), rrt(now.size());
  for (std::size_t a = 0; a < now.size(); ++a) {
    stress[a] = sph3d::smallest_rotation<D>(rest[a].normal, now[a].normal) * cycle.mean_stress[a];
    osi[a] = cycle.osi(a), rrt[a] = cycle.rrt(a);
  }
  WallAndSurface<D> fields(map_);
  fields.add("tawss", cycle.tawss);
  fields.add("osi", osi);
  fields.add("rrt", rrt);
  fields.add("mean_wall_shear_stress", stress);
  fields.add("mean_pressure", cycle.mean_pressure);
  const std::string name = fmt::format("cycle_{:03d}_", cycle.number + 1);
  const auto wall = folder_ / (name + "wall.vtp"), surface = folder_ / (name + "surface.vtp");
  fields.write(wall, now, surface, map_.moved(rest, now));
  const double end = period_ > 0.0 ? static_cast<double>(cycle.number + 1) * period_ : cycle.duration;
  cycles_wall_.add(end, wall);
  cycles_surface_.add(end, surface);
}

template <int D>
void WallOutput<D>::finish() {
  if (period_ <= 0.0 && cycle_.duration > 0.0) write_cycle(sph3d::fields_of(cycle_));
}

template <int D>
void WallOutput<D>::judge(double spacing) const {
  constexpr double large_part = 1.0 / 3.0, least = 0.5, most = 0.8;  // of the wall; of the spacing
  const auto& rest = sampler_.at_rest();
  const bool whole = agreement_.whole.count > 0;
  if (!whole && period_ > 0.0) return;  // no cycle from beginning to end
  const auto d = sph3d::disagreement<D>(whole ? agreement_.whole : agreement_.running, rest);
  if (d.share < large_part) return;
  log::warn(
      "the flow beside the wall is not resolved: on {:.0f} % of the wall its shear stress by the forces "
      "differs by more than "
      "a tenth from that by the velocity gradient, most {}, {:.3g} and {:.3g} Pa; for wall shear stress set "
      "vessel.spacing "
      "to {:.2g} mm or less",
      100 * d.share, sph3d::place<D>(rest[d.worst].position), d.forces, d.gradient,
      1e3 * spacing * std::clamp(0.1 / d.median, least, most));
}

template class WallOutput<2>;
template class WallOutput<3>;

}  // namespace ostium::app
